// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/rapid_places.h"

#include <algorithm>

namespace tool_path_programs {

RapidPlaces::RapidPlaces(const std::vector<SourceFile>& files) : files_(files) {
  for (const SourceFile& file : files)
    tokens_.push_back(rapid_tokens(file));
}

TokenReader RapidPlaces::reader(std::size_t file, std::size_t offset) const {
  const auto& tokens = tokens_.at(file);
  const auto found =
      std::lower_bound(tokens.begin(), tokens.end(), offset,
                       [](const Token& token, std::size_t byte) { return token.offset < byte; });
  TokenReader reader(files_[file], file, tokens);
  reader.go_to(static_cast<std::size_t>(found - tokens.begin()));
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
