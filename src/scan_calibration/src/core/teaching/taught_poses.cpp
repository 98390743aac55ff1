// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/taught_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/csv_reader.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/wire_pose.h"

namespace scan_calibration {
namespace {

using scan_cell_common::CsvReader;
using scan_cell_common::UnusableInput;
using scan_cell_common::WireSix;

const std::vector<std::string_view> kPoseHead = {"x", "y", "z", "qx", "qy", "qz", "qw"};

constexpr const char* kHeaders =
    "begin with the header x,y,z or x,y,z,qx,qy,qz,qw or x_mm,y_mm,z_mm,a_deg,e_deg,r_deg";

Eigen::Isometry3d point(const CsvReader& table) {
  constexpr double kMaxReach = 50;  // [m] of any robot, chosen
  const Eigen::Vector3d p(table.number(0), table.number(1), table.number(2));
  if (p.norm() > kMaxReach) {
    table.refuse(fmt::format("position {:g} m away", p.norm()),
                 "give metres: this looks like millimetres");
  }
  return Eigen::Isometry3d(Eigen::Translation3d(p));
}

WireSix wire_numbers(const CsvReader& table) {
  constexpr double kMaxReach = 50e3;  // [mm] of any robot, chosen
  constexpr double kMaxTurn = 720;    // [deg] chosen: wrists turn more than once
  WireSix wire{};
  for (std::size_t i = 0; i < wire.size(); ++i)
    wire[i] = table.number(i);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(wire[i]) > kMaxReach)
      table.refuse(fmt::format("{} mm", table.field(i)),
                   "give millimetres within the robot's reach");
    if (std::abs(wire[i + 3]) > kMaxTurn)
      table.refuse(fmt::format("{} degrees", table.field(i + 3)), "give degrees within two turns");
  }
  return wire;
}

/// Metres or radians under a header of millimetres and degrees would be read without an error. All
/// of them are small then.
void refuse_wrong_units(const std::vector<WireSix>& wires, const std::string& name) {
  constexpr double kMinFarthest = 10;  // [mm] chosen: no robot works that close to its base
  double farthest = 0, widest = 0;
  for (const WireSix& wire : wires) {
    for (std::size_t i = 0; i < 3; ++i) {
      farthest = std::max(farthest, std::abs(wire[i]));
      widest = std::max(widest, std::abs(wire[i + 3]));
    }
  }
  if (wires.empty()) return;
  if (farthest < kMinFarthest) {
    throw UnusableInput(name, fmt::format("every position within {:g} mm", farthest),
                        "give millimetres, as the header says: this looks like metres");
  }
  if (widest <= 2 * M_PI) {
    throw UnusableInput(name, fmt::format("every angle within {:g} degrees", widest),
                        "give degrees, as the header says: this looks like radians");
  }
}

/// A pose that is stored twice adds no information.
void refuse_repeated(const TaughtPoses& taught, const std::string& name) {
  constexpr double kSame = 1e-6;  // [m] and of a rotation matrix's elements, chosen: rounding
  for (std::size_t i = 0; i < taught.poses.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if ((taught.poses[i].matrix() - taught.poses[k].matrix()).cwiseAbs().maxCoeff() > kSame)
        continue;
      throw UnusableInput(fmt::format("{}: line {}", name, taught.lines[i]),
                          fmt::format("repeats the pose of line {}", taught.lines[k]),
                          "leave one out or teach another pose");
    }
  }
}

}  // namespace

std::size_t append_taught_pose(const std::string& path, const Eigen::Isometry3d& flange) {
  const std::string head = fmt::format("{}\n", fmt::join(kPoseHead, ","));
  std::string text = std::filesystem::exists(path) ? scan_cell_common::read_file(path) : head;
  if (!text.empty() && text.back() != '\n') text += '\n';
  CsvReader table(text, path);
  if (!table.next() || table.fields() != kPoseHead)
    throw UnusableInput(path, "not a file of poses in metres", "give another file");
  const Eigen::Vector3d p = flange.translation();
  const Eigen::Quaterniond q(flange.linear());
  text += fmt::format("{},{},{},{},{},{},{}\n", p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
  const std::size_t count = parse_taught_poses(text, path).poses.size();
  scan_cell_common::save_text(path, text);
  return count;
}

TaughtPoses load_taught_poses(const std::string& path) {
  return parse_taught_poses(scan_cell_common::read_file(path), path);
}

TaughtPoses parse_taught_poses(const std::string& text, const std::string& name) {
  using Fields = std::vector<std::string_view>;
  CsvReader table(text, name);
  if (!table.next()) throw UnusableInput(name, "empty", kHeaders);
  const Fields head = table.fields();
  const bool wire = head == Fields{"x_mm", "y_mm", "z_mm", "a_deg", "e_deg", "r_deg"};
  const bool poses = head == kPoseHead;
  if (!wire && !poses && head != Fields{"x", "y", "z"}) {
    table.refuse(fmt::format("'{}'", fmt::join(head, ",")), kHeaders);
  }
  TaughtPoses taught;
  taught.has_orientation = wire || poses;
  std::vector<WireSix> wires;
  while (table.next()) {
    table.expect_fields(head.size());
    if (wire) wires.push_back(wire_numbers(table));
    taught.poses.push_back(wire    ? scan_cell_common::pose_from_wire(wires.back())
                           : poses ? table.pose(0)
                                   : point(table));
    taught.lines.push_back(static_cast<int>(table.line()));
  }
  refuse_wrong_units(wires, name);
  if (taught.has_orientation) refuse_repeated(taught, name);
  return taught;
}

}  // namespace scan_calibration
