// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "path_design/path_checks.h"
#include "path_design/path_parameters.h"
#include "path_design/shapes.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/testing/parameter_test.h"
#include "tool_path_stretcher/surface.h"
#include "tool_paths/tool_path_files.h"

namespace fs = std::filesystem;
using namespace part_recipes;

namespace {

class PathTool : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    shapes::save_stl(file("plate.stl"), shapes::plate(0.2, 0.12, 0.015));
    shapes::Soup inches = shapes::plate(0.2 / 0.0254, 0.12 / 0.0254);
    shapes::save_stl(file("inches.stl"), inches);
    scan_cell_common::save_cloud(
        file("cloud.ply"), tool_path_stretcher::to_cloud(
                               shapes::cloud_of(shapes::plate(0.1, 0.06, 0.01), 0.0005, 0.00002)));
    scan_cell_common::save_text(file("picks.csv"), "x,y,z\n-80,0,0.1\n-50,20,0\n-30,-30,-0.1\n");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// @return exit code
  int run(const std::string& words) const {
    const std::string command =
        "cd '" + folder_.string() + "' && " + PATH_TOOL + " " + words + " > stdout 2> stderr";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string text(const std::string& name) const {
    return scan_cell_common::read_file(file(name));
  }

  const fs::path folder_ = fs::temp_directory_path() / ("path_tool_" + std::to_string(getpid()));
};

const std::string kSlices = "from-slices --reference plate.stl --direction 1 0 0 ";

}  // namespace

TEST_F(PathTool, WritesPathsThatAreReadBackAlike) {
  const std::string options = kSlices + "--spacing 0.01 --margin 0.003 --speed 0.05 ";
  ASSERT_EQ(run(options + "--output path.csv"), 0) << text("stderr");
  ASSERT_EQ(run(options + "--output path.yaml"), 0) << text("stderr");
  const auto csv = tool_paths::load_tool_path(file("path.csv"));
  const auto yaml = tool_paths::load_tool_path(file("path.yaml"));
  EXPECT_TRUE(csv.has_orientation);
  EXPECT_EQ(csv.process_names, std::vector<std::string>{"speed"});
  ASSERT_EQ(csv.segments.size(), yaml.segments.size());
  EXPECT_GT(csv.segments.size(), 1U);
  const auto one = path_checks::all(csv), other = path_checks::all(yaml);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_TRUE(one[i].pose.isApprox(other[i].pose, 1e-12));
}

TEST_F(PathTool, WritesTheSameBytesTwice) {
  const std::vector<std::string> commands = {
      "from-slices --reference cloud.ply --margin 0.002 --border-passes 1 --output ",
      "from-edge --reference cloud.ply --offset 0.003 --output ",
      "from-picks --reference plate.stl --picks metres.csv --output "};
  scan_cell_common::save_text(file("metres.csv"), "-0.08 0 0\n-0.05 0.02 0\n-0.03 -0.03 0\n");
  for (const std::string& command : commands) {
    ASSERT_EQ(run(command + "one.csv"), 0) << text("stderr");
    ASSERT_EQ(run(command + "two.csv"), 0) << text("stderr");
    EXPECT_EQ(text("one.csv"), text("two.csv"));
  }
}

TEST_F(PathTool, TakesReferenceAndPicksInTheirUnit) {
  ASSERT_EQ(run("from-edge --reference inches.stl --reference-units inch --output path.csv"), 0)
      << text("stderr");
  for (const auto& at : path_checks::positions(tool_paths::load_tool_path(file("path.csv"))))
    EXPECT_NEAR(std::min(0.1 - std::abs(at.x()), 0.06 - std::abs(at.y())), 0, 1e-7);
  shapes::save_stl(file("mm.stl"), shapes::plate(200, 120));
  ASSERT_EQ(run("from-picks --reference mm.stl --reference-units mm --picks picks.csv "
                "--output path.csv"),
            0)
      << text("stderr");
  const auto path = tool_paths::load_tool_path(file("path.csv"));
  EXPECT_NEAR(path_checks::all(path).front().pose.translation().x(), -0.08, 1e-7);
}

TEST_F(PathTool, TellsWhatIsWrongAndLeavesNoOldPath) {
  scan_cell_common::save_text(file("empty.ply"),
                              "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
                              "property float y\nproperty float z\nend_header\n");
  scan_cell_common::save_text(file("nan.xyz"), "0 0 0\n1 0 0\n0 nan 0\n1 1 0\n");
  scan_cell_common::save_text(file("off.csv"), "-0.08 0 0\n-0.05 0.02 0.1\n");
  const auto told = [this](const std::string& words, int code, const std::string& message) {
    scan_cell_common::save_text(file("path.csv"), "old");
    EXPECT_EQ(run(words + " --output path.csv"), code) << words;
    EXPECT_NE(text("stderr").find(message), std::string::npos) << text("stderr");
    EXPECT_FALSE(fs::exists(file("path.csv"))) << words;
  };
  told(kSlices + "--spacing 0", 1, "--spacing");
  told(kSlices + "--spacing -0.005", 1, "--spacing");
  told(kSlices + "--spacing 5", 1, "spacing: 5 m; the part is 0.12 m wide");
  told(kSlices + "--spacing nan", 1, "--spacing");
  told(kSlices + "--from 0 0 0", 1, "--from");
  told("from-slices --reference plate.stl --direction 0 0 0", 1, "--direction");
  told(kSlices + "--reference-units ft", 1, "'ft'");
  told(kSlices + "--order spiral", 1, "--order");
  told("from-edge --reference empty.ply", 1, "empty.ply");
  told("from-edge --reference nan.xyz", 1, "nan.xyz");
  told("from-edge --reference missing.stl", 1, "missing.stl");
  told("from-edge --reference plate.stl --offset 0.2", 2, "offset");
  told("from-picks --reference plate.stl --picks off.csv", 2, "pick 2: 100 mm from the surface");
}

TEST(PathParameters, AreAllInTheDocument) {
  const std::string how = "the document's own list";
  scan_cell_common::expect_documented<EdgeParameters>(DOCUMENT, how);
  scan_cell_common::expect_documented<SliceParameters>(DOCUMENT, how);
  scan_cell_common::expect_documented<PickParameters>(DOCUMENT, how);
}
