// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "pdl2_reader/pdl2_reader.h"
#include "pdl2_reader/pdl2_values.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

constexpr double kSame = 1e-9;  // [m], elements of a rotation matrix

}  // namespace

std::vector<TextEdit> pdl2_edits(const ProgramText& text,
                                 const std::vector<Eigen::Isometry3d>& poses) {
  std::vector<TextEdit> edits;
  for (std::size_t i = 0; i < text.poses.size(); ++i) {
    const PoseText& old = text.poses[i];
    const Eigen::Vector3d shift = poses[i].translation() - old.pose.translation();
    const bool turned = !((poses[i].linear() - old.pose.linear()).cwiseAbs().maxCoeff() <= kSame);
    if (!turned && shift.cwiseAbs().maxCoeff() <= kSame) continue;
    const SourceFile& file = text.files[old.place.file];
    const Pdl2Pose literal = pdl2_pose_at(file, old.offset);
    const Pdl2Numbers numbers = pdl2_numbers(poses[i]);
    for (std::size_t field = 0; field < numbers.size(); ++field) {
      if (field < 3 ? std::abs(shift[static_cast<Eigen::Index>(field)]) <= kSame : !turned)
        continue;
      const NumberText& number = literal.numbers[field];
      TextEdit edit{old.place.file, old.offset + number.offset, number.length, ""};
      edit.text = like(std::string_view(file.text).substr(edit.offset, edit.length), numbers[field],
                       pdl2_digits(field));
      edits.push_back(edit);
    }
  }
  return edits;
}

}  // namespace tool_path_programs
