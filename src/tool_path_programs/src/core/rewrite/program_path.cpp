// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/program_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "rewrite/circle.h"
#include "rewrite/path_frame.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/read_back.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr double kLongestArc = 100;  // [m] no robot moves so far in one arc; chosen

std::string where(const ProgramText& text, std::size_t step) {
  return to_string(text.steps[step].place, text.files);
}

class Maker {
 public:
  Maker(const ProgramText& text, const ProgramPathSettings& settings)
      : text_(text), settings_(settings), frame_(text, settings.in_base) {}

  ProgramPath run() {
    result_.settings = settings_;
    result_.path.name = text_.program.name;
    result_.path.has_orientation = true;
    find_work();
    for (std::size_t step = 0; step < text_.program.steps.size(); ++step)
      add(step);
    end_segment();
    if (result_.path.segments.empty())
      throw UnusableInput("program " + text_.program.name, "no move to a pose",
                          "give the program that moves along the part");
    return std::move(result_);
  }

 private:
  /// Collects where lines and arcs lead.
  void find_work() {
    for (std::size_t step = 0; step < text_.program.steps.size(); ++step) {
      const Move* move = std::get_if<Move>(&text_.program.steps[step]);
      if (!move || move->kind == MotionKind::kJoint) continue;
      work_.extend((frame_(step) * move->pose).translation());
    }
  }

  void add(std::size_t step) {
    if (const Move* move = std::get_if<Move>(&text_.program.steps[step])) return add(step, *move);
    end_segment();
    if (std::holds_alternative<JointMove>(text_.program.steps[step])) {
      keep(step, "goes to angles of the axes");
      last_.reset();
    }
  }

  void add(std::size_t step, const Move& move) {
    const bool joint = move.kind == MotionKind::kJoint;
    if (joint != last_was_joint_) end_segment();
    last_was_joint_ = joint;
    const Eigen::Isometry3d to_path = frame_(step);
    const Eigen::Isometry3d pose = to_path * move.pose;
    if (joint && !work_.isEmpty() &&
        work_.exteriorDistance(pose.translation()) > settings_.max_joint_distance) {
      keep(step, fmt::format("a joint move {:.3g} m from all lines and arcs",
                             work_.exteriorDistance(pose.translation())));
    } else {
      if (move.kind == MotionKind::kCircular) add_arc(step, to_path * *move.via, pose);
      add(step, pose, text_.steps[step].pose);
    }
    last_ = pose;
  }

  void add_arc(std::size_t step, const Eigen::Isometry3d& via, const Eigen::Isometry3d& to) {
    if (!last_)
      throw UnusableInput(where(text_, step), "an arc that begins at angles of the axes",
                          "a move to a pose must come before it");
    const auto circle = Circle::through(last_->translation(), via.translation(), to.translation());
    if (!circle)
      throw UnusableInput(where(text_, step), "an arc whose three positions do not define a circle",
                          "correct the program");
    const double length = circle->radius() * circle->sweep();
    if (!(length <= kLongestArc))
      throw UnusableInput(where(text_, step), fmt::format("an arc of {:.3g} m", length),
                          "correct the program");
    const auto add_via = [&] {
      if (add(step, via, text_.steps[step].via)) return;
      add(step, place_at({via.translation(), circle->via_angle()}, *circle, via, to), std::nullopt);
    };
    bool is_behind_via = false;
    for (const ArcPlace& place : circle->places(arc_step(*circle))) {
      if (!std::exchange(is_behind_via, place.angle > circle->via_angle()) && is_behind_via)
        add_via();
      add(step, place_at(place, *circle, via, to), std::nullopt);
    }
    if (!is_behind_via) add_via();
  }

  /// [m] from the sagitta of a chord s of a circle r, s^2 / 8 r.
  double arc_step(const Circle& circle) const {
    return std::min(settings_.arc_step, std::sqrt(8 * circle.radius() * settings_.arc_chord_error));
  }

  /// The pose on an arc: the tool turns evenly to the end, or to the via and then to the end.
  Eigen::Isometry3d place_at(const ArcPlace& place, const Circle& circle,
                             const Eigen::Isometry3d& via, const Eigen::Isometry3d& to) const {
    const Eigen::Quaterniond from(last_->linear()), end(to.linear()), middle(via.linear());
    const double sweep = circle.sweep(), half = circle.via_angle();
    Eigen::Quaterniond turn = from.slerp(place.angle / sweep, end);
    if (settings_.turns_by_via && place.angle <= half)
      turn = from.slerp(place.angle / half, middle);
    else if (settings_.turns_by_via)
      turn = middle.slerp((place.angle - half) / (sweep - half), end);
    return Eigen::Translation3d(place.position) * turn;
  }

  /// @return whether it is a waypoint of its own
  bool add(std::size_t step, const Eigen::Isometry3d& pose,
           const std::optional<std::size_t>& text) {
    if (text && is_known(step, *text, pose)) return false;
    if (!segment_)
      segment_ = tool_paths::Segment{fmt::format("{}", result_.path.segments.size() + 1), {}};
    segment_->waypoints.push_back({pose, {}});
    result_.sources.push_back({step, text});
    return true;
  }

