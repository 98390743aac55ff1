// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scan_cell_common/files/yaml_file.h"

namespace fs = std::filesystem;
using scan_cell_common::YamlEntry;

namespace {

/// The suite's error when `use` reads `text`.
template <class Use>
std::string complaint(const std::string& text, const Use& use) {
  try {
    use(YamlEntry(YAML::Load(text), "a.yaml"));
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST(YamlEntry, GivesAPoseToTheLastDigit) {
  const Eigen::Isometry3d pose = Eigen::Translation3d(0.1, -1.0 / 3, 1e-9) *
                                 Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized());
  YAML::Node node;
  node["tool"] = scan_cell_common::yaml_pose(pose);
  const YamlEntry read(YAML::Load(YAML::Dump(node)), "a.yaml");
  EXPECT_EQ(read["tool"].pose().translation(), pose.translation());
  EXPECT_TRUE(read["tool"].pose().isApprox(pose, 1e-15));
}

TEST(YamlEntry, IsRefusedByItsWholeNameAndLine) {
  const std::string pose = "a: {translation: [0, 0, 1], rotation: [0, 0, 0, 1]}";
  EXPECT_EQ(complaint(pose, [](const YamlEntry& e) { e["a"].pose(); }), "nothing");
  EXPECT_EQ(complaint("\na: {}", [](const YamlEntry& e) { e["a"]["b"]; }),
            "a.yaml: a.b: missing (line 2); add it");
  EXPECT_EQ(complaint("\na: {b: 1}", [](const YamlEntry& e) { e["a"].refuse_unknown({"c"}); }),
            "a.yaml: a.b: no such entry (line 2); check its spelling");
  EXPECT_EQ(complaint("\na: {[b]: 1}", [](const YamlEntry& e) { e["a"].refuse_unknown({"c"}); }),
            "a.yaml: a: a name that is a list or a map (line 2); give name: value");
  EXPECT_EQ(complaint("\na: [1, wide]", [](const YamlEntry& e) { e["a"].elements()[1].as<int>(); }),
            "a.yaml: a[1]: wrong type (line 2); correct it");
  EXPECT_EQ(complaint("\na: {b: 1}", [](const YamlEntry& e) { e["a"].elements(); }),
            "a.yaml: a: not a list (line 2); give a list");
  EXPECT_EQ(complaint("a: []", [](const YamlEntry& e) { e["a"].elements(); }), "nothing");
  EXPECT_EQ(complaint("\na: [1, .nan]", [](const YamlEntry& e) { e["a"].vector<2>(); }),
            "a.yaml: a: not finite (line 2); give numbers");
  EXPECT_EQ(
      complaint("a: {translation: [0, 0, 1], rotation: [0, 0, 1, 1]}",
                [](const YamlEntry& e) { e["a"].pose(); }),
      "a.yaml: a.rotation: a quaternion of length 1.41421; give a unit quaternion qx qy qz qw");
}

TEST(YamlEntry, IsRefusedByPathWhereTheFileIsMissingOrNoYaml) {
  EXPECT_THROW(YamlEntry::load("/no/such.yaml"), scan_cell_common::FileError);
  const std::string path =
      (fs::temp_directory_path() / ("yaml_" + std::to_string(getpid()))).string();
  scan_cell_common::save_text(path, "a: [1, 2");
  EXPECT_THROW(YamlEntry::load(path), scan_cell_common::FileError);
  fs::remove(path);
}

TEST(YamlEntry, ADirectionHasLength1AndComesBackToTheLastDigit) {
  const auto read = [](const Eigen::Vector3d& numbers) {
    YAML::Node root;
    root["way"] = scan_cell_common::yaml_list(numbers);
    return YamlEntry(root, "f.yaml")["way"].direction();
  };
  EXPECT_TRUE(read({0, 3, -4}).isApprox(Eigen::Vector3d(0, 0.6, -0.8)));
  for (int i = 1; i < 100; ++i) {
    const Eigen::Vector3d way = Eigen::Vector3d(i, 100 - i, 0.3 * i).normalized();
    EXPECT_EQ(read(way), way);
  }
  EXPECT_THROW(read({0, 0, 1e-7}), scan_cell_common::UnusableInput);
}

TEST(SaveText, IsRefusedByPathAndLeavesNothingBehind) {
  const fs::path folder = fs::temp_directory_path() / ("save_text_" + std::to_string(getpid()));
  const std::string target = (folder / "a").string();
  fs::create_directories(target);  // a folder in the place of the file
  for (const std::string& path : {target, (folder / "no/such/folder/a").string()}) {
    try {
      scan_cell_common::save_text(path, "text");
      ADD_FAILURE() << path;
    } catch (const scan_cell_common::FileError& error) {
      EXPECT_EQ(error.thing(), path);
    }
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  fs::remove_all(folder);
}
