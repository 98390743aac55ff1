// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "made_up_part.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tool_path_programs/accepted_report.h"
#include "tool_paths/tool_path_files.h"

namespace part_recipes {
namespace {

using nlohmann::json;

/// The made-up part, with its path adapted to where it was moved.
class EditPath : public testing::Test {
 protected:
  EditPath() {
    MadeUpPart::write_cloud(file("reference.ply"), Eigen::Isometry3d::Identity());
    MadeUpPart::write_cloud(file("moved.ply"), MadeUpPart::moved());
    MadeUpPart::write_path(file("path.csv"));
    EXPECT_EQ(run(std::string(STRETCH) +
                  " --reference reference.ply --object moved.ply --path path.csv --output "
                  "adapted.csv --report report.json"),
              0)
        << text("stderr");
    save("edits.yaml",
         "edits:\n  - delete: {waypoints: [0, 1]}\n  - add: {after: 4}\n"
         "  - move: {waypoints: 5, by: [0, 0, -0.001]}\n");
  }

  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string text(const std::string& name) const { return text_of(file(name)); }
  void save(const std::string& name, const std::string& bytes) const {
    scan_cell_common::save_text(file(name), bytes);
  }

  /// @return exit code
  int run(const std::string& command) const {
    const int status = std::system(
        ("cd '" + folder_.path().string() + "' && " + command + " > stdout 2> stderr").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  int edit(const std::string& path, const std::string& report, const std::string& name) const {
    return run(std::string(EDIT_PATH) + " --path " + path + " --edits edits.yaml --report " +
               report + " --output " + name + ".csv --output-report " + name + ".json");
  }

  TemporaryFolder folder_;
};

TEST_F(EditPath, ChangesWhatItIsToldAndNothingElse) {
  ASSERT_EQ(edit("adapted.csv", "report.json", "edited"), 0) << text("stderr");
  const auto before = tool_paths::load_tool_path(file("adapted.csv")).segments.at(0).waypoints;
  const auto after = tool_paths::load_tool_path(file("edited.csv")).segments.at(0).waypoints;
  ASSERT_EQ(after.size(), before.size() - 1);
  EXPECT_TRUE(after[0].pose.isApprox(before[2].pose, 1e-12));
  EXPECT_TRUE(after[6].pose.isApprox(before[7].pose, 1e-12));
  const Eigen::Vector3d middle = (before[6].pose.translation() + before[7].pose.translation()) / 2;
  const Eigen::Vector3d moved = after[5].pose.translation() - middle;
  EXPECT_NEAR(moved.norm(), 0.001, 1e-9);
  EXPECT_NEAR(moved.dot(after[5].pose.linear().col(2)), -0.001, 1e-9);
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_EQ(after[i].process_values, (std::vector<double>{i == 5 ? 1.0 : 0.0})) << i;
  EXPECT_NE(text("stdout").find("waypoints 0 to 1 deleted"), std::string::npos);
}

TEST_F(EditPath, ItsReportIsOfTheEditedPathAndTellsWhatWasDone) {
  ASSERT_EQ(edit("adapted.csv", "report.json", "edited"), 0) << text("stderr");
  const json before = json::parse(text("report.json"));
  const json after = json::parse(text("edited.json"));
  ASSERT_EQ(after.at("quality").size(), before.at("quality").size() - 1);
  EXPECT_EQ(after["quality"][0]["expected_error_normal"],
            before["quality"][2]["expected_error_normal"]);
  EXPECT_EQ(after["quality"][5]["expected_error_normal"].get<double>(),
            std::max(before["quality"][6]["expected_error_normal"].get<double>(),
                     before["quality"][7]["expected_error_normal"].get<double>()));
  EXPECT_EQ(after["quality"][5]["waypoint"], 5);
  EXPECT_EQ(after["quality"][5]["edited"], true);
  EXPECT_EQ(after["quality"][4]["edited"], false);
  EXPECT_EQ(after["path"]["waypoints"], after["quality"].size());
  EXPECT_EQ(after["measured_waypoints"], after["quality"].size());
  EXPECT_EQ(after["edits"]["done"].size(), 3U);
  // Programs take it with its own path, but with no other
  const auto accepted =
      tool_path_programs::accepted_report(file("edited.json"), file("edited.csv"));
  EXPECT_EQ(accepted.comments.at(4), "edited by hand: waypoints 0 to 1 deleted");
  EXPECT_THROW(tool_path_programs::accepted_report(file("edited.json"), file("adapted.csv")),
               scan_cell_common::Refused);
}

TEST_F(EditPath, AnEditedPathCanBeEditedAndTellsAllOfIt) {
  ASSERT_EQ(edit("adapted.csv", "report.json", "once"), 0) << text("stderr");
  save("edits.yaml", "edits:\n  - delete: {waypoints: 0}\n");
  ASSERT_EQ(edit("once.csv", "once.json", "twice"), 0) << text("stderr");
  const json twice = json::parse(text("twice.json"));
  EXPECT_EQ(twice["edits"]["done"].size(), 4U);
  EXPECT_NE(twice["edits"]["sha256"], json::parse(text("once.json"))["edits"]["sha256"]);
  EXPECT_EQ(twice["quality"][4]["edited"], true);
  EXPECT_EQ(tool_paths::load_tool_path(file("twice.csv")).segments[0].waypoints[4].process_values,
            (std::vector<double>{1}));
}

TEST_F(EditPath, WhatCannotBeDoneLeavesNoPath) {
  save("edited.csv", "of an earlier edit");
  save("edits.yaml", "edits:\n  - delete: {waypoints: 31}\n");
  EXPECT_EQ(edit("adapted.csv", "report.json", "edited"), 1);
  EXPECT_NE(text("stderr").find("edit 1: no waypoint 31"), std::string::npos) << text("stderr");
  EXPECT_FALSE(std::filesystem::exists(file("edited.csv")));
  save("edits.yaml", "edits:\n  - delete: {waypoints: 30}\n");
  EXPECT_EQ(edit("path.csv", "report.json", "edited"), 2) << "not the path of the report";
  EXPECT_EQ(run(std::string(EDIT_PATH) +
                " --path adapted.csv --edits edits.yaml --report report.json --output e.csv"),
            1);
  EXPECT_NE(text("stderr").find("--output-report"), std::string::npos) << text("stderr");
  for (const char* name : {"x", "qw", "segment", "rx"}) {
    save("edits.yaml",
         std::string("edits:\n  - set: {waypoints: [0, 30], values: {") + name + ": 1}}\n");
    EXPECT_EQ(edit("adapted.csv", "report.json", "edited"), 1) << name;
    EXPECT_FALSE(std::filesystem::exists(file("edited.csv"))) << name;
  }
  save("edits.yaml", "edits:\n  - delete: {waypoints: 30}\n");
  save("program.src", "DEF program()\nEND\n");
  EXPECT_EQ(run(std::string(EDIT_PATH) + " --path program.src --edits edits.yaml --output e.csv"),
            1);
  EXPECT_NE(text("stderr").find("robot's program"), std::string::npos) << text("stderr");
}

}  // namespace
}  // namespace part_recipes