  /// One pose of the text is one waypoint, wherever it is used.
  bool is_known(std::size_t step, std::size_t text, const Eigen::Isometry3d& pose) {
    const auto [known, is_new] = known_.emplace(text, pose);
    if (is_new) return false;
    if (!known->second.isApprox(pose, 1e-9))
      throw UnusableInput(where(text_, step),
                          "its pose is written once, but used in two user frames",
                          "give each move its own pose");
    return true;
  }

  void end_segment() {
    if (segment_) result_.path.segments.push_back(std::move(*segment_));
    segment_.reset();
  }

  void keep(std::size_t step, const std::string& reason) {
    result_.kept.push_back(where(text_, step) + ": " + reason + "; it stays as it is");
  }

  const ProgramText& text_;
  const ProgramPathSettings settings_;
  const PathFrame frame_;
  Eigen::AlignedBox3d work_;
  ProgramPath result_;
  std::optional<tool_paths::Segment> segment_;
  std::map<std::size_t, Eigen::Isometry3d>
      known_;  // poses of the text that are waypoints, in the path's frame
  std::optional<Eigen::Isometry3d> last_;  // of the move before
  bool last_was_joint_ = false;
};

/// The waypoints of a path over all segments.
std::vector<const tool_paths::Waypoint*> waypoints_of(const tool_paths::ToolPath& path) {
  std::vector<const tool_paths::Waypoint*> waypoints;
  for (const tool_paths::Segment& segment : path.segments)
    for (const tool_paths::Waypoint& waypoint : segment.waypoints)
      waypoints.push_back(&waypoint);
  return waypoints;
}

}  // namespace

ProgramPath path_of(const ProgramText& text, const ProgramPathSettings& settings) {
  return Maker(text, settings).run();
}

std::vector<Eigen::Isometry3d> poses_of(const ProgramText& text, const ProgramPath& program_path,
                                        const tool_paths::ToolPath& adapted) {
  std::vector<Eigen::Isometry3d> poses;
  for (const PoseText& pose : text.poses)
    poses.push_back(pose.pose);
  const PathFrame frame(text, program_path.settings.in_base);
  const auto waypoints = waypoints_of(adapted);
  if (waypoints.size() != program_path.sources.size())
    throw std::logic_error("an adapted path with another number of waypoints");
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const WaypointSource& source = program_path.sources[i];
    if (source.pose) poses[*source.pose] = frame(source.step).inverse() * waypoints[i]->pose;
  }
  return poses;
}

Program program_with(const ProgramText& text, const std::vector<Eigen::Isometry3d>& poses) {
  Program program = text.program;
  for (std::size_t step = 0; step < program.steps.size(); ++step) {
    Move* move = std::get_if<Move>(&program.steps[step]);
    if (!move) continue;
    if (text.steps[step].pose) move->pose = poses.at(*text.steps[step].pose);
    if (move->via && text.steps[step].via) move->via = poses.at(*text.steps[step].via);
  }
  return program;
}

std::vector<double> arc_errors(const ProgramText& text, const ProgramPath& program_path,
                               const tool_paths::ToolPath& adapted) {
  const PathFrame frame(text, program_path.settings.in_base);
  const Program program = program_with(text, poses_of(text, program_path, adapted));
  std::vector<std::optional<Circle>> circles(program.steps.size());
  const Move* last = nullptr;
  std::size_t last_step = 0;
  for (std::size_t step = 0; step < program.steps.size(); ++step) {
    const Move* move = std::get_if<Move>(&program.steps[step]);
    if (!move) continue;
    if (last && move->kind == MotionKind::kCircular)
      circles[step] = Circle::through(frame(last_step) * last->pose.translation(),
                                      frame(step) * move->via->translation(),
                                      frame(step) * move->pose.translation());
    last = move;
    last_step = step;
  }
  std::vector<double> errors(program.steps.size(), 0);
  const auto waypoints = waypoints_of(adapted);
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::size_t step = program_path.sources[i].step;
    if (program_path.sources[i].pose) continue;
    const double error = circles[step] ? circles[step]->distance(waypoints[i]->pose.translation())
                                       : std::numeric_limits<double>::infinity();
    errors[step] = std::max(errors[step], error);
  }
  return errors;
}

std::vector<SourceFile> with_poses(const Language& language, const ProgramText& text,
                                   const ReadSettings& known,
                                   const std::vector<Eigen::Isometry3d>& poses) {
  std::vector<SourceFile> files = edited(text.files, language.edits(text, poses));
  const ProgramText again = language.read(files, known);
  ReadBackLimits limits;
  limits.speed = 0;
  WriteSettings as_it_was;
  as_it_was.dialect = text.dialect;
  const std::string difference = first_difference(program_with(text, poses), again.program,
                                                  language.unsaid(as_it_was), limits);
  if (!difference.empty())
    throw UnusableInput(language.title() + " program " + text.program.name,
                        "it differs when read back: " + difference,
                        "nothing was written; please report this with the program");
  return files;
}

}  // namespace tool_path_programs
