// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/scanner/looking.h"

#include <limits>

namespace scanner_views {
namespace {

using Eigen::Vector3d;

constexpr double kReflectance = 0.7;

Scanner scanner_for(const Mesh& part, Draws& draws) {
  const double coarser = coarseness_of(part);
  Scanner scanner;
  scanner.line_spacing *= coarser * draws.between(0.8, 1.3);
  scanner.point_spacing *= coarser * draws.between(0.9, 1.6);
  return scanner;
}

/// Axes of the scanner, which moves along `heading` in the plane and leans about that direction.
Eigen::Matrix3d head_of(double heading, double lean) {
  const Eigen::Matrix3d down =
      Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();  // z down
  return Eigen::AngleAxisd(heading, Vector3d::UnitZ()) * down *
         Eigen::AngleAxisd(lean, Vector3d::UnitX()).toRotationMatrix();
}

std::vector<Sweep> sweeps_of(Viewing viewing, double heading) {
  constexpr double kLean = 0.35, kFar = 0.52;  // [rad] 20 and 30 degrees
  Sweep above;
  above.head = head_of(heading, 0);
  switch (viewing) {
    case Viewing::kAboveOneLaser:
      return {above};
    case Viewing::kAboveBothLasers:
      above.second_laser = true;
      return {above};
    case Viewing::kLeaningOneLaser:
      above.head = head_of(heading, kLean);
      return {above};
    case Viewing::kTwoSides:
      break;
  }
  Sweep one, other;
  one.head = head_of(heading, kFar);
  other.head = head_of(heading, -kFar);
  one.second_laser = other.second_laser = true;
  other.number = 1;
  return {one, other};
}

}  // namespace

double extent_of(const Mesh& mesh) {
  return box_of(mesh).diagonal().norm();
}

double coarseness_of(const Mesh& part) {
  constexpr double kLarge = 0.35;  // [m] chosen
  return std::max(1.0, extent_of(part) / kLarge);
}

ScanPoints scan(const std::vector<Mesh>& meshes, const Looking& looking, Draws& draws) {
  const scan_cell_sim::Scene scene(meshes, kReflectance);
  const LineScanner scanner(scene, scanner_for(meshes.front(), draws));
  ScanPoints points;
  for (Sweep& sweep : sweeps_of(looking.viewing, draws.between(-M_PI, M_PI))) {
    for (const Vector3d& vertex : meshes.front().vertices)
      sweep.extent.extend(sweep.head.transpose() * vertex);
    sweep.extent.min().head<2>().array() -= looking.around;
    sweep.extent.max().head<2>().array() += looking.around;
    scanner.scan(sweep, draws, points);
  }
  return points;
}

void scatter(double share, const Mesh& around, Draws& draws, ScanPoints& points) {
  const Eigen::AlignedBox3d box = box_of(around);
  const auto count = static_cast<std::size_t>(share * static_cast<double>(points.places.size()));
  const Vector3d eye = points.seen_from.empty() ? Vector3d(0, 0, 1) : points.seen_from.front();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d at(draws.between(-0.1, 1.1), draws.between(-0.1, 1.1), draws.between(0, 2));
    points.places.emplace_back(box.min() + box.sizes().cwiseProduct(at));
    points.seen_from.push_back(eye);
    points.lasers.push_back(0);
    points.passes.push_back(0);
    points.surfaces.push_back(std::numeric_limits<unsigned>::max());
  }
}

}  // namespace scanner_views
