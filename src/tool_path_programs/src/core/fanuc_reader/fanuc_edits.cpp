// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "fanuc_reader/fanuc_angles.h"
#include "fanuc_reader/fanuc_reader.h"
#include "fanuc_reader/fanuc_source.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

class Edits {
 public:
  explicit Edits(const ProgramText& text) : text_(text) {
    for (const SourceFile& file : text.files)
      tokens_.push_back(fanuc_tokens(file));
  }

  void add(const PoseText& old, const Eigen::Isometry3d& pose) {
    if ((old.pose.matrix() - pose.matrix()).norm() < 1e-10) return;
    TokenReader reader = at(old);
    const FanucPosition position = read_fanuc_position(reader);
    const bool place_stays = (old.pose.translation() - pose.translation()).norm() < 1e-10;
    const bool turn_stays = (old.pose.linear() - pose.linear()).norm() < 1e-10;
    const std::string& source = text_.files[old.place.file].text;
    std::array<int, 6> digits{};
    for (std::size_t i = 0; i < digits.size(); ++i)
      digits[i] = digits_of(source.substr(position.pose[i]->offset, position.pose[i]->length));
    const FanucPose numbers = fanuc_pose(pose, {digits[3], digits[4], digits[5]});
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i < 3 ? place_stays : turn_stays) continue;
      const NumberText& number = *position.pose[i];
      const std::string now = fixed(numbers[i], digits[i]);
      if (now != fixed(number.value, digits[i]))
        edits.push_back({old.place.file, number.offset, number.length, now});
    }
  }

  std::vector<TextEdit> edits;

 private:
  TokenReader at(const PoseText& pose) const {
    const std::size_t file = pose.place.file;
    TokenReader reader(text_.files[file], file, tokens_.at(file));
    reader.go_to_byte(pose.offset);
    return reader;
  }

  /// Decimals of the old number, at least those needed.
  static int digits_of(const std::string& text) {
    const std::size_t point = text.find('.');
    if (point == std::string::npos) return kFanucDigits;
    const std::size_t end = std::min(text.find_first_of("eE"), text.size());
    return std::clamp(static_cast<int>(end - point) - 1, kFanucDigits, 12);
  }

  const ProgramText& text_;
  std::vector<std::vector<Token>> tokens_;
};

}  // namespace

std::vector<TextEdit> fanuc_edits(const ProgramText& text,
                                  const std::vector<Eigen::Isometry3d>& poses) {
  Edits edits(text);
  for (std::size_t i = 0; i < text.poses.size(); ++i)
    edits.add(text.poses[i], poses.at(i));
  return std::move(edits.edits);
}

}  // namespace tool_path_programs
