// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "path/complaints.h"
#include "tool_paths/path_edits.h"

using namespace tool_paths;

namespace {

const char* const kAll = R"(edits:
  - move: {waypoints: [1, 3], by: [0, 0, -0.002]}
  - move: {waypoints: 2, by: [0.1, 0, 0], frame: path}
  - turn: {waypoints: 4, about: [0, 0, 2], angle: 0.1}
  - delete: {waypoints: [7, 9]}
  - add: {after: 5, share: 0.25}
  - set: {waypoints: 3, values: {speed: 0.02, air: 1}}
)";

std::string complaint_of_edit(const std::string& edit) {
  return complaint_of([&] { parse_path_edits("edits:\n  - " + edit + "\n", "e.yaml"); });
}

std::vector<std::string> words_of(const std::vector<PathEdit>& edits) {
  std::vector<std::string> words;
  for (const PathEdit& edit : edits)
    words.push_back(to_string(edit));
  return words;
}

}  // namespace

TEST(PathEditsFile, IsReadAsItIsDocumented) {
  EXPECT_EQ(
      words_of(parse_path_edits(kAll, "e.yaml")),
      (std::vector<std::string>{
          "waypoints 1 to 3 moved by 0, 0, -2 mm (tool)", "waypoint 2 moved by 100, 0, 0 mm (path)",
          "waypoint 4 turned by 5.73 degrees about 0, 0, 1 (tool)", "waypoints 7 to 9 deleted",
          "a waypoint added after 5, at 0.25 of the way", "waypoint 3 given air 1 speed 0.02"}));
}

TEST(PathEditsFile, ComesBackToTheLastDigit) {
  const std::vector<PathEdit> edits = {MoveEdit{{0, 4}, {1.0 / 3, -2e-17, 0}, EditFrame::kPath},
                                       TurnEdit{{1, 1}, Eigen::Vector3d(1, 2, 3).normalized(), 0.1},
                                       AddEdit{3, 1.0 / 3}, SetEdit{{2, 3}, {{"a b", -1e-9}}},
                                       DeleteEdit{{9, 9}}};
  const std::vector<PathEdit> back = parse_path_edits(to_yaml(edits), "e.yaml");
  ASSERT_EQ(back.size(), edits.size());
  EXPECT_EQ(std::get<MoveEdit>(back[0]).by, std::get<MoveEdit>(edits[0]).by);
  EXPECT_EQ(std::get<MoveEdit>(back[0]).frame, EditFrame::kPath);
  EXPECT_TRUE(
      std::get<TurnEdit>(back[1]).about.isApprox(std::get<TurnEdit>(edits[1]).about, 1e-15));
  EXPECT_EQ(std::get<TurnEdit>(back[1]).angle, 0.1);
  EXPECT_EQ(std::get<AddEdit>(back[2]).share, 1.0 / 3);
  EXPECT_EQ(std::get<SetEdit>(back[3]).values, std::get<SetEdit>(edits[3]).values);
  EXPECT_EQ(std::get<DeleteEdit>(back[4]).waypoints.first, 9U);
}

TEST(PathEditsFile, IsTheSameBytesHoweverOftenItIsReadAndWritten) {
  std::vector<PathEdit> edits;
  for (int i = 1; i < 200; ++i)
    edits.emplace_back(TurnEdit{{0, 0}, Eigen::Vector3d(i, 200 - i, 0.3 * i).normalized(), 0.1});
  std::string text = to_yaml(edits);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(to_yaml(parse_path_edits(text, "e.yaml")), text);
    text = to_yaml(parse_path_edits(text, "e.yaml"));
  }
}

TEST(PathEditsFile, RefusesNamesThatWouldNotComeBack) {
  EXPECT_TRUE(names(complaint_of_edit("set: {waypoints: 1, values: {gr\xf6\xdf: 1}}"),
                    "e.yaml, line 2: not UTF-8; save it as UTF-8"));
  EXPECT_EQ(complaint_of_edit("set: {waypoints: 1, values: {gr\xc3\xb6\xc3\x9f: 1}}"), "");
}

TEST(PathEditsFile, WhatMakesNoSenseIsRefusedWithItsPlace) {
  EXPECT_TRUE(
      names(complaint_of_edit("shift: {waypoints: 1}"), "edits[0].shift: no such entry (line 2)"));
  EXPECT_TRUE(names(complaint_of_edit("move: {waypoints: 1}"), "by"));
  EXPECT_TRUE(names(complaint_of_edit("move: {waypoints: -1, by: [0, 0, 1]}"), "waypoints: -1"));
  EXPECT_TRUE(names(complaint_of_edit("move: {waypoints: 1, by: [0, 0, .nan]}"), "by"));
  EXPECT_TRUE(
      names(complaint_of_edit("move: {waypoints: 1, by: [0, 0, 1], frame: flange}"), "flange"));
  EXPECT_TRUE(names(complaint_of_edit("move: {waypoints: 1.5, by: [0, 0, 1]}"), "waypoints"));
  EXPECT_TRUE(names(complaint_of_edit("delete: {waypoints: [3, 2]}"), "lower one first"));
  EXPECT_TRUE(names(complaint_of_edit("delete: {waypoints: [1, 2, 3]}"), "3 numbers"));
  EXPECT_TRUE(
      names(complaint_of_edit("turn: {waypoints: 1, about: [0, 0, 0], angle: 1}"), "direction"));
  EXPECT_TRUE(
      names(complaint_of_edit("turn: {waypoints: 1, about: [0, 0, 1], angle: .inf}"), "angle"));
  EXPECT_TRUE(names(complaint_of_edit("add: {after: 1, share: 1.5}"), "share"));
  EXPECT_TRUE(names(complaint_of_edit("set: {waypoints: 1, values: {}}"), "values"));
  EXPECT_TRUE(
      names(complaint_of_edit("{move: {waypoints: 1, by: [0, 0, 1]}, delete: {waypoints: 1}}"),
            "2 edits in one"));
  EXPECT_TRUE(names(complaint_of([] { parse_path_edits("edits: []", "e.yaml"); }), "empty"));
  EXPECT_TRUE(names(complaint_of([] { parse_path_edits("edit: []", "e.yaml"); }), "edit"));
  EXPECT_THROW(parse_path_edits("edits: [", "e.yaml"), scan_cell_common::FileError);
  EXPECT_THROW(load_path_edits("/nowhere/e.yaml"), scan_cell_common::FileError);
}
