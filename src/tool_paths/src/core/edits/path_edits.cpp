// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_paths/path_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "scan_cell_common/errors/errors.h"

namespace tool_paths {
namespace {

using scan_cell_common::UnusableInput;

/// A waypoint with its segment.
struct Place {
  std::size_t segment = 0;
  Waypoint waypoint;
  WaypointOrigin origin;
};

/// All waypoints in one row, so that edits need not know about segments.
class Row {
 public:
  explicit Row(const ToolPath& path) : path_(path) {
    for (std::size_t s = 0; s < path.segments.size(); ++s)
      for (const Waypoint& waypoint : path.segments[s].waypoints)
        places_.push_back({s, waypoint, {places_.size(), places_.size()}});
  }

  void apply(const PathEdit& edit, const std::string& name) {
    name_ = name;
    std::visit([this](const auto& typed) { apply(typed); }, edit);
  }

  EditedPath finish() const {
    EditedPath result;
    result.path = path_;
    for (Segment& segment : result.path.segments)
      segment.waypoints.clear();
    for (const Place& place : places_) {
      result.path.segments[place.segment].waypoints.push_back(place.waypoint);
      result.origins.push_back(place.origin);
    }
    auto& segments = result.path.segments;
    segments.erase(std::remove_if(segments.begin(), segments.end(),
                                  [](const Segment& segment) { return segment.waypoints.empty(); }),
                   segments.end());
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& fault, const std::string& cure) const {
    throw UnusableInput(name_, fault, cure);
  }

  void check(std::size_t waypoint) const {
    if (waypoint < places_.size()) return;
    refuse(fmt::format("no waypoint {}", waypoint),
           fmt::format("at this edit the path has waypoints 0 to {}", places_.size() - 1));
  }

  /// @param change changes one waypoint
  template <class Change>
  void change(const WaypointRange& range, const Change& change) {
    if (range.last < range.first)
      refuse(fmt::format("waypoints {} to {}", range.first, range.last),
             "give the lower one first");
    check(range.last);
    for (std::size_t i = range.first; i <= range.last; ++i) {
      change(places_[i].waypoint);
      places_[i].origin.edited = true;
    }
  }

  void check_orientation(EditFrame frame, const char* what) const {
    if (frame == EditFrame::kTool && !path_.has_orientation)
      refuse(fmt::format("{} in the tool's frame, but the path has no orientations", what),
             "give frame: path");
  }

  void apply(const MoveEdit& edit) {
    check_orientation(edit.frame, "a move");
    change(edit.waypoints, [&edit](Waypoint& waypoint) {
      if (edit.frame == EditFrame::kTool)
        waypoint.pose.translate(edit.by);
      else
        waypoint.pose.pretranslate(edit.by);
    });
  }

  void apply(const TurnEdit& edit) {
    if (!path_.has_orientation) refuse("a turn, but the path has no orientations", "leave it out");
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(edit.angle, edit.about).toRotationMatrix();
    change(edit.waypoints, [&](Waypoint& waypoint) {
      const Eigen::Matrix3d before = waypoint.pose.linear();
      const Eigen::Matrix3d after = edit.frame == EditFrame::kTool ? before * turn : turn * before;
      // Stays a rotation to the last digit, however often it is turned
      waypoint.pose.linear() = Eigen::Quaterniond(after).normalized().toRotationMatrix();
    });
  }

  void apply(const DeleteEdit& edit) {
    change(edit.waypoints, [](Waypoint&) {});
    if (edit.waypoints.last - edit.waypoints.first + 1 == places_.size())
      refuse("it deletes all waypoints", "keep at least one");
    const auto at = [this](std::size_t i) {
      return std::next(places_.begin(), static_cast<std::ptrdiff_t>(i));
    };
    places_.erase(at(edit.waypoints.first), at(edit.waypoints.last + 1));
  }

  void apply(const AddEdit& edit) {
    check(edit.after);
    const Place& before = places_[edit.after];
    const bool is_last =
        edit.after + 1 == places_.size() || places_[edit.after + 1].segment != before.segment;
    const Place& after = is_last ? before : places_[edit.after + 1];
    Place added = before;
    added.waypoint = between(before.waypoint, after.waypoint, edit.share);
    added.origin = {before.origin.first, after.origin.second, true, true};
    places_.insert(std::next(places_.begin(), static_cast<std::ptrdiff_t>(edit.after + 1)), added);
  }

  void apply(const SetEdit& edit) {
    for (const auto& [name, value] : edit.values) {
      const std::size_t at = place_of(name, edit.waypoints);
      const double given = value;
      change(edit.waypoints, [=](Waypoint& waypoint) { waypoint.process_values[at] = given; });
    }
  }

  /// Index of a process value. Adds a new one.
  std::size_t place_of(const std::string& name, const WaypointRange& range) {
    auto& names = path_.process_names;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    if (range.first != 0 || range.last + 1 != places_.size())
      refuse(fmt::format("not all waypoints would have the new process value '{}'", name),
             fmt::format("set it for 0 to {} first", places_.size() - 1));
    names.push_back(name);
    for (Place& place : places_)
      place.waypoint.process_values.push_back(0);
    return names.size() - 1;
  }

  ToolPath path_;
  std::vector<Place> places_;
  std::string name_;  // of the current edit, for errors
};

}  // namespace

EditedPath edited(const ToolPath& path, const std::vector<PathEdit>& edits) {
  Row row(path);
  for (std::size_t i = 0; i < edits.size(); ++i)
    row.apply(edits[i], fmt::format("edit {}", i + 1));
  EditedPath result = row.finish();
  check(result.path);
  return result;
}

PathLayout layout_for(const ToolPath& edited, PathLayout layout) {
  layout.yaml.reset();
  layout.kept.clear();
  if (layout.columns.empty()) return layout;
  for (const std::string& name : edited.process_names)
    if (std::find(layout.columns.begin(), layout.columns.end(), name) == layout.columns.end())
      layout.columns.push_back(name);
  return layout;
}

ToolPath marked(const EditedPath& edited) {
  ToolPath path = edited.path;
  const auto found = std::find(path.process_names.begin(), path.process_names.end(), kEditedValue);
  const auto at = static_cast<std::size_t>(found - path.process_names.begin());
  if (found == path.process_names.end()) path.process_names.emplace_back(kEditedValue);
  std::size_t number = 0;
  for (Segment& segment : path.segments)
    for (Waypoint& waypoint : segment.waypoints) {
      waypoint.process_values.resize(path.process_names.size(), 0);
      double& mark = waypoint.process_values[at];
      mark = edited.origins[number++].edited || mark == 1 ? 1 : 0;
    }
  return path;
}

}  // namespace tool_paths
