// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "shared_places.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scan_cell_common/scanner/scanner_model.h"

namespace laser_triangulation {
namespace {

constexpr std::size_t kMaxPoints = 4'000'000;  // used; takes a second or two; chosen
constexpr std::size_t kMaxPlaces = 10'000;     // chosen: 1 % of the surface is 100 of them
constexpr std::size_t kMaxPatches = 400'000;   // 60 MB; chosen
constexpr std::size_t kMinPoints = 12;         // of a whole patch; chosen
constexpr double kMaxRoughness = 1e-4;         // [m] RMS of a patch without an edge; chosen
// A full disc has half of the radius along each axis.
constexpr double kMinBreadth = 0.6 * SharedPlaces::kReach / 2;  // [m] RMS; chosen
constexpr double kMaxAside = 0.3 * SharedPlaces::kReach;        // [m] of its mean; chosen

std::size_t step_for(std::size_t size, std::size_t most) {
  return std::max<std::size_t>(1, (size + most - 1) / most);
}

std::vector<Sweep> sweeps_of(const ScanCloud& cloud) {
  constexpr std::size_t kValues = 256;  // of a byte
  std::vector<bool> there(kValues * kValues);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    there[cloud[i].pass * kValues + cloud[i].laser] = true;
  std::vector<Sweep> sweeps;
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (there[i])
      sweeps.push_back(
          {static_cast<std::uint8_t>(i / kValues), static_cast<std::uint8_t>(i % kValues)});
  }
  return sweeps;
}

/// Sums over the points of one sweep around a place, relative to the place.
struct Sums {
  std::size_t sweep = 0;
  std::size_t count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  double distance = std::numeric_limits<double>::infinity();  // [m] squared, of the nearest

  void add(const Eigen::Vector3d& offset, double squared, const ScanPoint& point) {
    if (squared < distance) {
      distance = squared;
      nearest = offset;
      from = Eigen::Vector3f(point.vp_x, point.vp_y, point.vp_z);
    }
    if (squared > SharedPlaces::kReach * SharedPlaces::kReach) return;
    ++count;
    sum += offset;
    squares += offset * offset.transpose();
  }

  SweepPatch patch(const Eigen::Vector3d& place) const {
    SweepPatch patch;
    patch.sweep = sweep;
    patch.nearest = place + nearest;
    patch.from = from.cast<double>();
    if (count < kMinPoints) return patch;
    const Eigen::Vector3d mean = sum / static_cast<double>(count);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares / static_cast<double>(count) -
                                                              mean * mean.transpose());
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    const double aside = (mean - normal * normal.dot(mean)).norm();
    patch.whole = axes.eigenvalues()[0] <= kMaxRoughness * kMaxRoughness &&
                  axes.eigenvalues()[1] >= kMinBreadth * kMinBreadth && aside <= kMaxAside;
    patch.mean = place + mean;
    patch.normal = normal;
    return patch;
  }
};

/// Cells far apart may share a number; their places are then too far off to matter.
std::uint64_t cell_of(const Eigen::Vector3d& point) {
  constexpr int kBits = 21;
  std::uint64_t cell = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto number =
        static_cast<std::int64_t>(std::floor(point[axis] / (2 * SharedPlaces::kSearch)));
    cell = cell << kBits | (static_cast<std::uint64_t>(number) & ((1U << kBits) - 1));
  }
  return cell;
}

Eigen::Vector3d at(const ScanPoint& point) {
  return Eigen::Vector3f(point.x, point.y, point.z).cast<double>();
}

std::vector<Eigen::Vector3d> choose_places(const ScanCloud& cloud, std::size_t sweeps) {
  const std::size_t most = std::min(kMaxPlaces, kMaxPatches / sweeps);
  const std::size_t step = step_for(cloud.size(), most);
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = step / 2; i < cloud.size(); i += step)
    places.push_back(at(cloud[i]));
  return places;
}

/// The sums of a sweep at a place. Points mostly come sweep by sweep.
Sums& sums_of(std::vector<Sums>& of_place, std::size_t sweep) {
  for (auto each = of_place.rbegin(); each != of_place.rend(); ++each)
    if (each->sweep == sweep) return *each;
  of_place.emplace_back();
  of_place.back().sweep = sweep;
  return of_place.back();
}

}  // namespace

std::string name_of(const Sweep& sweep) {
  return fmt::format("pass {} {}", sweep.pass + 1, scan_cell_common::laser_name(sweep.laser));
}

PlaceGrid::PlaceGrid(const std::vector<Eigen::Vector3d>& centres) {
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d side((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5,
                                 (corner >> 2 & 1) - 0.5);
      cells_[cell_of(centres[i] + 2 * SharedPlaces::kSearch * side)].push_back(i);
    }
  }
  for (auto& cell : cells_)
    cell.second.erase(std::unique(cell.second.begin(), cell.second.end()), cell.second.end());
}

const std::vector<std::size_t>& PlaceGrid::near(const Eigen::Vector3d& point) const {
  static const std::vector<std::size_t> none;
  const auto found = cells_.find(cell_of(point));
  return found == cells_.end() ? none : found->second;
}

bool same_side(const SweepPatch& whole, const SweepPatch& other) {
  const auto height_of_view = [&](const SweepPatch& patch) {
    return whole.normal.dot(patch.from - patch.nearest);
  };
  return height_of_view(whole) * height_of_view(other) >= 0;
}

SharedPlaces find_shared_places(const ScanCloud& cloud) {
  SharedPlaces shared;
  shared.sweeps = sweeps_of(cloud);
  if (shared.sweeps.size() < 2) return shared;
  shared.centres = choose_places(cloud, shared.sweeps.size());
  const std::vector<Eigen::Vector3d>& places = shared.centres;
  const PlaceGrid grid(places);
  const auto sweep_of = [&](const ScanPoint& point) {
    const auto before = [](const Sweep& a, const Sweep& b) {
      return a.pass != b.pass ? a.pass < b.pass : a.laser < b.laser;
    };
    const auto found = std::lower_bound(shared.sweeps.begin(), shared.sweeps.end(),
                                        Sweep{point.pass, point.laser}, before);
    return static_cast<std::size_t>(found - shared.sweeps.begin());
  };
  std::vector<std::vector<Sums>> sums(places.size());
  const std::size_t step = step_for(cloud.size(), kMaxPoints);
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    const Eigen::Vector3d point = at(cloud[i]);
    const std::size_t sweep = sweep_of(cloud[i]);
    for (const std::size_t place : grid.near(point)) {
      const Eigen::Vector3d offset = point - places[place];
      const double squared = offset.squaredNorm();
      if (squared <= SharedPlaces::kSearch * SharedPlaces::kSearch)
        sums_of(sums[place], sweep).add(offset, squared, cloud[i]);
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::sort(sums[i].begin(), sums[i].end(),
              [](const Sums& a, const Sums& b) { return a.sweep < b.sweep; });
    std::vector<SweepPatch>& patches = shared.places.emplace_back();
    for (const Sums& each : sums[i])
      patches.push_back(each.patch(places[i]));
    sums[i] = {};
  }
  return shared;
}

}  // namespace laser_triangulation
