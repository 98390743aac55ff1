// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/path_to_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;
using tool_paths::Segment;
using tool_paths::ToolPath;
using tool_paths::Waypoint;

double metres_per_second(const std::string& unit) {
  if (unit == "mm/s") return 1e-3;
  if (unit == "m/min") return 1.0 / 60;
  if (unit == "mm/min") return 1e-3 / 60;
  return 1;
}

/// The index of the process value that holds the speed.
std::optional<std::size_t> place_of(const std::string& name, const ToolPath& path) {
  const auto& names = path.process_names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

class Export {
 public:
  Export(const ToolPath& path, const ExportParameters& parameters,
         const std::vector<std::size_t>& in_air)
      : path_(path),
        parameters_(parameters),
        in_air_(in_air.begin(), in_air.end()),
        speed_at_(place_of(parameters.speed_value, path)),
        turn_(turn_to_tool()) {}

  Program run(const Frames& frames) {
    program_.name = parameters_.name;
    program_.frames = {frames};
    for (const Segment& segment : path_.segments)
      add(segment);
    return std::move(program_);
  }

 private:
  /// Rotation from a waypoint's orientation to the tool's.
  Eigen::Matrix3d turn_to_tool() const {
    if (path_.has_orientation && parameters_.waypoint_z == WaypointZ::kNotGiven)
      throw InvalidParameter("waypoint_z", "not given",
                             "say whether the waypoints' z axis points into_part or out_of_part");
    if (path_.has_orientation && parameters_.waypoint_z == WaypointZ::kIntoPart)
      return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix().array().round();
  }

  void add(const Segment& segment) {
    const std::size_t first = waypoint_;
    const std::size_t last = first + segment.waypoints.size() - 1;
    const auto contact = contact_within(first, last);
    go_to_front_of(pose_of(segment.waypoints.front()));
    while (waypoint_ <= last) {
      const bool end = waypoint_ == first || waypoint_ == last;
      const bool switches =
          contact && (waypoint_ == contact->first || waypoint_ == contact->second);
      add(segment, first, end || switches);
      if (contact && waypoint_ == contact->first) set_output(true);
      if (contact && waypoint_ == contact->second) set_output(false);
      ++waypoint_;
    }
    if (parameters_.retract > 0)
      travel_to(away_from(pose_of(segment.waypoints.back()), parameters_.retract));
  }

  /// The first and the last waypoint in contact.
  std::optional<std::pair<std::size_t, std::size_t>> contact_within(std::size_t first,
                                                                    std::size_t last) const {
    const auto touches = [&](std::size_t waypoint) { return in_air_.count(waypoint) == 0; };
    while (first <= last && !touches(first))
      ++first;
    if (first > last) return std::nullopt;
    while (!touches(last))
      --last;
    return std::pair(first, last);
  }

  void add(const Segment& segment, std::size_t first, bool stop) {
    const Waypoint& waypoint = segment.waypoints[waypoint_ - first];
    Move move;
    move.pose = pose_of(waypoint);
    move.speed = speed_of(waypoint);
    move.zone = stop ? 0 : zone_at(segment, waypoint_ - first);
    move.waypoint = waypoint_;
    program_.steps.emplace_back(move);
  }

  /// Limits zones so that neighbours do not overlap: no controller can blend two corners at once.
  double zone_at(const Segment& segment, std::size_t i) const {
    constexpr double kShare = 0.45;  // of the distance to a neighbour; chosen
    const auto place = [&segment](std::size_t k) {
      return segment.waypoints[k].pose.translation();
    };
    const double before = (place(i) - place(i - 1)).norm();
    const double after = (place(i + 1) - place(i)).norm();
    return std::min(parameters_.zone, kShare * std::min(before, after));
  }

  void go_to_front_of(const Eigen::Isometry3d& pose) {
    const Eigen::Isometry3d front = away_from(pose, parameters_.approach);
    if (!program_.steps.empty()) return travel_to(front);
    Move move;
    move.kind = MotionKind::kJoint;
    move.pose = front;
    move.joint_speed = parameters_.joint_speed;
    program_.steps.emplace_back(move);
  }

  void travel_to(const Eigen::Isometry3d& pose) {
    Move move;
    move.pose = pose;
    move.speed = parameters_.travel_speed;
    program_.steps.emplace_back(move);
  }

  void set_output(bool on) {
    if (!parameters_.tool_output.empty())
      program_.steps.emplace_back(SetOutput{parameters_.tool_output, on});
  }

  Eigen::Isometry3d pose_of(const Waypoint& waypoint) const {
    Eigen::Isometry3d pose = waypoint.pose;
    pose.linear() = pose.linear() * turn_;
    return pose;
  }

  /// Moves a pose against the tool's direction.
  static Eigen::Isometry3d away_from(const Eigen::Isometry3d& pose, double distance) {
    return pose * Eigen::Translation3d(0, 0, -distance);
  }

  double speed_of(const Waypoint& waypoint) const {
    if (!speed_at_) return parameters_.speed;
    const double value = waypoint.process_values[*speed_at_];
    if (!(value > 0))
      throw UnusableInput(
          fmt::format("tool path '{}', waypoint {}", path_.name, waypoint_ + 1),
          fmt::format("{} {:g} {}", parameters_.speed_value, value, parameters_.speed_unit),
          "give a speed above 0, or another speed_value");
    return value * metres_per_second(parameters_.speed_unit);
  }

  const ToolPath& path_;
  const ExportParameters& parameters_;
  const std::set<std::size_t> in_air_;
  const std::optional<std::size_t> speed_at_;
  const Eigen::Matrix3d turn_;
  Program program_;
  std::size_t waypoint_ = 0;  // over all segments
};

}  // namespace

Program program_of(const ToolPath& path, const ExportParameters& parameters, const Frames& frames,
                   const std::vector<std::size_t>& in_air) {
  scan_cell_common::check(parameters);
  tool_paths::check(path);
  Program program = Export(path, parameters, in_air).run(frames);
  check(program);
  return program;
}

}  // namespace tool_path_programs
