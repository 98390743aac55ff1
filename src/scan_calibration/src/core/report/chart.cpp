// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "report/chart.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace scan_calibration {
namespace {

const cv::Scalar kInk(60, 60, 60);
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontSize = 0.42;
constexpr int kFine = 4;  // bits of a drawn coordinate's fraction

cv::Point fine(const cv::Point2d& place) {
  return {static_cast<int>(std::lround(place.x * (1 << kFine))),
          static_cast<int>(std::lround(place.y * (1 << kFine)))};
}

/// 1, 2 or 5 times a power of ten: about five on a side.
double step_of(double range) {
  const double rough = std::max(range, 1e-12) / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

std::string number(double value, double step) {
  char text[32];
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  std::snprintf(text, sizeof text, "%.*f", digits, std::abs(value) < 1e-9 * step ? 0 : value);
  return text;
}

}  // namespace

Chart::Chart(int width, int height, const Side& across, const Side& upwards)
    : picture_(height, width, CV_8UC3, cv::Scalar::all(255)),
      across_(across),
      upwards_(upwards),
      inside_(62, 12, width - 74, height - 56) {}

cv::Point2d Chart::at(const Eigen::Vector2d& place) const {
  const auto bounded = [](double value) { return std::clamp(value, -2.0, 3.0); };
  const double x = bounded((place.x() - across_.from) / (across_.to - across_.from));
  const double y = bounded((place.y() - upwards_.from) / (upwards_.to - upwards_.from));
  return {inside_.x + x * inside_.width, inside_.y + (1 - y) * inside_.height};
}

double Chart::scale() const {
  return inside_.width / std::abs(across_.to - across_.from);
}

void Chart::dot(const Eigen::Vector2d& place, const cv::Scalar& colour, double radius) {
  cv::circle(picture_, fine(at(place)), static_cast<int>(radius * (1 << kFine)), colour, cv::FILLED,
             cv::LINE_AA, kFine);
}

void Chart::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const cv::Scalar& colour,
                 int thickness) {
  cv::line(picture_, fine(at(from)), fine(at(to)), colour, thickness, cv::LINE_AA, kFine);
}

void Chart::fill(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const cv::Scalar& colour) {
  cv::rectangle(picture_, fine(at(from)), fine(at(to)), colour, cv::FILLED, cv::LINE_8, kFine);
}

void Chart::outline(const std::vector<Eigen::Vector2d>& corners, const cv::Scalar& colour) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    line(corners[i], corners[(i + 1) % corners.size()], colour);
}

void Chart::text(const Eigen::Vector2d& place, const std::string& text) {
  cv::putText(picture_, text, at(place), kFont, kFontSize, kInk, 1, cv::LINE_AA);
}

void Chart::draw_frame() {
  const cv::Scalar paper = cv::Scalar::all(255);
  const int right = static_cast<int>(inside_.br().x), bottom = static_cast<int>(inside_.br().y);
  const int left = static_cast<int>(inside_.x), top = static_cast<int>(inside_.y);
  for (const cv::Rect& margin :
       {cv::Rect(0, 0, left, picture_.rows), cv::Rect(0, 0, picture_.cols, top),
        cv::Rect(right, 0, picture_.cols - right, picture_.rows),
        cv::Rect(0, bottom, picture_.cols, picture_.rows - bottom)})
    picture_(margin).setTo(paper);
  cv::rectangle(picture_, {left, top}, {right, bottom}, kInk);
  const auto put = [&](const std::string& text, double x, double y, double align) {
    int baseline = 0;
    const cv::Size size = cv::getTextSize(text, kFont, kFontSize, 1, &baseline);
    cv::putText(picture_, text, {static_cast<int>(x - align * size.width), static_cast<int>(y)},
                kFont, kFontSize, kInk, 1, cv::LINE_AA);
  };
  const auto ticks = [](const Side& side, const auto& mark) {
    const double least = std::min(side.from, side.to), most = std::max(side.from, side.to);
    const double step = step_of(most - least);
    for (double value = std::ceil(least / step - 1e-9) * step; value <= most + 1e-9 * step;
         value += step)
      mark(value, number(value, step));
  };
  ticks(across_, [&](double value, const std::string& text) {
    const double x = at({value, upwards_.from}).x;
    cv::line(picture_, cv::Point2d(x, bottom), cv::Point2d(x, bottom + 4), kInk);
    put(text, x, bottom + 17, 0.5);
  });
  ticks(upwards_, [&](double value, const std::string& text) {
    const double y = at({across_.from, value}).y;
    cv::line(picture_, cv::Point2d(left - 4, y), cv::Point2d(left, y), kInk);
    put(text, left - 7, y + 4, 1);
  });
  put(across_.label, 0.5 * (left + right), bottom + 36, 0.5);
  put(upwards_.label, left + 6, top + 16, 0);
}

std::string Chart::png() {
  draw_frame();
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", picture_, bytes);
  return {bytes.begin(), bytes.end()};
}

cv::Scalar colour_of(std::size_t index, std::size_t count) {
  const cv::Mat hue(1, 1, CV_8UC3,
                    cv::Scalar(150.0 * static_cast<double>(index) /
                                   static_cast<double>(std::max<std::size_t>(count, 1)),
                               200, 190));
  cv::Mat colour;
  cv::cvtColor(hue, colour, cv::COLOR_HSV2BGR);
  const auto bgr = colour.at<cv::Vec3b>(0, 0);
  return {static_cast<double>(bgr[0]), static_cast<double>(bgr[1]), static_cast<double>(bgr[2])};
}

cv::Scalar colour_between(double value) {
  const double share = std::clamp(value, -1.0, 1.0);
  const cv::Scalar grey(190, 190, 190),
      end = share < 0 ? cv::Scalar(200, 80, 20) : cv::Scalar(30, 30, 210);
  return grey * (1 - std::abs(share)) + end * std::abs(share);
}

}  // namespace scan_calibration
