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

/// Builds the cloud of one scan from messages.
class CloudBuilder {
 public:
  /// @param max_points held in memory (36 bytes each)
  /// @param deviations [m] standard deviations of a scanned point, by laser, from the calibration;
  /// empty: the passes are compared but not corrected
  CloudBuilder(const scan_cell_common::ScannerModel& model, const PeakLimits& limits,
               std::size_t max_points, const std::vector<double>& deviations = {});

  /// @throw scan_cell_common::UnusableInput if the profile's arrays, laser, pose or frame are
  /// invalid; nothing is added
  /// @throw scan_cell_common::Refused if the points exceed max_points, or after bring_together()
  /// has moved some
  void add(const scan_cell_msgs::BoundProfile& profile);

  std::uint64_t profiles() const { return triangulator_.counts().profiles; }
  const ScanCloud& points() const { return points_; }

  /// The points from `first` on, with the frame of the profiles and the stamp of the last pulse.
  sensor_msgs::PointCloud2 cloud(std::size_t first = 0) const;

  /// Compares the passes, once, and corrects what the calibration's uncertainty explains. Takes a
  /// second or two for a large scan.
  void bring_together();

  /// The statistics; after bring_together() with the agreement of the passes.
  scan_cell_msgs::CloudStatistics statistics(const std::string& scan_id) const;

  /// For a person: what became of every row.
  std::string summary() const;

  /// For a person: the pass and laser whose profiles gave no point at all; empty: there is none.
  std::string find_dark_sweep() const;

  /// For a person: whether the passes agree; one line per pair if there are several (at most ten),
  /// and one per correction.
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
  std::optional<PassAgreement> agreement_;  // once compared
  std::vector<ScanPoint> profile_;          // the points of the last profile
  std_msgs::Header header_;
  double seconds_ = 0;
};

}  // namespace laser_triangulation
