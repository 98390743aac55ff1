// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "binding_errors.h"

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace scan_cell_demo {

using laser_triangulation::ScanPoint;
using laser_triangulation::Triangulator;
using scan_cell_msgs::BoundProfile;
using scan_cell_msgs::BoundProfileConstPtr;

namespace {

constexpr double kMinSpeed =
    0.005;  // [m/s] below this the robot stands still, and binding makes no error

/// Motion of a point fixed to the flange, from true pose to true pose.
struct Kinematics {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      // [m/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  // [m/s^2]
};

/// By device time of the frames, without the first and the last.
std::map<std::uint64_t, Kinematics> kinematics(
    const std::map<std::uint64_t, Eigen::Isometry3d>& truth, const Eigen::Vector3d& carried) {
  std::map<std::uint64_t, Kinematics> all;
  constexpr double kNanosecond = 1e-9;
  if (truth.size() < 3) return all;
  for (auto here = std::next(truth.begin()); std::next(here) != truth.end(); ++here) {
    const auto before = std::prev(here), after = std::next(here);
    const double in = kNanosecond * static_cast<double>(here->first - before->first);
    const double out = kNanosecond * static_cast<double>(after->first - here->first);
    const Eigen::Vector3d place = here->second * carried;
    const Eigen::Vector3d come = (place - before->second * carried) / in;
    const Eigen::Vector3d go = (after->second * carried - place) / out;
    all[here->first] = {(come * out + go * in) / (in + out), (go - come) * 2 / (in + out)};
  }
  return all;
}

MedianAndMax summary(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.back()};
}

std::map<std::uint64_t, BoundProfileConstPtr> by_time(const Scan::Bound& bound) {
  std::map<std::uint64_t, BoundProfileConstPtr> all;
  for (const BoundProfileConstPtr& profile : bound.profiles)
    all[profile->profile.device_time] = profile;
  return all;
}

/// Makes points for one method of binding; equal peaks give equal points in the same order.
class CloudMaker {
 public:
  CloudMaker(const scan_cell_common::ScannerModel& scanner,
             const laser_triangulation::PeakLimits& limits)
      : triangulator_(scanner, limits) {}

  void add(const scan_cell_msgs::PeakProfile& peaks, const Eigen::Isometry3d& flange) {
    triangulator_.add({peaks.laser, peaks.first_row, peaks.position.size(), peaks.position.data(),
                       peaks.width.data(), peaks.intensity.data()},
                      flange, points_);
  }

  std::size_t size() const { return points_.size(); }
  Eigen::Vector3d operator[](std::size_t i) const {
    return Eigen::Vector3f(points_[i].x, points_[i].y, points_[i].z).cast<double>();
  }

 private:
  Triangulator triangulator_;
  std::vector<ScanPoint> points_;
};

std::vector<std::size_t> above_board(const CloudMaker& cloud) {
  constexpr double kAboveBoard = 1e-3;  // [m]
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud[i].z() > kAboveBoard) found.push_back(i);
  if (found.empty()) {
    throw scan_cell_common::UnusableInput("the scan", "no point on the part", "scan over the part");
  }
  return found;
}

CloudError error_of(const CloudMaker& cloud, const CloudMaker& perfect,
                    const std::vector<std::size_t>& on_part, const scan_cell_sim::Scene& part) {
  CloudError error;
  for (const std::size_t i : on_part) {
    error.to_surface += std::pow(part.distance_to_surface(cloud[i]), 2);
    error.to_perfect += (cloud[i] - perfect[i]).squaredNorm();
  }
  error.to_surface = std::sqrt(error.to_surface / static_cast<double>(on_part.size()));
  error.to_perfect = std::sqrt(error.to_perfect / static_cast<double>(on_part.size()));
  return error;
}

/// The point where the light meets the camera's axis, in the flange.
Eigen::Vector3d middle_of_line(const scan_cell_common::ScannerModel& scanner) {
  const scan_cell_common::LaserPlane& laser = scanner.laser(0);
  return scanner.flange_to_camera * Eigen::Vector3d(0, 0, laser.distance / laser.normal.z());
}

}  // namespace

BindingErrors compare(const Scan& scan, const scan_cell_common::ScannerModel& scanner,
                      const laser_triangulation::PeakLimits& limits,
                      const scan_cell_sim::Scene& part) {
  const auto motion = kinematics(scan.truth, middle_of_line(scanner));
  const auto others = by_time(scan.first_pose);
  CloudMaker perfect(scanner, limits), interpolated(scanner, limits), first_pose(scanner, limits);
  std::vector<double> speeds, accelerations;
  for (const auto& [time, bound] : by_time(scan.interpolated)) {
    const auto how = motion.find(time);
    const auto other = others.find(time);
    if (how == motion.end() || other == others.end()) continue;
    const double speed = how->second.velocity.norm();
    if (speed < kMinSpeed) continue;
    speeds.push_back(speed);
    accelerations.push_back(how->second.acceleration.norm());
    perfect.add(bound->profile, scan.truth.at(time));
    interpolated.add(bound->profile, scan_cell_common::from_ros(bound->pose));
    first_pose.add(bound->profile, scan_cell_common::from_ros(other->second->pose));
  }
  const std::vector<std::size_t> on_part = above_board(perfect);
  BindingErrors errors;
  errors.frames = speeds.size();
  errors.points = on_part.size();
  errors.speed = summary(speeds);
  errors.acceleration = summary(accelerations);
  errors.perfect = error_of(perfect, perfect, on_part, part);
  errors.interpolated = error_of(interpolated, perfect, on_part, part);
  errors.first_pose = error_of(first_pose, perfect, on_part, part);
  return errors;
}

MedianAndMax pulse_delay(const Scan& scan) {
  std::vector<double> delays;
  for (const BoundProfileConstPtr& bound : scan.interpolated.profiles) {
    const auto truth = static_cast<std::int64_t>(bound->profile.device_time);
    delays.push_back(scan_cell_common::to_seconds(
        static_cast<std::int64_t>(bound->header.stamp.toNSec()) - truth));
  }
  std::sort(delays.begin(), delays.end());
  const double most = std::max(delays.back(), -delays.front());
  return {delays[delays.size() / 2], most};
}

double true_pose_delay(const Scan& scan) {
  const auto motion = kinematics(scan.truth, Eigen::Vector3d::Zero());
  double behind = 0, squares = 0;
  for (const auto& [time, bound] : by_time(scan.interpolated)) {
    const auto how = motion.find(time);
    if (how == motion.end()) continue;
    const Eigen::Vector3d& velocity = how->second.velocity;
    const Eigen::Vector3d lag =
        scan.truth.at(time).translation() - scan_cell_common::from_ros(bound->pose).translation();
    behind += velocity.dot(lag);
    squares += velocity.squaredNorm();
  }
  if (squares <= 0)
    throw scan_cell_common::UnusableInput("the scan", "no motion", "scan along a line");
  return behind / squares;
}

}  // namespace scan_cell_demo
