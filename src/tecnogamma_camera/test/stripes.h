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
  double height;  // [grey value] above the background; above 255: saturated
};

class Image {
 public:
  Image(int columns, int rows, double background = 0)
      : columns_(columns), light_(static_cast<std::size_t>(columns) * rows, background) {}

  void add(int row, const Stripe& stripe) {
    for (int column = 0; column < columns_; ++column)
      light_[row * columns_ + column] +=
          stripe.height * gaussian_pixel(column, stripe.centre, stripe.sigma);
  }

  void add_noise(double sigma, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0, sigma);
    for (double& light : light_)
      light += noise(engine);
  }

  /// The pixels live as long as this image.
  tecnogamma_camera::ImageView8 view() {
    pixels_.resize(light_.size());
    std::transform(light_.begin(), light_.end(), pixels_.begin(), [](double light) {
      return static_cast<std::uint8_t>(std::lround(std::clamp(light, 0.0, 255.0)));
    });
    tecnogamma_camera::ImageView8 result;
    result.pixels = pixels_.data();
    result.columns = columns_;
    result.rows = static_cast<int>(light_.size()) / columns_;
    result.stride = columns_;
    return result;
  }

 private:
  int columns_;
  std::vector<double> light_;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace stripes
