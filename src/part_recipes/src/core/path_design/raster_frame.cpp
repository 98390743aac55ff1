// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/raster_frame.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

using Eigen::Vector3d;
using path_design::PartMesh;

Vector3d in_picture(const Vector3d& direction, const Vector3d& towards) {
  return direction - direction.dot(towards) * towards;
}

/// The axis about which a surface spreads least in the viewer's picture, from the exact second
/// moments of the triangles (each as its corners, weighted with 1/12 of the area, and its middle,
/// with 9/12).
Vector3d longest_axis(const PartMesh& mesh, const Vector3d& towards) {
  double area = 0;
  Vector3d mean = Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  const Vector3d origin = mesh.vertices[mesh.triangles.front()[0]];
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double part = path_design::area_of(mesh, t);
    Vector3d middle = Vector3d::Zero();
    for (const std::uint32_t corner : mesh.triangles[t]) {
      const Vector3d at = in_picture(mesh.vertices[corner] - origin, towards);
      middle += at / 3;
      moments += part / 12 * at * at.transpose();
    }
    moments += part * 9 / 12 * middle * middle.transpose();
    mean += part * middle;
    area += part;
  }
  moments -= mean * mean.transpose() / area;
  Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(2);
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vector3d(-axis) : axis;  // an axis has no sign: always the same
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Extent extent_of(const PartMesh& mesh, const Vector3d& axis) {
  Extent extent;
  for (const path_design::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      const double at = axis.dot(mesh.vertices[corner]);
      extent.low = std::min(extent.low, at);
      extent.high = std::max(extent.high, at);
    }
  }
  return extent;
}

path_design::Planes planes_across(const PartMesh& mesh, const Vector3d& across,
                                  const SliceParameters& parameters) {
  constexpr double kMost = 20000;     // rows; chosen
  constexpr double kRounding = 1e-6;  // rows: single precision of a mesh's file
  const Extent extent = extent_of(mesh, across);
  const double whole = extent.high - extent.low, width = whole - 2 * parameters.margin;
  const auto refuse = [](const char* name, double value, const std::string& cure) {
    throw scan_cell_common::InvalidParameter(name, fmt::format("{:g} m", value), cure);
  };
  if (!(width > 0))
    refuse("margin", parameters.margin,
           fmt::format("the part is {:.4g} m wide across the rows: give less than half", whole));
  if (parameters.spacing > whole)
    refuse("spacing", parameters.spacing,
           fmt::format("the part is {:.4g} m wide across the rows: give less, in metres", whole));
  const double count = std::max(1.0, std::ceil(width / parameters.spacing - kRounding));
  if (count > kMost)
    refuse("spacing", parameters.spacing,
           fmt::format("that makes {:.0f} rows: give more, in metres", count));
  path_design::Planes planes;
  planes.across = across;
  planes.spacing = parameters.spacing;
  planes.count = static_cast<std::size_t>(count);
  planes.first = (extent.low + extent.high - (count - 1) * parameters.spacing) / 2;
  return planes;
}

}  // namespace

RasterFrame raster_frame(const PartMesh& surface, const SliceParameters& parameters) {
  RasterFrame frame;
  frame.towards = parameters.path.from.normalized();
  const Vector3d direction = parameters.direction.empty() ? longest_axis(surface, frame.towards)
                                                          : Vector3d(parameters.direction.data());
  frame.along = Eigen::AngleAxisd(parameters.angle, frame.towards) *
                in_picture(direction, frame.towards).normalized();
  frame.planes = planes_across(surface, frame.towards.cross(frame.along).normalized(), parameters);
  return frame;
}

}  // namespace part_recipes
