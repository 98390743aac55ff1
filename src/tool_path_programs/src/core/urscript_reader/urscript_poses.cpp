// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>

#include "text/number_text.h"
#include "text/rotation_vector.h"
#include "text/token_reader.h"
#include "tool_path_programs/source_text.h"
#include "urscript_reader/urscript_reader.h"

namespace tool_path_programs {
namespace {

/// The six numbers of a pose, with their places in the text.
class PoseNumbers {
 public:
  PoseNumbers(const SourceFile& file, std::size_t file_index)
      : tokens_(tokens_of(file, {{"#"}, "\"", ""})),
        file_(file),
        reader_(file, file_index, tokens_) {}

  std::array<NumberText, 6> at(std::size_t offset) {
    reader_.go_to_byte(offset);
    reader_.expect("p");
    std::array<NumberText, 6> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      reader_.expect(i == 0 ? '[' : ',');
      while (!reader_.at_end() && reader_.at_line_end())
        reader_.next();
      numbers[i] = reader_.number();
      while (!reader_.at_end() && reader_.at_line_end())
        reader_.next();
    }
    return numbers;
  }

  std::string text(const NumberText& number) const {
    return file_.text.substr(number.offset, number.length);
  }

 private:
  std::vector<Token> tokens_;
  const SourceFile& file_;
  TokenReader reader_;
};

Eigen::Vector3d values(const std::array<NumberText, 6>& numbers, std::size_t first) {
  return {numbers[first].value, numbers[first + 1].value, numbers[first + 2].value};
}

/// Numbers that do not change visibly keep their digits.
class PoseEdits {
 public:
  PoseEdits(PoseNumbers& numbers, std::vector<TextEdit>& edits)
      : numbers_(numbers), edits_(edits) {}

  void add(const PoseText& old, const Eigen::Isometry3d& pose) {
    file_ = old.place.file;
    const std::array<NumberText, 6> six = numbers_.at(old.offset);
    constexpr double kSame = 1e-9;
    const Eigen::Vector3d position = pose.translation();
    for (Eigen::Index i = 0; i < 3; ++i)
      if (std::abs(position[i] - six[i].value) > kSame) add(six[i], position[i]);
    const Eigen::Vector3d old_turn = values(six, 3);
    if ((rotation_of(old_turn) - pose.linear()).norm() <= kSame) return;
    const Eigen::Vector3d turn = rotation_vector_near(pose.linear(), old_turn);
    for (Eigen::Index i = 0; i < 3; ++i)
      if (std::abs(turn[i] - six[i + 3].value) > kSame) add(six[i + 3], turn[i]);
  }

 private:
  void add(const NumberText& old, double number) {
    const std::string old_text = numbers_.text(old);
    const std::string text = like(old_text, number, kScriptDigits);
    if (text != old_text) edits_.push_back({file_, old.offset, old.length, text});
  }

  PoseNumbers& numbers_;
  std::vector<TextEdit>& edits_;
  std::size_t file_ = 0;
};

}  // namespace

std::vector<TextEdit> edits_of_urscript(const ProgramText& text,
                                        const std::vector<Eigen::Isometry3d>& poses) {
  std::vector<TextEdit> edits;
  for (std::size_t file = 0; file < text.files.size(); ++file) {
    PoseNumbers numbers(text.files[file], file);
    PoseEdits pose_edits(numbers, edits);
    for (std::size_t i = 0; i < text.poses.size(); ++i)
      if (text.poses[i].place.file == file) pose_edits.add(text.poses[i], poses.at(i));
  }
  return edits;
}

}  // namespace tool_path_programs
