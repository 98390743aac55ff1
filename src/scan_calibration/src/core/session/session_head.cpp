// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "scan_calibration/session.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {
namespace {

using scan_cell_common::YamlEntry;

constexpr int kMinCorners = 3;    // along a side: OpenCV's detector needs them
constexpr int kMaxCorners = 200;  // along a side, chosen

int corners(const YamlEntry& entry) {
  const int count = entry.as<int>();
  if (count < kMinCorners || count > kMaxCorners) {
    entry.refuse(fmt::format("{}", count),
                 fmt::format("give {} to {} inner corners: one less than squares", kMinCorners,
                             kMaxCorners));
  }
  return count;
}

Board board(const YamlEntry& entry) {
  constexpr double kMinSquare = 1e-4, kMaxSquare = 0.5;  // [m] chosen
  entry.refuse_unknown({"type", "inner_corners", "square_size"});
  const auto type = entry["type"].as<std::string>();
  if (type != "checkerboard") entry["type"].refuse("'" + type + "'", "give checkerboard");
  const std::vector<YamlEntry> sides = entry["inner_corners"].elements();
  if (sides.size() != 2) {
    entry["inner_corners"].refuse(fmt::format("{} numbers", sides.size()),
                                  "give two: [columns, rows]");
  }
  Board result{corners(sides[0]), corners(sides[1]), entry["square_size"].as<double>()};
  if (!(result.square_size >= kMinSquare && result.square_size <= kMaxSquare)) {
    entry["square_size"].refuse(fmt::format("{:g} m", result.square_size),
                                result.square_size > kMaxSquare
                                    ? "give metres: this looks like millimetres"
                                    : "give metres, above 0");
  }
  return result;
}

std::size_t laser_index(const YamlEntry& entry) {
  const auto name = entry.as<std::string>();
  try {
    return scan_cell_common::laser_index(name);
  } catch (const scan_cell_common::UnusableInput&) {
    entry.refuse("'" + name + "'", "name lasers laser_0, laser_1");
  }
}

std::vector<std::string> lasers(const YamlEntry& entry) {
  std::vector<std::string> names;
  std::size_t least = 0;
  for (const YamlEntry& element : entry.elements()) {
    const std::size_t index = laser_index(element);
    names.push_back(element.as<std::string>());
    if (index < least) element.refuse("'" + names.back() + "'", "name each once, in rising order");
    least = index + 1;
  }
  return names;
}

}  // namespace

SessionHead parse_session_head(const std::string& text, const std::string& name) {
  const YamlEntry root = YamlEntry::parse(text, name);
  root.refuse_unknown({"images", "board", "lasers"});
  SessionHead head{root["images"].as<std::string>(), board(root["board"]), lasers(root["lasers"])};
  if (head.poses_file.empty()) root["images"].refuse("empty", "name the CSV of poses: poses.csv");
  return head;
}

std::string session_head_text(const SessionHead& head) {
  return fmt::format(
      "# A calibration session: what was taken at taught poses.\n"
      "images: {}\n"
      "board: {{type: checkerboard, inner_corners: [{}, {}], square_size: {:.17g}}}  # [m]\n"
      "lasers: [{}]\n",
      head.poses_file, head.board.columns, head.board.rows, head.board.square_size,
      fmt::join(head.lasers, ", "));
}

}  // namespace scan_calibration
