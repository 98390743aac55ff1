// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/rapid_places.h"

namespace tool_path_programs {

RapidPlaces::RapidPlaces(const std::vector<SourceFile>& files) : files_(files) {
  for (const SourceFile& file : files)
    tokens_.push_back(rapid_tokens(file));
}

TokenReader RapidPlaces::reader(std::size_t file, std::size_t offset) const {
  TokenReader reader(files_[file], file, tokens_.at(file));
  reader.go_to_byte(offset);
  return reader;
}

std::array<double, 7> rapid_numbers(const Eigen::Isometry3d& pose, const RapidPose& old) {
  Eigen::Quaterniond turn(pose.linear());
  turn.normalize();
  const Eigen::Vector4d before(old.numbers[3].value, old.numbers[4].value, old.numbers[5].value,
                               old.numbers[6].value);
  Eigen::Vector4d now(turn.w(), turn.x(), turn.y(), turn.z());
  if (now.dot(before) < 0) now = -now;
  const Eigen::Vector3d place = 1e3 * pose.translation();
  return {place.x(), place.y(), place.z(), now[0], now[1], now[2], now[3]};
}

}  // namespace tool_path_programs
