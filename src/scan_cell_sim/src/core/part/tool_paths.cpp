// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/tool_paths.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "part/moulding.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/pose/unit_quaternion.h"

namespace scan_cell_sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;

constexpr const char* kHeader = "x,y,z,qx,qy,qz,qw";

/// On a level surface: z down, x along a direction.
Isometry3d tool_pose(const Vector3d& point, const Vector3d& along) {
  Isometry3d pose = Isometry3d::Identity();
  const Vector3d z = -Vector3d::UnitZ();
  pose.linear() << along, z.cross(along), z;
  pose.translation() = point;
  return pose;
}

Isometry3d parse(const std::string& file, std::size_t number, const std::string& line) {
  std::istringstream text(line);
  std::array<double, 7> v{};
  bool good = true;
  for (std::size_t i = 0; i < v.size(); ++i) {
    char comma = ',';
    if (i > 0) text >> comma;
    good = good && comma == ',' && (text >> v[i]) && std::isfinite(v[i]);
  }
  const Eigen::Quaterniond rotation(v[6], v[3], v[4], v[5]);
  text >> std::ws;
  if (!good || !text.eof() || !scan_cell_common::is_unit(rotation)) {
    throw UnusableInput(fmt::format("{}: line {}", file, number), "'" + line + "'",
                        std::string("give ") + kHeader + " with a unit quaternion");
  }
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() << v[0], v[1], v[2];
  pose.linear() = rotation.normalized().toRotationMatrix();
  return pose;
}

}  // namespace

ToolPath crest_path(const Part& frame, double spacing) {
  const auto* const shape = std::get_if<FrameShape>(&frame.shape);
  if (shape == nullptr) {
    throw UnusableInput("part " + frame.name, "not a frame", "give a part of the shape frame");
  }
  constexpr double kLeast = 1e-4;  // [m] chosen
  if (!(spacing >= kLeast)) {
    throw scan_cell_common::InvalidParameter("spacing", fmt::format("{:g} m", spacing),
                                             "give at least 0.0001 m");
  }
  const Moulding moulding;
  const double x = shape->size.x() / 2 - moulding.crest().x();
  const double y = shape->size.y() / 2 - moulding.crest().x();
  const double z = moulding.height();
  const std::array<Vector3d, 4> corners = {Vector3d{-x, -y, z}, Vector3d{x, -y, z},
                                           Vector3d{x, y, z}, Vector3d{-x, y, z}};

  const Part reference{frame.name, frame.shape, {}, 1, Isometry3d::Identity(), 1};
  ToolPath path;
  for (std::size_t side = 0; side < corners.size(); ++side) {
    const Vector3d begin = corners[side];
    const Vector3d way = corners[(side + 1) % corners.size()] - begin;
    const int pieces = static_cast<int>(std::ceil(way.norm() / spacing));
    for (int i = 0; i < pieces; ++i) {
      path.push_back(tool_pose(begin + way * i / pieces, way.normalized()));
    }
  }
  path.push_back(path.front());
  return true_image(reference, frame, path);
}

ToolPath true_image(const Part& reference, const Part& object, const ToolPath& path) {
  ToolPath image;
  image.reserve(path.size());
  for (const Isometry3d& pose : path)
    image.push_back(true_image(reference, object, pose));
  return image;
}

ToolPath load_tool_path(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) {
    throw FileError(path, "cannot be read, or is empty", "check the path");
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  if (line != kHeader) {
    throw UnusableInput(path + ": line 1", "'" + line + "'", std::string("begin with ") + kHeader);
  }
  ToolPath poses;
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty()) poses.push_back(parse(path, number, line));
  }
  if (poses.empty()) throw UnusableInput(path, "no poses", "give at least one");
  return poses;
}

void save_tool_path(const std::string& file, const ToolPath& path) {
  std::string text = std::string(kHeader) + '\n';
  for (const Isometry3d& pose : path) {
    const Eigen::Quaterniond q(pose.linear());
    const Vector3d p = pose.translation();
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", p.x(), p.y(),
                        p.z(), q.x(), q.y(), q.z(), q.w());
  }
  scan_cell_common::save_text(file, text);
}

}  // namespace scan_cell_sim
