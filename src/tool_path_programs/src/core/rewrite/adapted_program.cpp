// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/adapted_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "rewrite/circle.h"
#include "rewrite/path_frame.h"
#include "scan_cell_common/errors/errors.h"
#include "text/arc_statement.h"
#include "tool_path_programs/read_back.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr double kSame = 1e-9;       // [m], and elements of a rotation matrix
constexpr double kSamePlace = 1e-6;  // [m] of lines: the turn at a via depends on its neighbours

bool is_same(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
  return (one.matrix() - other.matrix()).cwiseAbs().maxCoeff() <= kSame;
}

/// Turns arcs into lines where needed.
class Straightening {
 public:
  Straightening(const Language& language, const ProgramText& text, const ReadSettings& known,
                const ProgramPath& path, const tool_paths::ToolPath& adapted)
      : language_(language),
        text_(text),
        known_(known),
        path_(path),
        adapted_(adapted),
        frame_(text, path.settings.in_base),
        poses_(poses_of(text, path, adapted)) {
    collect_places();
  }

  AdaptedProgram run(double tolerance) {
    const std::vector<double> errors = arc_errors(text_, path_, adapted_);
    for (std::size_t step = 0; step < errors.size(); ++step) {
      const bool bent = errors[step] > tolerance;
      if (bent || (!language_.moves_arcs() && is_moved(step))) straighten(step, errors[step]);
    }
    if (arcs_.empty()) return {with_poses(language_, text_, known_, poses_), {}};
    const ProgramText lines = read_lines();
    return {with_poses(language_, lines, known_, poses_of_lines(lines)), std::move(notes_)};
  }

 private:
  /// Collects the adapted waypoints inside each arc, by step.
  void collect_places() {
    std::size_t waypoint = 0;
    for (const tool_paths::Segment& segment : adapted_.segments) {
      for (const tool_paths::Waypoint& place : segment.waypoints) {
        const WaypointSource& source = path_.sources[waypoint++];
        const bool is_arc = std::get<Move>(text_.program.steps[source.step]).via.has_value();
        const bool is_end = source.pose && source.pose == text_.steps[source.step].pose;
        if (is_arc && !is_end)
          places_[source.step].push_back({place.pose, source.pose.has_value()});
      }
    }
  }

  bool is_moved(std::size_t step) const {
    const Move* const move = std::get_if<Move>(&text_.program.steps[step]);
    if (move == nullptr || move->kind != MotionKind::kCircular) return false;
    const auto moved = [this](std::size_t pose) {
      return !is_same(poses_[pose], text_.poses[pose].pose);
    };
    const auto start = move_before(text_, step);
    return moved(*text_.steps[step].pose) || (start && moved(*text_.steps[*start].pose));
  }

  void straighten(std::size_t step, double error) {
    const StepText& source = text_.steps[step];
    const std::string where = to_string(source.place, text_.files);
    const std::string why =
        language_.moves_arcs()
            ? fmt::format("on the part this arc is no longer a circle: {:.2g} mm off", 1e3 * error)
            : "an arc that moves";
    if (!source.arc)
      throw UnusableInput(where, why,
                          "raise the arc tolerance to keep it, or write the arc as lines");
    if (turns_over_half_a_circle(step))
      throw UnusableInput(where, why + "; along more than half a circle the tool turns",
                          "the direction of the turn is ambiguous: write the arc as lines");
    ArcLines arc{step, start_of(step), vertices(step)};
    const auto [first, is_new] =
        statements_.insert({{source.place.file, source.arc->statement.begin}, arcs_.size()});
    if (is_new) {
      notes_.push_back(fmt::format("{}: {}; it became {} lines", where, why, arc.poses.size() + 1));
      arcs_.push_back(std::move(arc));
    } else if (!are_same(arcs_[first->second].poses, arc.poses)) {
      throw UnusableInput(where, why + ", and it runs in two places",
                          "give each its own statement");
    }
    straight_[step] = first->second;
  }

  bool turns_over_half_a_circle(std::size_t step) const {
    const auto before = move_before(text_, step);
    const Move& move = std::get<Move>(text_.program.steps[step]);
    const Eigen::Isometry3d start = frame_(step).inverse() * frame_(*before) *
                                    std::get<Move>(text_.program.steps[*before]).pose;
    const auto circle =
        Circle::through(start.translation(), move.via->translation(), move.pose.translation());
    const double turn =
        Eigen::Quaterniond(start.linear()).angularDistance(Eigen::Quaterniond(move.pose.linear()));
    constexpr double kTurns = 0.01;  // [rad] below it the direction does not matter; chosen
    return circle && circle->sweep() > M_PI && turn > kTurns;
  }

