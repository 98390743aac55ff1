// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tecnogamma_camera/image_view.h"

/// Grey images of laser stripes in closed form.
namespace stripes {

/// Light that a pixel collects from a Gaussian stripe: its profile integrated over the pixel.
inline double gaussian_pixel(int column, double centre, double sigma) {
  const double scale = 1 / (sigma * std::sqrt(2.0));
  const double integral =
      0.5 * (std::erf((column + 0.5 - centre) * scale) - std::erf((column - 0.5 - centre) * scale));
  return integral * sigma * std::sqrt(2 * M_PI);  // 1 in the middle of a wide stripe
}

struct Stripe {
  double centre;
  double sigma;
  double height;  // [grey value] above the background; above the greatest: saturated
};

class Image {
 public:
  Image(int columns, int rows, double background = 0)
      : columns_(columns), light_(static_cast<std::size_t>(columns) * rows, background) {}

  double& at(int row, int column) { return light_[row * columns_ + column]; }
  int columns() const { return columns_; }
  int rows() const { return static_cast<int>(light_.size()) / columns_; }

  void add(int row, const Stripe& stripe) {
    for (int column = 0; column < columns_; ++column)
      at(row, column) += stripe.height * gaussian_pixel(column, stripe.centre, stripe.sigma);
  }

  /// A stripe whose light seeps sideways into the material: the surface's own light, and to its
  /// right light that fades exponentially over `length`, starting at `share` of the height.
  void add_translucent(int row, const Stripe& stripe, double length, double share) {
    add(row, stripe);
    constexpr double kStep = 0.25;
    double weight = 0;
    for (double depth = 0; depth < 6 * length; depth += kStep)
      weight += std::exp(-depth / length);
    const double scale = share * length / stripe.sigma / weight;
    for (double depth = 0; depth < 6 * length; depth += kStep)
      add(row,
          {stripe.centre + depth, stripe.sigma, stripe.height * scale * std::exp(-depth / length)});
  }

  /// A stripe with speckle that a pixel averages: each pixel's light varies by a factor with a
  /// gamma distribution.
  /// @param contrast standard deviation of the factor
  void add_speckled(int row, const Stripe& stripe, double contrast, std::mt19937& engine) {
    const double shape = 1 / (contrast * contrast);
    std::gamma_distribution<double> factor(shape, 1 / shape);
    for (int column = 0; column < columns_; ++column)
      at(row, column) +=
          factor(engine) * stripe.height * gaussian_pixel(column, stripe.centre, stripe.sigma);
  }

  void add_noise(double sigma, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0, sigma);
    for (double& light : light_)
      light += noise(engine);
  }

  /// The pixels live as long as this image.
  tecnogamma_camera::ImageView8 view() { return digitise(255, pixels_); }

  /// @param bits 9 .. 16
  tecnogamma_camera::GreyImage view16(int bits) {
    return {digitise((1 << bits) - 1, pixels16_), bits};
  }

 private:
  template <class Pixel>
  tecnogamma_camera::ImageView<Pixel> digitise(double most, std::vector<Pixel>& pixels) {
    pixels.resize(light_.size());
    std::transform(light_.begin(), light_.end(), pixels.begin(), [&](double light) {
      return static_cast<Pixel>(std::lround(std::clamp(light, 0.0, most)));
    });
    return {pixels.data(), columns_, rows(), columns_, 0, 0};
  }

  int columns_;
  std::vector<double> light_;
  std::vector<std::uint8_t> pixels_;
  std::vector<std::uint16_t> pixels16_;
};

}  // namespace stripes
