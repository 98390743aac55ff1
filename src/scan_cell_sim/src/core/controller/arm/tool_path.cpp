// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/arm/tool_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_cell_sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSpot = 1e-5;                    // [m] c4g_protocol.md
constexpr double kNoTurn = 1e-3 * M_PI / 180;     // [rad] c4g_protocol.md
constexpr double kMostTurn = 179.9 * M_PI / 180;  // [rad] c4g_protocol.md
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse(std::size_t waypoint, const std::string& text) {
  throw ControllerRefusal(ControllerErrorCode::kBadPath,
                          fmt::format("waypoint {}: {}", waypoint, text));
}

}  // namespace

TipLine::TipLine(const Isometry3d& from, const Isometry3d& to, double turn_radius,
                 std::size_t waypoint)
    : from_(from), move_(to.translation() - from.translation()) {
  const AngleAxisd turn(from.linear().transpose() * to.linear());
  if (turn.angle() > kMostTurn) refuse(waypoint, "half a turn, its direction is ambiguous");
  turn_ = turn.angle() * turn.axis();
  if (on_the_spot() && turn.angle() < kNoTurn) refuse(waypoint, "the same as the one before");
  measure_ = std::max(length(), angle() * turn_radius);
}

bool TipLine::on_the_spot() const {
  return length() < kSpot;
}

Matrix3d TipLine::turned(double share) const {
  const double angle = turn_.norm();
  if (angle <= 0) return Matrix3d::Identity();
  return AngleAxisd(share * angle, turn_ / angle).toRotationMatrix();
}

Isometry3d TipLine::at(double share) const {
  Isometry3d pose = from_;
  pose.translation() += share * move_;
  pose.linear() = from_.linear() * turned(share);
  return pose;
}

ToolPath::ToolPath(const Isometry3d& flange_to_tip, std::vector<TipWaypoint> waypoints,
                   std::size_t first, double turn_radius)
    : tip_to_flange_(flange_to_tip.inverse()),
      waypoints_(std::move(waypoints)),
      first_(first),
      radius_(turn_radius) {
  for (std::size_t i = 1; i < waypoints_.size(); ++i) {
    begins_.push_back(total_);
    lines_.emplace_back(waypoints_[i - 1].tip, waypoints_[i].tip, turn_radius, first + i);
    total_ += lines_.back().measure();
  }
  passes_.push_back(0);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const bool last = i + 1 == lines_.size();
    const double from = begins_[i] + (i == 0 ? 0 : roundings_[i - 1]);  // as yet not in a part
    const double end = last ? total_ : begins_[i + 1];
    const double half = last ? 0 : share_of(i);
    roundings_.push_back(half);
    passes_.push_back(last ? 1 : end / total_);
    if (half > 0) {
      if (end - half - from > kNothing) parts_.push_back({(end - half) / total_, i, false, false});
      parts_.push_back({(end + half) / total_, i, true, false});
    } else {
      parts_.push_back({last ? 1 : end / total_, i, false, true});
    }
  }
}

/// [m] of the path that the rounding at the end of a line takes on each side of that end.
double ToolPath::share_of(std::size_t line) const {
  double half = kNoLimit;
  for (const TipLine* const side : {&lines_[line], &lines_[line + 1]}) {
    if (side->on_the_spot()) return 0;
    const double zone = waypoints_[line + 1].zone * side->measure() / side->length();
    half = std::min({half, zone, side->measure() / 2});
  }
  return half;
}

Isometry3d ToolPath::tip(double way) const {
  const auto found =
      std::lower_bound(parts_.begin(), parts_.end() - 1, way,
                       [](const Part& part, double wanted) { return part.end < wanted; });
  const TipLine& line = lines_[found->line];
  const double from_end = way * total_ - begins_[found->line] - line.measure();
  if (!found->rounding) return line.at(std::clamp(1 + from_end / line.measure(), 0.0, 1.0));
  const double half = roundings_[found->line];
  const double part = std::clamp((from_end + half) / (2 * half), 0.0, 1.0);
  const TipLine& next = lines_[found->line + 1];
  const double fading = 1 - half / line.measure() * (1 - part) * (1 - part);
  const double growing = half / next.measure() * part * part;
  Isometry3d pose = line.at(fading);
  pose.translation() += growing * next.move();
  pose.linear() = pose.linear() * next.turned(growing);
  return pose;
}

Isometry3d ToolPath::flange(double way) const {
  return tip(way) * tip_to_flange_;
}

std::size_t ToolPath::passed(double way) const {
  constexpr double kRounding = 1e-12;  // of the way
  const auto next = std::upper_bound(passes_.begin(), passes_.end(), way + kRounding);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - passes_.begin(), 1)) - 1;
}

std::uint64_t ToolPath::waypoint(double way) const {
  return first_ + passed(way);
}

std::uint32_t ToolPath::outputs(double way) const {
  return waypoints_[passed(way)].outputs;
}

double ToolPath::programmed(const Part& part, const LineSettings& settings) const {
  const auto of_line = [&](std::size_t line) {
    const TipLine& one = lines_[line];
    const double moving = waypoints_[line + 1].speed / std::max(one.length(), kNothing);
    const double turning = settings.rotational_speed / std::max(one.angle(), kNothing);
    return std::min(moving, turning) * one.measure() / total_;
  };
  return part.rounding ? std::min(of_line(part.line), of_line(part.line + 1)) : of_line(part.line);
}

double ToolPath::corner_speed(const Part& part, double acceleration) const {
  if (!part.rounding) return kNoLimit;
  const TipLine& line = lines_[part.line];
  const TipLine& next = lines_[part.line + 1];
  const double half = roundings_[part.line];
  const Vector3d bend = next.move() / next.measure() - line.move() / line.measure();
  const Vector3d twist = next.turn() / next.measure() - line.turn() / line.measure();
  const double sharper = std::max({bend.norm(), twist.norm() * radius_, kNothing});
  return std::sqrt(acceleration * 2 * half / sharper) / total_;
}

std::vector<FlangePath::Stretch> ToolPath::stretches() const {
  std::vector<Stretch> result;
  for (const Part& part : parts_) {
    double angle = lines_[part.line].angle();
    if (part.rounding) angle += lines_[part.line + 1].angle();
    result.push_back({part.end, angle, angle});
  }
  return result;
}

}  // namespace scan_cell_sim
