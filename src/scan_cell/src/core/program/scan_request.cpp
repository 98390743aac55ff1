// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/scan_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {
namespace {

using scan_cell_common::Refused;

constexpr std::size_t kMaxPasses = 200;  // chosen; a point of the cloud has a byte for its pass
constexpr std::size_t kMaxPoses = 1000;  // of a pass; chosen

constexpr double kTurnsBack = M_PI / 180;  // [rad] about the arc's axis; chosen

double degrees(double angle) {
  return angle * 180 / M_PI;
}

/// Angle [rad] of a triangle at one corner. The arc between the other two corners, seen from the
/// circle's centre, is twice that.
double angle_at(const Eigen::Vector3d& corner, const Eigen::Vector3d& one,
                const Eigen::Vector3d& other) {
  const Eigen::Vector3d first = one - corner, second = other - corner;
  return std::atan2(first.cross(second).norm(), first.dot(second));
}

/// Checks one pass, and refuses it by name.
class PassCheck {
 public:
  PassCheck(const ScanPass& pass, std::size_t index, const ScanLimits& limits)
      : pass_(pass), name_(pass_name(pass, index)), limits_(limits) {}

  void run() const {
    check_poses();
    check_range("speed", pass_.speed, 0, limits_.max_speed, "m/s", "");
    check_range("frame rate", pass_.rate, limits_.min_rate, limits_.max_rate, "Hz",
                ": the loss of a slower camera would be noticed too late");
    check_exposure();
    check_length();
    if (pass_.kind == PassKind::kArc) check_turn();
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& value,
                           const std::string& cure) const {
    throw Refused(name_ + ": " + what, value, cure);
  }

  void check_poses() const {
    const std::size_t count = pass_.poses.size();
    const std::size_t least = pass_.kind == PassKind::kArc ? 3 : 2;
    const std::size_t most = pass_.kind == PassKind::kPolyline ? kMaxPoses : least;
    if (count < least || count > most) {
      refuse("poses", fmt::format("{}", count),
             least == most ? fmt::format("give {}", least)
                           : fmt::format("give {} to {}", least, most));
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!pass_.poses[i].matrix().allFinite())
        refuse(fmt::format("pose {}", i + 1), "not finite", "give a pose of finite numbers");
    }
  }

  void check_range(const std::string& what, double value, double least, double most,
                   const std::string& unit, const std::string& why) const {
    if (value > 0 && value >= least && value <= most) return;  // refuses NaN too
    refuse(what, fmt::format("{:g} {}", value, unit),
           least > 0 ? fmt::format("give one from {:g} to {:g} {}{}", least, most, unit, why)
                     : fmt::format("give one above 0, up to {:g} {}", most, unit));
  }

  void check_exposure() const {
    if (!pass_.camera.exposure) return;
    const double exposure = *pass_.camera.exposure, period = 1 / pass_.rate;
    if (exposure > 0 && exposure < period) return;  // refuses NaN too
    refuse("exposure", fmt::format("{:g} s", exposure),
           fmt::format("give one above 0 and below the frame period of {:g} s", period));
  }

  void check_length() const {
    for (std::size_t i = 1; i < pass_.poses.size(); ++i) {
      const double apart = (pass_.poses[i].translation() - pass_.poses[i - 1].translation()).norm();
      if (apart < limits_.min_length) {
        refuse(fmt::format("pose {}", i + 1),
               fmt::format("{:g} mm from the one before", 1e3 * apart),
               fmt::format("put them at least {:g} mm apart", 1e3 * limits_.min_length));
      }
    }
    const double whole = length(pass_);
    if (std::isnan(whole)) {
      refuse("arc", "its three poses do not define a circle",
             "move the middle pose off the line from start to end, or give a line");
    }
    if (whole > limits_.max_length) {
      refuse("length", fmt::format("{:g} m", whole),
             fmt::format("give a path of at most {:g} m", limits_.max_length));
    }
  }

  /// Between two poses the flange turns the shorter way round. If they are more than half the
  /// circle apart, a flange that should turn with the arc would turn back.
  void check_turn() const {
    const auto& poses = pass_.poses;
    const auto point = [&poses](std::size_t i) { return poses[i].translation(); };
    const Eigen::Vector3d axis = (point(1) - point(0)).cross(point(2) - point(0)).normalized();
    for (std::size_t i = 1; i < 3; ++i) {
      const std::size_t third = i == 1 ? 2 : 0;
      const double sweep = 2 * angle_at(point(third), point(i - 1), point(i));
      const Eigen::AngleAxisd turn(poses[i].linear() * poses[i - 1].linear().transpose());
      const double back = -turn.angle() * turn.axis().dot(axis);
      if (sweep <= M_PI || back < kTurnsBack) continue;
      refuse(fmt::format("arc from pose {} to pose {}", i, i + 1),
             fmt::format("goes round by {:.0f} deg while the flange turns back by {:.0f} deg",
                         degrees(sweep), degrees(back)),
             "put via near the middle, or split the arc into two passes");
    }
  }

  const ScanPass& pass_;
  const std::string name_;
  const ScanLimits& limits_;
};

/// Length of the arc through three points, from the first over the second to the third. The angle
/// at the centre is twice that at the circumference.
double arc_length(const Eigen::Vector3d& start, const Eigen::Vector3d& via,
                  const Eigen::Vector3d& end) {
  constexpr double kStraight = 1e-3;  // [rad] chosen: over 0.1 m the arc bulges by 25 um
  const double at_via = angle_at(via, start, end);
  const double half = M_PI - at_via;  // half of the arc's angle at the centre
  if (half < kStraight || at_via < kStraight) return std::numeric_limits<double>::quiet_NaN();
  const double radius = (end - start).norm() / (2 * std::sin(at_via));
  return 2 * half * radius;
}

}  // namespace

bool operator==(const CameraRegion& one, const CameraRegion& other) {
  return std::tie(one.x, one.y, one.width, one.height) ==
         std::tie(other.x, other.y, other.width, other.height);
}

bool operator==(const PassCamera& one, const PassCamera& other) {
  return one.exposure == other.exposure && one.region == other.region &&
         one.detector == other.detector;
}

std::string pass_name(const ScanPass& pass, std::size_t index) {
  return fmt::format("pass {}{}", index + 1, pass.name.empty() ? "" : " (" + pass.name + ")");
}

double length(const ScanPass& pass) {
  const auto point = [&pass](std::size_t i) { return pass.poses[i].translation(); };
  if (pass.kind == PassKind::kArc) return arc_length(point(0), point(1), point(2));
  double sum = 0;
  for (std::size_t i = 1; i < pass.poses.size(); ++i)
    sum += (point(i) - point(i - 1)).norm();
  return sum;
}

void check(const ScanRequest& request, const ScanLimits& limits) {
  if (request.passes.empty() || request.passes.size() > kMaxPasses) {
    throw Refused("passes", fmt::format("{}", request.passes.size()),
                  fmt::format("give 1 to {}", kMaxPasses));
  }
  for (std::size_t i = 0; i < request.passes.size(); ++i)
    PassCheck(request.passes[i], i, limits).run();
}

}  // namespace scan_cell
