// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "light/ambient_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace scan_cell_sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kCell = 8;             // [px] side of squares whose corners are checked first; chosen
constexpr double kPixelBlur = 0.65;  // [px] standard deviation, of lens and pixel; chosen

using Hit = std::optional<Scene::Hit>;
using Hits = std::vector<Hit>;

}  // namespace

/// The direction x/z, y/z of every pixel of a region, and of one row and column beyond it.
struct AmbientLight::Rays {
  Rays(const scan_cell_common::CameraIntrinsics& camera, const Region& part)
      : region(part), columns(part.width + kCell) {
    directions.reserve(static_cast<std::size_t>(columns) *
                       static_cast<std::size_t>(part.height + kCell));
    for (int row = 0; row < part.height + kCell; ++row) {
      Vector2d ray = Vector2d::Zero();
      for (int column = 0; column < columns; ++column) {
        const Vector2d distorted((part.x + column - camera.cx) / camera.fx,
                                 (part.y + row - camera.cy) / camera.fy);
        if (column == 0) ray = distorted;
        if (!camera.undistort(distorted, ray)) ray.setConstant(NAN);
        directions.push_back(ray);
        if (!ray.allFinite()) ray = distorted;
      }
    }
  }

  const Vector2d& at(int row, int column) const {
    return directions[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
  }

  Region region;
  int columns;
  std::vector<Vector2d> directions;
};

/// The reflectances seen by the pixels of one frame.
class AmbientLight::Picture {
 public:
  Picture(const Scene& scene, const Eigen::Isometry3d& camera, const Rays& rays)
      : scene_(scene), camera_(camera), rays_(rays) {
    if (!scene_.board()) return;
    const Eigen::Isometry3d in_board = scene_.board()->pose.inverse() * camera_;
    eye_ = in_board.translation();
    right_ = in_board.linear().col(0);
    down_ = in_board.linear().col(1);
    forward_ = in_board.linear().col(2);
  }

  /// What the rays through the corners of a row of cells hit, from left to right.
  Hits look_along(int row) const {
    Hits hits;
    for (int column = 0; column < rays_.region.width + kCell; column += kCell)
      hits.push_back(look(row, column));
    return hits;
  }

  /// The reflectances of a cell, row by row.
  /// @param corners hits at the cell's upper left, upper right, lower left and lower right corners
  std::array<float, kCell * kCell> cell(int row, int column,
                                        const std::array<Hit, 4>& corners) const {
    const bool flat = std::all_of(corners.begin(), corners.end(), [&corners](const Hit& hit) {
      return hit && hit->surface == corners[0]->surface &&
             hit->normal.dot(corners[0]->normal) > kFlat;
    });
    if (flat && scene_.is_on_board(*corners[0])) return cell_on_board(row, column);
    std::array<float, kCell * kCell> light{};
    for (int i = 0; i < kCell * kCell; ++i) {
      const int y = row + i / kCell, x = column + i % kCell;
      const double value = flat ? corners[0]->reflectance : seen(look(y, x), y, x);
      light[static_cast<std::size_t>(i)] = static_cast<float>(value);
    }
    return light;
  }

 private:
  static constexpr double kFlat = 1 - 1e-9;  // cosine between normals of one plane; chosen

  /// What the ray of a pixel hits; none where the lens model ends.
  Hit look(int row, int column) const {
    const Vector2d& ray = rays_.at(row, column);
    if (!ray.allFinite()) return std::nullopt;
    const Vector3d direction = camera_.linear() * ray.homogeneous().normalized();
    return scene_.first_hit(camera_.translation(), direction);
  }

  double seen(const Hit& hit, int row, int column) const {
    if (!hit) return 0;
    return scene_.is_on_board(*hit) ? on_board(row, column) : hit->reflectance;
  }

  /// Point where the ray of a pixel meets the plane of the board, in the board's frame.
  Vector2d meets_board(int row, int column) const {
    const Vector2d& ray = rays_.at(row, column);
    const Vector3d direction = ray.x() * right_ + ray.y() * down_ + forward_;
    const double distance = -eye_.z() / direction.z();
    return {eye_.x() + distance * direction.x(), eye_.y() + distance * direction.y()};
  }

