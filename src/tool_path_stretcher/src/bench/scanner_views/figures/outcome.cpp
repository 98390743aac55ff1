// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/figures/outcome.h"

#include <algorithm>
#include <cmath>

namespace scanner_views {
namespace {

using tool_path_stretcher::WaypointQuality;

/// Errors of one waypoint.
struct Off {
  double normal, along, angle;
};

Off off(const Eigen::Isometry3d& is, const Eigen::Isometry3d& should) {
  const Eigen::Vector3d by = is.translation() - should.translation();
  const double normal = by.dot(should.linear().col(2));
  return {std::abs(normal), std::sqrt(std::max(0.0, by.squaredNorm() - normal * normal)),
          Eigen::AngleAxisd(is.linear().transpose() * should.linear()).angle()};
}

// For quality types without and with an expected error of orientation.
template <class Quality>
double expected_angle(const Quality& /*quality*/, long /*without*/) {
  return tool_path_stretcher::kUnknown;
}
template <class Quality>
auto expected_angle(const Quality& quality, int /*with*/)
    -> decltype(quality.expected_error_orientation) {
  return quality.expected_error_orientation;
}

void count(const WaypointQuality& quality, const Off& is, Expectations& expectations) {
  constexpr double kDeviations = 3;
  constexpr double kLittle = 0.0005, kUseful = 0.002;  // [m]
  ++expectations.waypoints;
  expectations.normal += is.normal <= kDeviations * quality.expected_error_normal;
  expectations.along += is.along <= kDeviations * quality.expected_error_tangential;
  const double angle = expected_angle(quality, 0);
  expectations.with_angle += std::isfinite(angle);
  expectations.angle += is.angle <= kDeviations * angle;
  expectations.largest_along =
      std::max(expectations.largest_along, quality.expected_error_tangential);
  if (is.along >= kLittle) return;
  ++expectations.truly_along;
  expectations.known_along += quality.expected_error_tangential < kUseful;
}

}  // namespace

std::string to_string(Worth worth) {
  switch (worth) {
    case Worth::kRight:
      return "right";
    case Worth::kWrong:
      return "WRONG";
    case Worth::kRefusedNeedlessly:
      return "needless";
    case Worth::kRefusedRightly:
      break;
  }
  return "rightly refused";
}

Expectations& Expectations::operator+=(const Expectations& other) {
  waypoints += other.waypoints;
  normal += other.normal;
  along += other.along;
  with_angle += other.with_angle;
  angle += other.angle;
  truly_along += other.truly_along;
  known_along += other.known_along;
  largest_along = std::max(largest_along, other.largest_along);
  return *this;
}

Errors errors_of(const Answer& answer, const ToolPath& truth) {
  Errors errors;
  for (std::size_t s = 0; s < truth.segments.size(); ++s) {
    for (std::size_t w = 0; w < truth.segments[s].waypoints.size(); ++w) {
      const Off is =
          off(answer.path.segments.at(s).waypoints.at(w).pose, truth.segments[s].waypoints[w].pose);
      const double position = std::hypot(is.normal, is.along);
      errors.normal += is.normal * is.normal;
      errors.tangential += is.along * is.along;
      errors.angle += is.angle * is.angle;
      errors.position += position * position;
      errors.worst_normal = std::max(errors.worst_normal, is.normal);
      errors.worst_position = std::max(errors.worst_position, position);
      errors.worst_angle = std::max(errors.worst_angle, is.angle);
      ++errors.waypoints;
    }
  }
  for (double* const sum : {&errors.normal, &errors.tangential, &errors.angle, &errors.position})
    *sum = std::sqrt(*sum / static_cast<double>(errors.waypoints));
  for (const WaypointQuality& each : answer.quality) {
    const auto pose = [&each](const ToolPath& path) {
      return path.segments.at(each.segment).waypoints.at(each.waypoint).pose;
    };
    count(each, off(pose(answer.path), pose(truth)), errors.expectations);
  }
  return errors;
}

Outcome outcome_of(Answer answer, const ViewCase& each, const View& view) {
  const bool to_accept = each.expected == Reason::kAccepted;
  Outcome outcome;
  if (answer.accepted && to_accept) {
    outcome.errors = errors_of(answer, view.truth);
    outcome.worth = outcome.errors.wrong() ? Worth::kWrong : Worth::kRight;
  } else if (answer.accepted) {
    outcome.worth = Worth::kWrong;
  } else {
    outcome.worth = to_accept ? Worth::kRefusedNeedlessly : Worth::kRefusedRightly;
  }
  answer.path = {};
  answer.quality.clear();
  outcome.answer = std::move(answer);
  return outcome;
}

}  // namespace scanner_views
