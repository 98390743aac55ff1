// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/tool_paths.h"

#include <fmt/format.h>

#include <algorithm>
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

/// Pose on a level surface: z down, x along a direction.
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

void check_spacing(double spacing) {
  constexpr double kLeast = 1e-4;  // [m] chosen
  if (spacing >= kLeast) return;
  throw scan_cell_common::InvalidParameter("spacing", fmt::format("{:g} m", spacing),
                                           "give at least 0.0001 m");
}

}  // namespace

ToolPath crest_path(const Part& frame, double spacing) {
  const auto* const shape = std::get_if<FrameShape>(&frame.shape);
  if (shape == nullptr) {
    throw UnusableInput("part " + frame.name, "not a frame", "give a part of the shape frame");
  }
  check_spacing(spacing);
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

namespace {

constexpr double kInset = 0.01;  // [m] of a path from the border of a face; chosen

/// Appends poses on level ground from one point towards another, without the last one.
void add_line(const Vector3d& from, const Vector3d& to, double spacing, ToolPath& path) {
  const Vector3d way = to - from;
  const int pieces = std::max(1, static_cast<int>(std::ceil(way.norm() / spacing)));
  for (int i = 0; i < pieces; ++i)
    path.push_back(tool_pose(from + way * i / pieces, way.normalized()));
}

/// A path through all corners; at the last one the tool points as on the way to it.
ToolPath through(const std::vector<Vector3d>& corners, double spacing) {
  ToolPath path;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    add_line(corners[i], corners[i + 1], spacing, path);
  path.push_back(path.back());
  path.back().translation() = corners.back();
  return path;
}

/// A path to and fro over the sheet.
ToolPath over_sheet(const FrameShape& frame, double spacing) {
  if (frame.sheet->bulge != 0) {
    throw UnusableInput("sheet", fmt::format("bulge {:g} m", frame.sheet->bulge),
                        "give a flat one to teach a path on; a deformation may bulge it");
  }
  constexpr int kLines = 5;  // chosen
  const double margin = Moulding().width() + kInset;
  const double x = frame.size.x() / 2 - margin;
  const double y = frame.size.y() / 2 - margin;
  std::vector<Vector3d> corners;
  for (int line = 0; line < kLines; ++line) {
    const double side = line % 2 == 0 ? -x : x;
    const double at = y * (2.0 * line / (kLines - 1) - 1);
    corners.emplace_back(side, at, frame.sheet->height);
    corners.emplace_back(-side, at, frame.sheet->height);
  }
  return through(corners, spacing);
}

/// A path around the top of a box, and back to the start.
ToolPath around_top(const BoxShape& box, double spacing) {
  const double x = box.size.x() / 2 - kInset;
  const double y = box.size.y() / 2 - kInset;
  const double z = box.size.z();
  return through({{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}, {-x, -y, z}}, spacing);
}

/// A path along the top of a pipe, from near one end to near the other.
ToolPath along_top(const ElbowShape& elbow, double spacing) {
  const double bend = elbow.bend_radius;
  const double top = 2 * elbow.pipe_radius;
  const double turn = bend * M_PI / 2;
  const double length = 2 * (elbow.leg - kInset) + turn;
  const int pieces = std::max(1, static_cast<int>(std::ceil(length / spacing)));
  ToolPath path;
  for (int i = 0; i <= pieces; ++i) {
    const double way = length * i / pieces - (elbow.leg - kInset);  // from the bend's begin
    const double angle = std::clamp(way / bend, 0.0, M_PI / 2);
    const Vector3d along(std::cos(angle), std::sin(angle), 0);
    const Vector3d on_bend(bend * (std::sin(angle) - 1), bend * (1 - std::cos(angle)), top);
    path.push_back(tool_pose(on_bend + (way - angle * bend) * along, along));
  }
  return path;
}

ToolPath on_shape(const BoxShape& box, double spacing) {
  return around_top(box, spacing);
}

ToolPath on_shape(const ElbowShape& elbow, double spacing) {
  return along_top(elbow, spacing);
}

ToolPath on_shape(const FrameShape& frame, double spacing) {
  if (frame.sheet) return over_sheet(frame, spacing);
  return crest_path({"frame", frame, {}, 1, Isometry3d::Identity(), 1}, spacing);
}

}  // namespace

ToolPath taught_path(const Part& part, double spacing) {
  check_spacing(spacing);
  const Part reference{part.name, part.shape, {}, 1, Isometry3d::Identity(), 1};
  return true_image(
      reference, part,
      std::visit([&](const auto& shape) { return on_shape(shape, spacing); }, part.shape));
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