  double on_board(int row, int column) const {
    return on_board(meets_board(row, column), meets_board(row, column + 1),
                    meets_board(row + 1, column));
  }

  /// @param right, below points for the next pixels
  double on_board(const Vector2d& point, const Vector2d& right, const Vector2d& below) const {
    const Vector2d blur =
        kPixelBlur * ((right - point).array().square() + (below - point).array().square()).sqrt();
    return blur.allFinite() ? scene_.board()->reflectance(point, blur) : 0;
  }

  /// Neighbouring pixels share their points on the board.
  std::array<float, kCell * kCell> cell_on_board(int row, int column) const {
    constexpr int kSide = kCell + 1;
    std::array<Vector2d, kSide * kSide> points;
    for (int i = 0; i < kSide * kSide; ++i)
      points[static_cast<std::size_t>(i)] = meets_board(row + i / kSide, column + i % kSide);
    std::array<float, kCell * kCell> light{};
    for (int i = 0; i < kCell * kCell; ++i) {
      const Vector2d* const point =
          &points[static_cast<std::size_t>(i / kCell * kSide + i % kCell)];
      light[static_cast<std::size_t>(i)] =
          static_cast<float>(on_board(point[0], point[1], point[kSide]));
    }
    return light;
  }

  const Scene& scene_;
  const Eigen::Isometry3d& camera_;
  const Rays& rays_;

  // the camera in the board's frame: where it is, and its axes
  Vector3d eye_ = Vector3d::Zero();
  Vector3d right_ = Vector3d::UnitX();
  Vector3d down_ = Vector3d::UnitY();
  Vector3d forward_ = Vector3d::UnitZ();
};

AmbientLight::AmbientLight(const scan_cell_common::CameraIntrinsics& camera, const Optics& optics)
    : camera_(camera), optics_(optics) {}

AmbientLight::~AmbientLight() = default;

std::shared_ptr<const AmbientLight::Rays> AmbientLight::rays_of(const Region& region) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool same = rays_ && rays_->region.x == region.x && rays_->region.y == region.y &&
                    rays_->region.width == region.width && rays_->region.height == region.height;
  if (!same) rays_ = std::make_shared<const Rays>(camera_, region);
  return rays_;
}

void AmbientLight::add(const Scene& scene, const Exposure& exposure, const Region& region,
                       const SensorNoise& noise, std::uint64_t seed, std::uint8_t* pixels) const {
  const double level = optics_.ambient * exposure.duration / optics_.exposure * exposure.gain;
  if (level < kMinLevel) return;
  const std::shared_ptr<const Rays> rays = rays_of(region);
  const Picture picture(scene, exposure.camera, *rays);
  const auto expose = [&](int row, int column, float reflectance) {
    const float grey = static_cast<float>(level) * reflectance;
    const float shot = static_cast<float>(optics_.shot_noise) * std::sqrt(grey);
    std::uint8_t& pixel = pixels[static_cast<std::ptrdiff_t>(row) * region.width + column];
    pixel = to_grey(static_cast<float>(pixel) + grey + shot * noise.light(seed, row)[column]);
  };
  Hits above, below = picture.look_along(0);
  for (int row = 0; row < region.height; row += kCell) {
    above.swap(below);
    below = picture.look_along(row + kCell);
    for (int column = 0; column < region.width; column += kCell) {
      const auto i = static_cast<std::size_t>(column / kCell);
      const auto light =
          picture.cell(row, column, {above[i], above[i + 1], below[i], below[i + 1]});
      for (int y = 0; y < std::min(kCell, region.height - row); ++y) {
        for (int x = 0; x < std::min(kCell, region.width - column); ++x)
          expose(row + y, column + x, light[static_cast<std::size_t>(y * kCell + x)]);
      }
    }
  }
}

}  // namespace scan_cell_sim
