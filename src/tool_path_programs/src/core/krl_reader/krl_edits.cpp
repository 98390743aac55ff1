// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <map>

#include "krl_reader/krl_reader.h"
#include "krl_values/krl_values.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

constexpr double kSame = 1e-9;  // [m], [rad]

bool same_turn(const Eigen::Isometry3d& one, const Eigen::Isometry3d& two) {
  return (one.linear() - two.linear()).cwiseAbs().maxCoeff() <= kSame;
}

/// For each pose, where the motion before the first one to it ended: an incomplete literal takes
/// the missing numbers from there.
std::vector<std::optional<std::size_t>> poses_before(const ProgramText& text) {
  std::vector<std::optional<std::size_t>> before(text.poses.size());
  std::vector<bool> known(text.poses.size(), false);
  std::optional<std::size_t> last;
  for (std::size_t step = 0; step < text.steps.size(); ++step) {
    if (std::holds_alternative<SetOutput>(text.program.steps[step])) continue;
    for (const auto& pose : {text.steps[step].via, text.steps[step].pose}) {
      if (!pose || known[*pose]) continue;
      before[*pose] = last;
      known[*pose] = true;
    }
    last = text.steps[step].pose;
  }
  return before;
}

class Literal {
 public:
  Literal(const ProgramText& text, const PoseText& pose)
      : pose_(pose), source_(text.files[pose.place.file].text) {
    const std::string& file = source_;
    const std::size_t end = std::min(file.find('\n', pose.offset), file.size());
    const SourceFile line{text.files[pose.place.file].name,
                          file.substr(pose.offset, end - pose.offset)};
    const auto tokens = tokens_of(line, {{";"}, "\"'", "$#"});
    TokenReader reader(line, 0, tokens);
    numbers_ = read_aggregate(reader).numbers;
    for (std::size_t field = 0; field < kKrlFields.size(); ++field)
      if (const NumberText* number = find(field))
        behind_ = std::max(behind_, number->offset + number->length);
  }

  bool has(std::size_t field) const { return find(field) != nullptr; }

  TextEdit put(std::size_t field, double value) const {
    TextEdit edit{pose_.place.file, pose_.offset + behind_, 0, ""};
    if (const NumberText* number = find(field)) {
      edit.offset = pose_.offset + number->offset;
      edit.length = number->length;
      edit.text = like(std::string_view(source_).substr(edit.offset, edit.length), value,
                       krl_digits(field));
    } else {
      edit.text = std::string(",") + kKrlFields[field] + " " + fixed(value, krl_digits(field));
    }
    return edit;
  }

 private:
  const NumberText* find(std::size_t field) const {
    const auto found = numbers_.find(scan_cell_common::lower_case(kKrlFields[field]));
    return found == numbers_.end() ? nullptr : &found->second;
  }

  const PoseText& pose_;
  const std::string& source_;
  std::map<std::string, NumberText> numbers_;
  std::size_t behind_ = 0;  // end of the last of X Y Z A B C
};

}  // namespace

std::vector<TextEdit> krl_edits(const ProgramText& text,
                                const std::vector<Eigen::Isometry3d>& poses) {
  std::vector<TextEdit> edits;
  const auto before = poses_before(text);
  for (std::size_t i = 0; i < text.poses.size(); ++i) {
    const Eigen::Isometry3d& old = text.poses[i].pose;
    const Literal literal(text, text.poses[i]);
    const KrlNumbers numbers = krl_numbers(poses[i]);
    const bool turns = literal.has(3) || literal.has(4) || literal.has(5);
    const bool all_turns = literal.has(3) && literal.has(4) && literal.has(5);
    for (std::size_t field = 0; field < 3; ++field) {
      const auto axis = static_cast<Eigen::Index>(field);
      const double was = literal.has(field) || !before[i] ? old.translation()[axis]
                                                          : poses[*before[i]].translation()[axis];
      if (std::abs(poses[i].translation()[axis] - was) > kSame)
        edits.push_back(literal.put(field, numbers[field]));
    }
    const Eigen::Isometry3d& turn_before = before[i] ? poses[*before[i]] : old;
    const bool before_turned =
        before[i] && !same_turn(poses[*before[i]], text.poses[*before[i]].pose);
    const bool stays = !turns      ? same_turn(poses[i], turn_before)
                       : all_turns ? same_turn(poses[i], old)
                                   : same_turn(poses[i], old) && !before_turned;
    for (std::size_t field = 3; field < 6 && !stays; ++field)
      edits.push_back(literal.put(field, numbers[field]));
  }
  return edits;
}

}  // namespace tool_path_programs
