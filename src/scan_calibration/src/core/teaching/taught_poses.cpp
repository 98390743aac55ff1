// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/taught_poses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan_cell_common/csv_reader.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/files.h"
#include "scan_cell_common/wire_pose.h"

namespace scan_calibration {
namespace {

using scan_cell_common::CsvReader;
using scan_cell_common::UnusableInput;
using scan_cell_common::WireSix;

constexpr const char* kHeads =
    "begin with the header x,y,z or x,y,z,qx,qy,qz,qw or x_mm,y_mm,z_mm,a_deg,e_deg,r_deg";

Eigen::Isometry3d point(const CsvReader& table) {
  constexpr double kReach = 50;  // [m] of any robot
  const Eigen::Vector3d p(table.number(0), table.number(1), table.number(2));
  if (p.norm() > kReach) {
    table.refuse("position " + std::to_string(p.norm()) + " m away",
                 "give metres: this looks like millimetres");
  }
  return Eigen::Isometry3d(Eigen::Translation3d(p));
}

WireSix wire_numbers(const CsvReader& table) {
  constexpr double kReach = 50e3;    // [mm] of any robot
  constexpr double kMostTurn = 720;  // [deg]
  WireSix wire{};
  for (std::size_t i = 0; i < wire.size(); ++i)
    wire[i] = table.number(i);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(wire[i]) > kReach)
      table.refuse(std::string(table.field(i)) + " mm",
                   "give millimetres within the robot's reach");
    if (std::abs(wire[i + 3]) > kMostTurn)
      table.refuse(std::string(table.field(i + 3)) + " degrees", "give degrees");
  }
  return wire;
}

/// Metres or radians under a head of millimetres and degrees read without a fault: then all of them
/// are small.
void refuse_wrong_units(const std::vector<WireSix>& wires, const std::string& name) {
  constexpr double kMostMetres = 10;
  double farthest = 0, widest = 0;
  for (const WireSix& wire : wires) {
    for (std::size_t i = 0; i < 3; ++i) {
      farthest = std::max(farthest, std::abs(wire[i]));
      widest = std::max(widest, std::abs(wire[i + 3]));
    }
  }
  if (wires.empty()) return;
  if (farthest < kMostMetres) {
    throw UnusableInput(name, "every position within " + std::to_string(farthest) + " mm",
                        "give millimetres, as the header says: this looks like metres");
  }
  if (widest <= 2 * M_PI) {
    throw UnusableInput(name, "every angle within " + std::to_string(widest) + " degrees",
                        "give degrees, as the header says: this looks like radians");
  }
}

/// A pose that was stored twice tells nothing new.
void refuse_repeated(const TaughtPoses& taught, const std::string& name) {
  constexpr double kSame = 1e-6;  // [m] and of a rotation matrix's elements
  for (std::size_t i = 0; i < taught.poses.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if ((taught.poses[i].matrix() - taught.poses[k].matrix()).cwiseAbs().maxCoeff() > kSame)
        continue;
      throw UnusableInput(name + ": line " + std::to_string(taught.lines[i]),
                          "the pose of line " + std::to_string(taught.lines[k]) + " again",
                          "leave one out or teach it elsewhere");
    }
  }
}

}  // namespace

TaughtPoses load_taught_poses(const std::string& path) {
  return parse_taught_poses(scan_cell_common::read_file(path), path);
}

TaughtPoses parse_taught_poses(const std::string& text, const std::string& name) {
  using Fields = std::vector<std::string_view>;
  CsvReader table(text, name);
  if (!table.next()) throw UnusableInput(name, "empty", kHeads);
  const Fields head = table.fields();
  const bool wire = head == Fields{"x_mm", "y_mm", "z_mm", "a_deg", "e_deg", "r_deg"};
  const bool poses = head == Fields{"x", "y", "z", "qx", "qy", "qz", "qw"};
  if (!wire && !poses && head != Fields{"x", "y", "z"}) {
    std::string shown;
    for (const std::string_view field : head)
      shown += (shown.empty() ? "" : ",") + std::string(field);
    table.refuse("'" + shown + "'", kHeads);
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
