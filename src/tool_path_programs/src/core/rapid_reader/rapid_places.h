// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "rapid_reader/source/rapid_values.h"

namespace tool_path_programs {

/// Tokens of each file, found by byte offset.
class RapidPlaces {
 public:
  /// @param files must outlive it
  explicit RapidPlaces(const std::vector<SourceFile>& files);

  TokenReader reader(std::size_t file, std::size_t offset) const;

 private:
  const std::vector<SourceFile>& files_;
  std::vector<std::vector<Token>> tokens_;
};

/// x y z [mm], q1 to q4 with the sign nearer to the old ones.
std::array<double, 7> rapid_numbers(const Eigen::Isometry3d& pose, const RapidPose& old);

constexpr int kRapidLengthDigits = 4;
constexpr int kRapidQuaternionDigits = 7;

}  // namespace tool_path_programs
