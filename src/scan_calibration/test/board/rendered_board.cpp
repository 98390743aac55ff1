// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "board/rendered_board.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

using Eigen::Vector2d;
using Eigen::Vector3d;
using scan_calibration::Board;

namespace {

/// What a ray meets: its share of the room's light, and its reflectance for the laser.
struct Surface {
  double grey;
  double whiteness;
  double depth;  //!< [m] along the ray (x/z, y/z, 1)
};

Surface meet(const RenderedScene& scene, const Eigen::Isometry3d& board_in_camera,
             const Vector3d& ray) {
  const Vector3d normal = board_in_camera.linear().col(2);
  const double slope = normal.dot(ray);
  double depth = normal.dot(board_in_camera.translation()) / slope;
  const Vector3d on_board =
      board_in_camera.linear().transpose() * (depth * ray - board_in_camera.translation());
  const Board& board = scene.board;
  const double u = on_board.x() / board.square_size, v = on_board.y() / board.square_size;
  const double margin = scene.plate_margin / board.square_size;
  if (u < -1 - margin || u > board.columns + margin || v < -1 - margin || v > board.rows + margin) {
    depth += scene.plate_height / slope;
    return {scene.table, scene.table / scene.white, depth};
  }
  const bool inside = u >= -1 && u < board.columns && v >= -1 && v < board.rows;
  const auto square = static_cast<long>(std::floor(u)) + static_cast<long>(std::floor(v));
  const bool dark = inside && square % 2 != 0;
  return {dark ? scene.black : scene.white, dark ? scene.black / scene.white : 1, depth};
}

double light_of(const RenderedScene& scene, const Eigen::Isometry3d& board_in_camera,
                const Vector3d& ray) {
  const Surface surface = meet(scene, board_in_camera, ray);
  double light = scene.room_light * surface.grey;
  if (scene.laser_light > 0) {
    const double off =
        (scene.laser.normal.dot(surface.depth * ray) - scene.laser.distance) / scene.line_sigma;
    light += scene.laser_light * surface.whiteness * std::exp(-0.5 * off * off);
  }
  return light;
}

/// Places in a pixel, about its centre. No two lie in one row, column or diagonal: a grid of places
/// would shift an edge that is parallel to it (R2 sequence, Roberts 2018).
std::vector<Vector2d> places_in_pixel(int count) {
  std::vector<Vector2d> places;
  Vector2d mean = Vector2d::Zero();
  for (int i = 0; i < count; ++i) {
    places.emplace_back(std::fmod(0.7548776662466927 * i, 1), std::fmod(0.5698402909980532 * i, 1));
    mean += places.back() / count;
  }
  for (Vector2d& place : places)
    place -= mean;
  return places;
}

}  // namespace

BoardRenderer::BoardRenderer(const scan_cell_common::CameraIntrinsics& camera, int samples)
    : camera_(camera), samples_(samples) {
  rays_.reserve(static_cast<std::size_t>(camera.width) * camera.height * samples * samples);
  const std::vector<Vector2d> places = places_in_pixel(samples * samples);
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      for (const Vector2d& place : places) {
        const Vector2d distorted((column + place.x() - camera.cx) / camera.fx,
                                 (row + place.y() - camera.cy) / camera.fy);
        Vector2d ray = distorted;
        camera.undistort(distorted, ray);
        rays_.push_back(ray.cast<float>());
      }
    }
  }
}

cv::Mat BoardRenderer::render(const RenderedScene& scene, const Eigen::Isometry3d& board_in_camera,
                              std::uint32_t seed) const {
  cv::Mat light(camera_.height, camera_.width, CV_32F);
  const int count = samples_ * samples_;
  auto ray = rays_.begin();
  for (int i = 0; i < camera_.height * camera_.width; ++i) {
    double sum = 0;
    for (int sample = 0; sample < count; ++sample, ++ray)
      sum += light_of(scene, board_in_camera, Vector3d(ray->x(), ray->y(), 1));
    light.at<float>(i / camera_.width, i % camera_.width) = static_cast<float>(sum / count);
  }
  cv::GaussianBlur(light, light, cv::Size(), scene.blur);
  cv::Mat noise(light.size(), CV_32F);
  cv::RNG engine(seed);
  engine.fill(noise, cv::RNG::NORMAL, 0, scene.noise);
  cv::Mat image;
  cv::Mat(light + noise).convertTo(image, CV_8U);
  return image;
}

Eigen::Isometry3d board_pose(const Board& board, const Vector3d& centre, double tilt,
                             double towards, double turn) {
  const Vector3d middle(0.5 * (board.columns - 1) * board.square_size,
                        0.5 * (board.rows - 1) * board.square_size, 0);
  return Eigen::Translation3d(centre) *
         Eigen::AngleAxisd(tilt, Vector3d(std::cos(towards), std::sin(towards), 0)) *
         Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * Eigen::Translation3d(-middle);
}

Vector2d true_corner(const scan_cell_common::CameraIntrinsics& camera,
                     const Eigen::Isometry3d& board_in_camera, const Board& board, int column,
                     int row) {
  return camera.project(board_in_camera *
                        Vector3d(column * board.square_size, row * board.square_size, 0));
}
