// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "scan_calibration/session.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/csv_reader.h"

namespace scan_calibration {
namespace {

using scan_cell_common::CsvReader;

constexpr std::size_t kPoseColumns = 8;  // image, x, y, z, qx, qy, qz, qw

/// For each laser, the column that names its images; none: the line is in the board image.
std::vector<std::size_t> laser_columns(const CsvReader& table,
                                       const std::vector<std::string>& lasers) {
  const auto& head = table.fields();
  const std::vector<std::string_view> pose = {"image", "x", "y", "z", "qx", "qy", "qz", "qw"};
  if (head.size() < kPoseColumns || !std::equal(pose.begin(), pose.end(), head.begin())) {
    table.refuse("wrong header",
                 "begin with image,x,y,z,qx,qy,qz,qw and a column for each laser: laser_0");
  }
  std::vector<std::size_t> columns;
  for (const std::string& laser : lasers) {
    const auto at = std::find(head.begin() + kPoseColumns, head.end(), laser);
    if (at != head.end()) columns.push_back(static_cast<std::size_t>(at - head.begin()));
  }
  for (std::size_t i = kPoseColumns; i < head.size(); ++i) {
    if (std::find(lasers.begin(), lasers.end(), head[i]) == lasers.end() ||
        std::find(head.begin() + kPoseColumns, head.begin() + static_cast<long>(i), head[i]) !=
            head.begin() + static_cast<long>(i)) {
      table.refuse(fmt::format("column '{}'", head[i]),
                   "name each laser of session.yaml once, and nothing else");
    }
  }
  if (columns.size() == lasers.size() || (columns.empty() && lasers.size() == 1)) return columns;
  table.refuse(fmt::format("columns for {} of {} lasers", columns.size(), lasers.size()),
               "add a column for each laser: several lines in one image cannot be told apart");
}

}  // namespace

std::vector<SessionView> parse_session_poses(const std::string& text, const std::string& name,
                                             const std::vector<std::string>& lasers) {
  CsvReader table(text, name);
  if (!table.next()) {
    throw scan_cell_common::UnusableInput(name, "empty", "begin with image,x,y,z,qx,qy,qz,qw");
  }
  const std::size_t width = table.fields().size();
  const std::vector<std::size_t> columns = laser_columns(table, lasers);
  std::vector<SessionView> views;
  std::map<std::string, std::size_t, std::less<>> lines;  // of files named so far
  const auto take = [&](std::string_view file) {
    const auto [known, added] = lines.emplace(file, table.line());
    if (!added) {
      table.refuse(fmt::format("'{}' repeated, first in line {}", file, known->second),
                   "give each view files of its own");
    }
    return std::string(file);
  };
  while (table.next()) {
    table.expect_fields(width);
    if (table.field(0).empty()) table.refuse("no image", "name the image that shows the board");
    SessionView view;
    view.name = view.board_image = take(table.field(0));
    view.base_to_flange = table.pose(1);
    for (const std::size_t column : columns) {
      const std::string_view file = table.field(column);
      const bool own = !file.empty() && !(lasers.size() == 1 && file == view.board_image);
      view.lines.push_back(own ? take(file) : std::string(file));
    }
    if (columns.empty() && !lasers.empty()) view.lines = {view.board_image};
    views.push_back(view);
  }
  return views;
}

std::string session_poses_text(const std::vector<SessionView>& views,
                               const std::vector<std::string>& lasers) {
  std::string text = "image,x,y,z,qx,qy,qz,qw";
  for (const std::string& laser : lasers)
    text += "," + laser;
  text += "\n";
  for (const SessionView& view : views) {
    const Eigen::Vector3d p = view.base_to_flange.translation();
    const Eigen::Quaterniond q(view.base_to_flange.linear());
    const double numbers[] = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
    text += view.board_image;
    for (const double number : numbers)
      text += fmt::format(",{:.17g}", number);
    for (const std::string& line : view.lines)
      text += "," + line;
    text += "\n";
  }
  return text;
}

}  // namespace scan_calibration
