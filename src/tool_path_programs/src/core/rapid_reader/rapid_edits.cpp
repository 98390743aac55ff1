// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/rapid_places.h"
#include "rapid_reader/rapid_reader.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

bool same_place(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
  return (one.translation() - other.translation()).norm() < 1e-10;
}

bool same_turn(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
  return (one.linear() - other.linear()).norm() < 1e-10;
}

void add_edits(const RapidPose& old, const Eigen::Isometry3d& pose, const SourceFile& source,
               std::size_t file, std::vector<TextEdit>& edits) {
  const std::array<double, 7> numbers = rapid_numbers(pose, old);
  const bool place_stays = same_place(old.pose(), pose);
  const bool turn_stays = same_turn(old.pose(), pose);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i < 3 ? place_stays : turn_stays) continue;
    const NumberText& number = old.numbers[i];
    const std::string before = source.text.substr(number.offset, number.length);
    const int digits = i < 3 ? kRapidLengthDigits : kRapidQuaternionDigits;
    const std::string text = like(before, numbers[i], digits);
    if (text != like(before, number.value, digits))
      edits.push_back({file, number.offset, number.length, text});
  }
}

}  // namespace

std::vector<TextEdit> rapid_edits(const ProgramText& text,
                                  const std::vector<Eigen::Isometry3d>& poses) {
  const RapidPlaces places(text.files);
  std::vector<TextEdit> edits;
  for (std::size_t i = 0; i < text.poses.size(); ++i) {
    const PoseText& old = text.poses[i];
    TokenReader reader = places.reader(old.place.file, old.offset);
    add_edits(read_rapid_pose(reader), poses.at(i), text.files[old.place.file], old.place.file,
              edits);
  }
  return edits;
}

}  // namespace tool_path_programs
