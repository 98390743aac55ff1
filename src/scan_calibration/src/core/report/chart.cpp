// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "report/chart.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace scan_calibration {
namespace {

constexpr int kLeft = 62, kRight = 12, kTop = 12, kBottom = 44;  // [px] margins for the numbers

/// Numbers along a side: multiples of 1, 2 or 5 times a power of ten, at most six.
template <class Mark>
void ticks(const Chart::Side& side, const Mark& mark) {
  const auto [first, last] = std::minmax(side.from, side.to);
  const double rough = std::max(last - first, 1e-12) / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= rough) step = factor * power;
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  for (double i = std::ceil(first / step - 1e-9) + 0.0; i * step <= last + 1e-9 * step; ++i)
    mark((i * step - side.from) / (side.to - side.from), fmt::format("{:.{}f}", i * step, digits));
}

}  // namespace

Chart::Chart(int width, int height, const Side& across, const Side& upwards)
    : width_(width - kLeft - kRight),
      height_(height - kTop - kBottom),
      across_(across),
      upwards_(upwards) {}

std::string Chart::at(const Eigen::Vector2d& place) const {
  const double x = (place.x() - across_.from) / (across_.to - across_.from);
  const double y = (place.y() - upwards_.from) / (upwards_.to - upwards_.from);
  return fmt::format("{:.1f} {:.1f}", x * width_, (1 - y) * height_);
}

std::string Chart::path(const Places& corners) const {
  std::string text;
  for (const Eigen::Vector2d& corner : corners)
    text += (text.empty() ? "M" : "L") + at(corner);
  return text + "Z";
}

void Chart::dots(const Places& places, const std::string& colour, double radius) {
  std::string text;
  for (const Eigen::Vector2d& place : places)
    text += "M" + at(place) + "h0";
  shapes_ +=
      fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"/>\n",
                  text, colour, 2 * radius);
}

void Chart::lines(const Places& ends, const std::string& colour, double width) {
  std::string text;
  for (std::size_t i = 0; i < ends.size(); ++i)
    text += (i % 2 == 0 ? "M" : "L") + at(ends[i]);
  shapes_ +=
      fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", text, colour, width);
}

void Chart::outline(const Places& corners, const std::string& colour) {
  shapes_ += fmt::format("<path d=\"{}\" stroke=\"{}\" fill=\"none\"/>\n", path(corners), colour);
}

void Chart::fill(const Places& corners, const std::string& colour) {
  shapes_ += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path(corners), colour);
}

std::string Chart::svg() const {
  const double right = kLeft + width_, bottom = kTop + height_;
  std::string text = fmt::format(
      "<svg viewBox=\"0 0 {} {}\" width=\"{}\" font-size=\"12\">\n"
      "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n{}</svg>\n"
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#333\"/>\n",
      right + kRight, bottom + kBottom, right + kRight, kLeft, kTop, width_, height_, shapes_,
      kLeft, kTop, width_, height_);
  const auto put = [&](const std::string& words, double x, double y, const char* anchor) {
    text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                        anchor, words);
  };
  const auto mark = [&](const std::string& path) {
    text += fmt::format("<path d=\"{}\" stroke=\"#333\"/>\n", path);
  };
  ticks(across_, [&](double share, const std::string& number) {
    const double x = kLeft + share * width_;
    mark(fmt::format("M{:.1f} {}v4", x, bottom));
    put(number, x, bottom + 17, "middle");
  });
  ticks(upwards_, [&](double share, const std::string& number) {
    const double y = bottom - share * height_;
    mark(fmt::format("M{} {:.1f}h-4", kLeft, y));
    put(number, kLeft - 7, y + 4, "end");
  });
  put(across_.label, kLeft + width_ / 2, bottom + 36, "middle");
  put(upwards_.label, kLeft + 6, kTop + 16, "start");
  return text + "</svg>\n";
}

std::string colour_of(std::size_t index, std::size_t count) {
  return fmt::format("hsl({},65%,45%)", 300 * index / std::max<std::size_t>(count, 1));
}

std::string colour_between(double value) {
  const double share = std::round(5 * std::clamp(value, -1.0, 1.0)) / 5;
  const Eigen::Vector3d grey(190, 190, 190), blue(20, 80, 200), red(210, 30, 30);
  const Eigen::Vector3d colour =
      grey * (1 - std::abs(share)) + (share < 0 ? blue : red) * std::abs(share);
  return fmt::format("rgb({:.0f},{:.0f},{:.0f})", colour[0], colour[1], colour[2]);
}

}  // namespace scan_calibration
