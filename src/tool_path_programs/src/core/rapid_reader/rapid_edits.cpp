// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "rapid_reader/rapid_reader.h"
#include "rapid_reader/rapid_values.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

constexpr int kLengthDigits = 4;
constexpr int kQuaternionDigits = 7;

/// Tokens of each file, and where a byte is among them.
class TokenPlaces {
 public:
  explicit TokenPlaces(const std::vector<SourceFile>& files) : files_(files) {
    for (const SourceFile& file : files)
      tokens_.push_back(rapid_tokens(file));
  }

  TokenReader reader(std::size_t file, std::size_t offset) const {
    const auto& tokens = tokens_.at(file);
    const auto found =
        std::lower_bound(tokens.begin(), tokens.end(), offset,
                         [](const Token& token, std::size_t byte) { return token.offset < byte; });
    TokenReader reader(files_[file], file, tokens);
    reader.go_to(static_cast<std::size_t>(found - tokens.begin()));
    return reader;
  }

 private:
  const std::vector<SourceFile>& files_;
  std::vector<std::vector<Token>> tokens_;
};

/// x y z [mm], q1 to q4 with the sign that is nearer to the old ones.
std::array<double, 7> numbers_of(const Eigen::Isometry3d& pose, const RapidPose& old) {
  Eigen::Quaterniond turn(pose.linear());
  turn.normalize();
  const Eigen::Vector4d before(old.numbers[3].value, old.numbers[4].value, old.numbers[5].value,
                               old.numbers[6].value);
  Eigen::Vector4d now(turn.w(), turn.x(), turn.y(), turn.z());
  if (now.dot(before) < 0) now = -now;
  const Eigen::Vector3d place = 1e3 * pose.translation();
  return {place.x(), place.y(), place.z(), now[0], now[1], now[2], now[3]};
}

bool same_place(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
  return (one.translation() - other.translation()).norm() < 1e-10;
}

bool same_turn(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
  return (one.linear() - other.linear()).norm() < 1e-10;
}

void add_edits(const RapidPose& old, const Eigen::Isometry3d& pose, const SourceFile& source,
               std::size_t file, std::vector<TextEdit>& edits) {
  const std::array<double, 7> numbers = numbers_of(pose, old);
  const bool place_stays = same_place(old.pose(), pose);
  const bool turn_stays = same_turn(old.pose(), pose);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i < 3 ? place_stays : turn_stays) continue;
    const NumberText& number = old.numbers[i];
    const std::string before = source.text.substr(number.offset, number.length);
    const int digits = i < 3 ? kLengthDigits : kQuaternionDigits;
    const std::string text = like(before, numbers[i], digits);
    if (text != like(before, number.value, digits))
      edits.push_back({file, number.offset, number.length, text});
  }
}

}  // namespace

std::vector<TextEdit> rapid_edits(const ProgramText& text,
                                  const std::vector<Eigen::Isometry3d>& poses) {
  const TokenPlaces places(text.files);
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
