// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "scan_cell_common/ros/conversions.h"

namespace laser_triangulation {

using scan_cell_common::UnusableInput;
using scan_cell_msgs::BoundProfile;
using sensor_msgs::PointCloud2;

namespace {

Eigen::Isometry3d pose_of(const BoundProfile& bound, const std::string& name) {
  constexpr const char* kCure = "check the node that bound the profile";
  const geometry_msgs::Point& p = bound.pose.position;
  if (!std::isfinite(p.x + p.y + p.z))
    throw UnusableInput(name, "its position is not finite", kCure);
  return scan_cell_common::checked_from_ros(bound.pose, name, kCure);
}

void add_agreement(const PassAgreement& agreement, scan_cell_msgs::CloudStatistics& statistics) {
  statistics.agreement = static_cast<std::uint8_t>(agreement.agreement);
  statistics.agreement_message = agreement.message;
  for (const PassOverlap& overlap : agreement.overlaps) {
    scan_cell_msgs::PassOverlap& message = statistics.overlaps.emplace_back();
    message.pass_one = overlap.one.pass;
    message.laser_one = overlap.one.laser;
    message.pass_other = overlap.other.pass;
    message.laser_other = overlap.other.laser;
    message.points = overlap.points;
    message.median = overlap.median;
    message.most = overlap.most;
    message.apart = overlap.apart;
  }
  if (!agreement.correction) return;
  const auto vector = [](const Eigen::Vector3d& from) {
    geometry_msgs::Vector3 to;
    to.x = from.x(), to.y = from.y(), to.z = from.z();
    return to;
  };
  for (std::size_t i = 0; i < agreement.sweeps.size(); ++i) {
    scan_cell_msgs::PassCorrection& message = statistics.corrections.emplace_back();
    message.pass_index = agreement.sweeps[i].pass;
    message.laser = agreement.sweeps[i].laser;
    message.shift = vector(agreement.correction->motions[i].shift);
    message.turn = vector(agreement.correction->motions[i].turn);
  }
}

}  // namespace

CloudBuilder::CloudBuilder(const scan_cell_common::ScannerModel& model, const PeakLimits& limits,
                           std::size_t max_points, const std::vector<double>& deviations)
    : triangulator_(model, limits),
      points_of_laser_(model.lasers.size()),
      max_points_(max_points),
      deviations_(deviations) {}

void CloudBuilder::check(const BoundProfile& bound, const std::string& name) const {
  const scan_cell_msgs::PeakProfile& profile = bound.profile;
  if (agreement_ && agreement_->correction) {
    throw scan_cell_common::Refused(name, "it came after the passes were brought together",
                                    "wait longer for late profiles, or scan again");
  }
  const std::size_t rows = profile.position.size();
  if (profile.width.size() != rows || profile.intensity.size() != rows) {
    throw UnusableInput(name, "arrays of different lengths", "check the camera node");
  }
  if (profile.laser >= points_of_laser_.size()) {
    throw UnusableInput(
        name, fmt::format("laser {}", profile.laser),
        fmt::format("the scanner model has {} laser(s); scan with one at a time, or set "
                    "the profile's laser",
                    points_of_laser_.size()));
  }
  if (!triangulator_.has_laser(profile.laser)) {
    const std::string laser = scan_cell_common::laser_name(profile.laser);
    throw UnusableInput(name, laser + " is not calibrated",
                        "calibrate it, or scan with a laser that the scanner model has");
  }
  if (bound.pass_index > std::numeric_limits<std::uint8_t>::max())
    throw UnusableInput(name, fmt::format("pass {}", bound.pass_index),
                        "scan in at most 256 passes");
  if (profiles() > 0 && bound.header.frame_id != header_.frame_id) {
    throw UnusableInput(name, "in frame " + bound.header.frame_id,
                        "the scan is in " + header_.frame_id + "; bind it in one frame");
  }
  if (points_.size() + rows > max_points_) {
    throw scan_cell_common::Refused("cloud", fmt::format("full with {} points", points_.size()),
                                    "raise max_points, or make the scan shorter");
  }
}

void CloudBuilder::add(const BoundProfile& bound) {
  const scan_cell_msgs::PeakProfile& profile = bound.profile;
  const std::string name = fmt::format("profile of frame {}", profile.frame_counter);
  check(bound, name);
  const auto pass = static_cast<std::uint8_t>(bound.pass_index);
  const Eigen::Isometry3d pose = pose_of(bound, name);
  const auto begin = std::chrono::steady_clock::now();
  header_ = bound.header;
  profile_.clear();
  triangulator_.add({profile.laser, profile.first_row, profile.position.size(),
                     profile.position.data(), profile.width.data(), profile.intensity.data(), pass},
                    pose, profile_);
  points_.append(profile_);
  agreement_.reset();
  points_of_laser_[profile.laser] += profile_.size();
  Sweep& sweep = sweeps_[{pass, profile.laser}];
  ++sweep.profiles;
  sweep.points += profile_.size();
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

PointCloud2 CloudBuilder::cloud(std::size_t first) const {
  scan_cell_common::FieldedCloud cloud{scan_point_fields(), sizeof(ScanPoint), {}};
  cloud.bytes.resize((points_.size() - first) * sizeof(ScanPoint));
  points_.copy(first, cloud.bytes.data());
  std_msgs::Header header;
  header.stamp = header_.stamp;
  header.frame_id = header_.frame_id;
  return scan_cell_common::to_message(std::move(cloud), header);
}

scan_cell_msgs::CloudStatistics CloudBuilder::statistics(const std::string& scan_id) const {
  const PeakCounts& counts = triangulator_.counts();
  scan_cell_msgs::CloudStatistics statistics;
  statistics.scan_id = scan_id;
  statistics.profiles = counts.profiles;
  statistics.points = counts.points;
  statistics.rows_without_peak = counts.rows_without_peak;
  statistics.rejected = counts.rejected();
  statistics.rejected_by_width = counts.by_width;
  statistics.rejected_by_intensity = counts.by_intensity;
  statistics.rejected_by_range = counts.by_range;
  statistics.outside_sensor = counts.outside_sensor;
  statistics.points_of_laser = points_of_laser_;
  statistics.seconds = seconds_;
  if (agreement_) add_agreement(*agreement_, statistics);
  return statistics;
}

void CloudBuilder::bring_together() {
  if (!agreement_) agreement_ = laser_triangulation::bring_together(points_, deviations_);
}

std::vector<std::string> CloudBuilder::agreement_lines(
    const scan_cell_msgs::CloudStatistics& statistics) {
  using scan_cell_common::kDegrees;
  using scan_cell_common::kMillimetres;
  constexpr std::size_t kMaxPairs = 10;  // chosen
  std::vector<std::string> lines;
  if (!statistics.agreement_message.empty()) lines.push_back(statistics.agreement_message);
  // The message already has the figures of the worst pair.
  const std::size_t overlaps = statistics.overlaps.size() > 1 ? statistics.overlaps.size() : 0;
  const std::size_t pairs = std::min(kMaxPairs, overlaps);
  for (std::size_t i = 0; i < pairs; ++i) {
    const scan_cell_msgs::PassOverlap& overlap = statistics.overlaps[i];
    lines.push_back(fmt::format("{} and {}: {:.3f} mm apart, 95 % within {:.3f} mm",
                                name_of({overlap.pass_one, overlap.laser_one}),
                                name_of({overlap.pass_other, overlap.laser_other}),
                                kMillimetres * overlap.median, kMillimetres * overlap.most));
  }
  if (pairs < overlaps) lines.push_back(fmt::format("and {} more pairs", overlaps - pairs));
  for (const scan_cell_msgs::PassCorrection& correction : statistics.corrections) {
    const geometry_msgs::Vector3& shift = correction.shift;
    const geometry_msgs::Vector3& turn = correction.turn;
    lines.push_back(fmt::format("{} was moved by {:.3f} mm and {:.4f} degrees",
                                name_of({correction.pass_index, correction.laser}),
                                kMillimetres * std::hypot(shift.x, shift.y, shift.z),
                                kDegrees * std::hypot(turn.x, turn.y, turn.z)));
  }
  return lines;
}

std::string CloudBuilder::find_dark_sweep() const {
  for (const auto& [name, sweep] : sweeps_) {
    if (sweep.points > 0) continue;
    return fmt::format(
        "pass {}: {} gave no line in {} profiles; is it on, is the part within its range, and is "
        "the camera's exposure long enough?",
        name.first + 1, scan_cell_common::laser_name(name.second), sweep.profiles);
  }
  return "";
}

std::string CloudBuilder::summary() const {
  const PeakCounts& counts = triangulator_.counts();
  std::ostringstream text;
  text << counts.points << " points from " << counts.profiles
       << " profiles; rows without a peak: " << counts.rows_without_peak
       << "; rejected by width: " << counts.by_width << ", by intensity: " << counts.by_intensity
       << ", by range: " << counts.by_range << ", outside the sensor: " << counts.outside_sensor;
  return text.str();
}

}  // namespace laser_triangulation