  static bool are_same(const std::vector<Eigen::Isometry3d>& one,
                       const std::vector<Eigen::Isometry3d>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const auto& a, const auto& b) {
                        return (a.translation() - b.translation()).norm() <= kSamePlace;
                      });
  }

  struct Vertex {
    Eigen::Isometry3d pose;
    bool is_via;
  };

  /// The vertices of the lines, without start and end, in the user frame.
  std::vector<Eigen::Isometry3d> vertices(std::size_t step) {
    const Eigen::Isometry3d from_path = frame_(step).inverse();
    std::vector<Eigen::Isometry3d> vertices;
    const std::vector<Vertex>& places = places_[step];
    for (const Vertex& place : places)
      vertices.push_back(from_path * place.pose);
    if (language_.turns_by_via()) return vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (places[i].is_via) vertices[i].linear() = turn_between(step, vertices, i);
    return vertices;
  }

  /// The pose where an arc begins, in its user frame.
  Eigen::Isometry3d start_of(std::size_t step) const {
    const std::size_t before = move_before(text_, step).value();
    return frame_(step).inverse() * frame_(before) * poses_[*text_.steps[before].pose];
  }

  /// The controller ignores the via's orientation, so it is taken midway between its neighbours.
  Eigen::Matrix3d turn_between(std::size_t step, const std::vector<Eigen::Isometry3d>& vertices,
                               std::size_t i) const {
    const Eigen::Isometry3d from = i > 0 ? vertices[i - 1] : start_of(step);
    const Eigen::Isometry3d& to =
        i + 1 < vertices.size() ? vertices[i + 1] : poses_[*text_.steps[step].pose];
    return Eigen::Quaterniond(from.linear())
        .slerp(0.5, Eigen::Quaterniond(to.linear()))
        .toRotationMatrix();
  }

  ProgramText read_lines() const {
    const auto files = edited(text_.files, language_.lines(text_, arcs_));
    ProgramText lines = language_.read(files, known_);
    WriteSettings as_it_was;
    as_it_was.dialect = text_.dialect;
    const std::string difference =
        first_difference(as_lines(lines), lines.program, language_.unsaid(as_it_was));
    if (!difference.empty())
      throw UnusableInput(language_.title() + " program " + text_.program.name,
                          "it reads differently with lines in place of arcs: " + difference,
                          "raise the arc tolerance to keep its arcs, or write them as lines");
    return lines;
  }

  /// The program that should be read. The language decides how near the tool passes the vertices.
  Program as_lines(const ProgramText& read) const {
    Program program = text_.program;
    program.steps.clear();
    for (std::size_t step = 0; step < text_.program.steps.size(); ++step) {
      const auto straight = straight_.find(step);
      if (straight == straight_.end()) {
        program.steps.push_back(text_.program.steps[step]);
        continue;
      }
      const Move& arc = std::get<Move>(text_.program.steps[step]);
      for (const Eigen::Isometry3d& pose : arcs_[straight->second].poses) {
        const std::size_t at = program.steps.size();
        const Move* const said =
            at < read.program.steps.size() ? std::get_if<Move>(&read.program.steps[at]) : nullptr;
        program.steps.emplace_back(line_of(arc, pose, said == nullptr ? arc.zone : said->zone));
      }
      program.steps.emplace_back(line_of(arc, arc.pose, arc.zone));
    }
    return program;
  }

  static Move line_of(const Move& arc, const Eigen::Isometry3d& to, double zone) {
    Move line;
    line.pose = to;
    line.speed = arc.speed;
    line.zone = zone;
    line.frames = arc.frames;
    return line;
  }

  std::vector<Eigen::Isometry3d> poses_of_lines(const ProgramText& lines) const {
    std::vector<Eigen::Isometry3d> poses;
    for (const PoseText& pose : lines.poses)
      poses.push_back(pose.pose);
    std::size_t at = 0;
    for (std::size_t step = 0; step < text_.steps.size(); ++step, ++at) {
      const auto straight = straight_.find(step);
      if (straight != straight_.end()) at += arcs_[straight->second].poses.size();
      const StepText& now = lines.steps.at(at);
      if (now.pose) poses[*now.pose] = poses_[*text_.steps[step].pose];
      if (now.via) poses[*now.via] = poses_[*text_.steps[step].via];
    }
    return poses;
  }

  const Language& language_;
  const ProgramText& text_;
  const ReadSettings& known_;
  const ProgramPath& path_;
  const tool_paths::ToolPath& adapted_;
  const PathFrame frame_;
  const std::vector<Eigen::Isometry3d> poses_;         // adapted, of text_
  std::map<std::size_t, std::vector<Vertex>> places_;  // by step
  std::vector<ArcLines> arcs_;
  std::map<std::size_t, std::size_t> straight_;  // by step: index in arcs_
  std::map<std::pair<std::size_t, std::size_t>, std::size_t>
      statements_;  // by file and byte: index in arcs_
  std::vector<std::string> notes_;
};

}  // namespace

AdaptedProgram adapted_program(const Language& language, const ProgramText& text,
                               const ReadSettings& known, const ProgramPath& program_path,
                               const tool_paths::ToolPath& adapted, double arc_tolerance) {
  return Straightening(language, text, known, program_path, adapted).run(arc_tolerance);
}

}  // namespace tool_path_programs
