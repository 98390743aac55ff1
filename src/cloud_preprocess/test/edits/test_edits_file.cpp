// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clean_cloud_tool.h"
#include "cloud_preprocess/cloud_edits.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/yaml_file.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::UnusableInput;
using scan_cell_common::YamlEntry;

constexpr const char* kAll = R"(edits:
  - delete: {box: {center: [0.1, 0.2, 0.3], size: [0.01, 0.02, 0.03], rotation: [0, 0, 0.6, 0.8]}}
  - keep: {plane: {point: [0, 0, 0.001], normal: [0, 0, 2]}}
  - delete: {polygon: {corners: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], towards: [0, 0, 1], depth: [-0.1, 0.1]}}
  - delete: {brush: {places: [[0, 0, 0], [0.1, 0, 0]], radius: 0.004}}
  - keep: {cluster: {at: [0, 0, 0.05], gap: 0.003}}
)";

std::vector<CloudEdit> parsed(const std::string& text) {
  return read_edits(YamlEntry::parse(text, "edits.yaml")["edits"]);
}

TEST(EditsFile, HoldsEveryShapeAndComesBackAsItWasWritten) {
  const std::vector<CloudEdit> edits = parsed(kAll);
  ASSERT_EQ(edits.size(), 5u);
  EXPECT_FALSE(edits[0].keep);
  EXPECT_TRUE(edits[1].keep);
  EXPECT_EQ(std::get<HalfSpace>(edits[1].shape).normal, Eigen::Vector3d::UnitZ());
  const auto& box = std::get<BoxShape>(edits[0].shape);
  EXPECT_NEAR(box.pose.linear()(0, 0), 0.8 * 0.8 - 0.6 * 0.6, 1e-15);
  EXPECT_EQ(std::get<PrismShape>(edits[2].shape).corners.size(), 3u);
  EXPECT_EQ(std::get<BrushShape>(edits[3].shape).radius, 0.004);
  EXPECT_EQ(std::get<ClusterShape>(edits[4].shape).gap, 0.003);
  const std::string written = to_yaml(edits);
  EXPECT_EQ(to_yaml(parsed(written)), written);
}

TEST(EditsFile, ThatMakesNoSenseIsRefusedByLineAndEntry) {
  const std::pair<const char*, const char*> bad[] = {
      {"edits: 3", "edits"},
      {"edits: [{delete: {box: {center: [0, 0, 0], size: [1, 1, 0]}}}]", "size"},
      {"edits: [{delete: {box: {center: [0, 0], size: [1, 1, 1]}}}]", "center"},
      {"edits: [{delete: {box: {center: [0, 0, 0], size: [1, 1, 1], rotation: [0, 0, 0, 2]}}}]",
       "rotation"},
      {"edits: [{delete: {plane: {point: [0, 0, 0], normal: [0, 0, 0]}}}]", "normal"},
      {"edits: [{delete: {plane: {point: [0, 0, .nan], normal: [0, 0, 1]}}}]", "point"},
      {"edits: [{keep: {polygon: {corners: [[0, 0, 0], [1, 0, 0]], towards: [0, 0, 1], depth: [0, "
       "1]}}}]",
       "corners"},
      {"edits: [{keep: {polygon: {corners: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], towards: [0, 0, 1], "
       "depth: [1, 0]}}}]",
       "depth"},
      {"edits: [{delete: {brush: {places: [], radius: 0.1}}}]", "places"},
      {"edits: [{delete: {brush: {places: [[0, 0, 0]], radius: -0.1}}}]", "radius"},
      {"edits: [{delete: {cluster: {at: [0, 0, 0]}}}]", "gap"},
      {"edits: [{delete: {ball: {}}}]", "ball"},
      {"edits: [{delete: {}}]", "0 shapes"},
      {"edits: [{keep: {cluster: {at: [0, 0, 0], gap: 1}}, delete: {}}]", "neither or both"},
      {"edits: [{}]", "neither or both"}};
  for (const auto& [text, word] : bad) {
    try {
      parsed(text);
      ADD_FAILURE() << text;
    } catch (const UnusableInput& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

class EditsOfTheTool : public CleanCloudTool {
 protected:
  void write(const std::string& name, const std::string& text) const {
    scan_cell_common::save_text(path(name), text);
  }
  std::string bytes(const std::string& name) const {
    return scan_cell_common::read_file(path(name));
  }
  int clean(const std::string& options, const std::string& output = "clean.ply") const {
    return run("--input " + path("scan.ply") + " --units m --output " + path(output) + " " +
               options);
  }
};

/// The box beside the part, which nobody wants.
constexpr const char* kBoxAway = R"(edits:
  - delete: {box: {center: [0.08, 0, 0.02], size: [0.07, 0.09, 0.1]}}
)";

TEST_F(EditsOfTheTool, TakeAwayWhatAPersonMarkedWithTheSameBytesEachTime) {
  write("edits.yaml", kBoxAway);
  ASSERT_EQ(clean("--edits " + path("edits.yaml")), 0) << printed();
  EXPECT_NE(printed().find("delete box"), std::string::npos) << printed();
  const Scene scene = raw_scan();
  const Cloud part = scan_cell_common::load_cloud(path("clean.ply"));
  for (const auto& point : part)
    EXPECT_FALSE(point.x > 0.045F && point.x < 0.115F && std::abs(point.y) < 0.045F &&
                 point.z < 0.07F)
        << point;
  ASSERT_EQ(clean("--edits " + path("edits.yaml"), "again.ply"), 0);
  EXPECT_EQ(bytes("again.ply"), bytes("clean.ply"));
}

TEST_F(EditsOfTheTool, CanStandInTheSettingsOfARecipe) {
  write("edits.yaml", kBoxAway);
  write("settings.yaml", std::string("grid: false\n") + kBoxAway);
  ASSERT_EQ(clean("--grid off --edits " + path("edits.yaml")), 0) << printed();
  ASSERT_EQ(clean("--config " + path("settings.yaml"), "recipe.ply"), 0) << printed();
  EXPECT_EQ(bytes("recipe.ply"), bytes("clean.ply"));
}

TEST_F(EditsOfTheTool, ThatLeaveNothingAreRefusedAndNothingIsWritten) {
  write("edits.yaml", "edits: [{keep: {brush: {places: [[9, 9, 9]], radius: 0.001}}}]");
  EXPECT_NE(clean("--edits " + path("edits.yaml")), 0);
  EXPECT_NE(printed().find("edit 1 (keep brush)"), std::string::npos) << printed();
  EXPECT_FALSE(std::filesystem::exists(path("clean.ply")));
  EXPECT_NE(clean("--edits " + path("nothing.yaml")), 0);
  EXPECT_NE(printed().find("nothing.yaml"), std::string::npos) << printed();
}

}  // namespace
}  // namespace cloud_preprocess
