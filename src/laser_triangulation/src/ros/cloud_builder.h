// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/BoundProfile.h>
#include <scan_cell_msgs/CloudStatistics.h>
#include <sensor_msgs/PointCloud2.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pass_agreement.h"

namespace laser_triangulation {

/// The cloud of one scan, from messages.
class CloudBuilder {
 public:
  /// @param max_points held in memory (36 bytes each)
  /// @param deviations [m] of a scanned point, by laser, as the calibration leaves them; none: the
  /// passes are compared, not mended
  CloudBuilder(const scan_cell_common::ScannerModel& model, const PeakLimits& limits,
               std::size_t max_points, const std::vector<double>& deviations = {});

  /// @throw scan_cell_common::UnusableInput if the profile's arrays, laser, pose or frame are
  /// invalid; nothing is added
  /// @throw scan_cell_common::Refused if the points do not fit, or after bring_together() has moved
  /// some
  void add(const scan_cell_msgs::BoundProfile& profile);

  std::uint64_t profiles() const { return triangulator_.counts().profiles; }
  const ScanCloud& points() const { return points_; }

  /// The points from `first` on. Frame: the profiles'; stamp: the last pulse's.
  sensor_msgs::PointCloud2 cloud(std::size_t first = 0) const;

  /// Compares the passes, once, and mends what the calibration's uncertainty explains. Takes a
  /// second or two of a large scan.
  void bring_together();

  /// With the agreement of the passes, after bring_together().
  scan_cell_msgs::CloudStatistics statistics(const std::string& scan_id) const;

  /// For a person: what became of every row.
  std::string summary() const;

  /// For a person: the pass and the laser that had profiles but no point in any; empty: all had.
  std::string find_dark_sweep() const;

  /// For a person: whether the passes agree, one line a pair where there are several (at most
  /// ten), one a correction.
  static std::vector<std::string> agreement_lines(
      const scan_cell_msgs::CloudStatistics& statistics);

 private:
  void check(const scan_cell_msgs::BoundProfile& bound, const std::string& name) const;

  Triangulator triangulator_;
  /// A pass with one of its lasers.
  struct Sweep {
    std::uint64_t profiles = 0;
    std::uint64_t points = 0;
  };
  std::vector<std::uint64_t> points_of_laser_;
  std::map<std::pair<std::uint8_t, std::uint8_t>, Sweep> sweeps_;  // by pass and laser
  std::size_t max_points_;
  std::vector<double> deviations_;
  ScanCloud points_;
  std::optional<PassAgreement> agreement_;  // once they were compared
  std::vector<ScanPoint> profile_;          // the points of the last
  std_msgs::Header header_;
  double seconds_ = 0;
};

}  // namespace laser_triangulation
