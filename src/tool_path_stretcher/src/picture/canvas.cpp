// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "scan_cell_common/errors/errors.h"

namespace tool_path_stretcher {

View View::from(double azimuth, double elevation) {
  const Eigen::Vector3d eye(std::cos(elevation) * std::cos(azimuth),
                            std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Eigen::Vector3d right(-std::sin(azimuth), std::cos(azimuth), 0);
  View view;
  view.axes.row(0) = right;
  view.axes.row(1) = eye.cross(right);
  view.axes.row(2) = eye;
  return view;
}

Canvas::Canvas(int width, int height)
    : image_(kFiner * height, kFiner * width, CV_8UC3, cv::Scalar::all(255)),
      depth_(image_.rows, image_.cols, CV_32F,
             cv::Scalar(-std::numeric_limits<float>::infinity())) {}

int Canvas::width() const {
  return image_.cols / kFiner;
}

int Canvas::height() const {
  return image_.rows / kFiner;
}

void Canvas::fit(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int top_margin,
                 int margin) {
  const Eigen::Vector2d extent = (high - low).head<2>().cwiseMax(1e-9);
  const Eigen::Vector2d room(image_.cols - 2 * kFiner * margin,
                             image_.rows - kFiner * (margin + top_margin));
  scale_ = room.cwiseQuotient(extent).minCoeff();
  const Eigen::Vector2d middle = (low + high).head<2>() / 2;
  const Eigen::Vector2d centre(image_.cols / 2.0, kFiner * top_margin + room.y() / 2);
  origin_ = centre - scale_ * Eigen::Vector2d(middle.x(), -middle.y());
  scale_ = scale_ / kFiner;
}

Eigen::Vector2d Canvas::place_of(const Eigen::Vector3d& at) const {
  return origin_ + kFiner * scale_ * Eigen::Vector2d(at.x(), -at.y());
}

void Canvas::dot(const Eigen::Vector3d& at, double radius, const cv::Vec3b& colour, double lift) {
  const Eigen::Vector2d place = place_of(at);
  const double reach = kFiner * radius;
  const auto nearness = static_cast<float>(at.z() + lift);
  const int first_row = std::max(0, static_cast<int>(std::ceil(place.y() - reach)));
  const int last_row = std::min(image_.rows - 1, static_cast<int>(place.y() + reach));
  const int first_column = std::max(0, static_cast<int>(std::ceil(place.x() - reach)));
  const int last_column = std::min(image_.cols - 1, static_cast<int>(place.x() + reach));
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      if (std::hypot(row - place.y(), column - place.x()) > reach) continue;
      if (depth_.at<float>(row, column) > nearness) continue;
      depth_.at<float>(row, column) = nearness;
      image_.at<cv::Vec3b>(row, column) = colour;
    }
  }
}

void Canvas::line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const cv::Vec3b& colour) {
  const Eigen::Vector2d start = place_of(from);
  const Eigen::Vector2d end = place_of(to);
  cv::line(image_, cv::Point2d(start.x(), start.y()), cv::Point2d(end.x(), end.y()), colour, 2,
           cv::LINE_AA);
}

void Canvas::text(const std::string& words, int x, int y, double height, const cv::Vec3b& colour) {
  constexpr double kCapHeight = 22;  // pixels at scale 1
  cv::putText(image_, words, {kFiner * x, kFiner * y}, cv::FONT_HERSHEY_DUPLEX,
              kFiner * height / kCapHeight, colour, 1, cv::LINE_AA);
}

void Canvas::bar(int x, int y, int width, int height, const cv::Vec3b& colour) {
  cv::rectangle(image_, cv::Rect(kFiner * x, kFiner * y, kFiner * width, kFiner * height), colour,
                cv::FILLED);
}

void Canvas::save(const std::string& path) const {
  cv::Mat reduced;
  cv::resize(image_, reduced, {}, 1.0 / kFiner, 1.0 / kFiner, cv::INTER_AREA);
  bool written = false;
  try {
    written = cv::imwrite(path, reduced, {cv::IMWRITE_PNG_COMPRESSION, 9});
  } catch (const cv::Exception&) {
    written = false;  // an extension that OpenCV does not know
  }
  if (!written) {
    throw scan_cell_common::FileError(
        path, "cannot be written", "give a folder that you may write to and a name ending in .png");
  }
}

cv::Vec3b heat(double value) {
  static const cv::Mat colours = [] {
    cv::Mat values(256, 1, CV_8U);
    for (int i = 0; i < 256; ++i)
      values.at<uchar>(i) = static_cast<uchar>(i);
    cv::Mat result;
    cv::applyColorMap(values, result, cv::COLORMAP_VIRIDIS);
    return result;
  }();
  return colours.at<cv::Vec3b>(static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0))));
}

}  // namespace tool_path_stretcher
