// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "poses/pose_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/pose/units.h"

namespace pose_frame_binder {

std::array<double, 6> to_document_units(const Eigen::Isometry3d& pose) {
  using scan_cell_common::kDegrees;
  using scan_cell_common::kMillimetres;
  constexpr double kUpright = 1e-9;  // cos(ry) below which rx and rz share an axis; chosen
  const Eigen::Matrix3d r = pose.linear();
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  const double ry = std::atan2(-r(2, 0), cosine);
  const double rz =
      cosine > kUpright ? std::atan2(r(1, 0), r(0, 0)) : std::atan2(-r(0, 1), r(1, 1));
  const double rx = cosine > kUpright ? std::atan2(r(2, 1), r(2, 2)) : 0;
  const Eigen::Vector3d p = pose.translation() * kMillimetres;
  return {p.x(), p.y(), p.z(), rx * kDegrees, ry * kDegrees, rz * kDegrees};
}

void PoseTable::add(std::uint64_t frame_counter, const Eigen::Isometry3d& pose) {
  entries_.push_back({frame_counter, to_document_units(pose)});
}

void PoseTable::seal() {
  std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.frame_counter < b.frame_counter;
  });
}

std::string PoseTable::answer(std::string_view line) const {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = std::min(line.find_first_not_of(kBlanks), line.size());
  const std::size_t end = line.find_last_not_of(kBlanks) + 1;  // 0 if there are only blanks
  const std::optional<std::uint64_t> number =
      scan_cell_common::parse_count(line.substr(begin, end > begin ? end - begin : 0));
  if (!number) return "ERROR '" + scan_cell_common::excerpt(line) + "' is not a frame number";
  const auto before = [](const Entry& entry, std::uint64_t n) { return entry.frame_counter < n; };
  const auto found = std::lower_bound(entries_.begin(), entries_.end(), *number, before);
  if (found == entries_.end() || found->frame_counter != *number) return "NONE";
  if (found + 1 != entries_.end() && (found + 1)->frame_counter == *number) {
    return "ERROR the camera was restarted: several frames have this number";
  }
  const std::array<double, 6>& pose = found->pose;
  std::array<char, 256> text;
  std::snprintf(text.data(), text.size(), "%.6f,%.6f,%.6f,%.9f,%.9f,%.9f", pose[0], pose[1],
                pose[2], pose[3], pose[4], pose[5]);
  return text.data();
}

}  // namespace pose_frame_binder
