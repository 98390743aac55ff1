// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <tuple>

#include "part/moulding.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/ground_truth.h"
#include "scan_cell_sim/tool_paths.h"
#include "test_worlds.h"

namespace scan_cell_sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_cell_common::UnusableInput;

World flat_world() {
  World world;
  world.floor = Floor{};
  return world;
}

TEST(CloudError, IsTheDistanceToTheTrueSurface) {
  const CloudError error =
      compare(Scene(flat_world()), {{0, 0, 0.003}, {0.1, 0, -0.004}, {0.2, 0.1, 0}});
  EXPECT_EQ(error.points, 3U);
  EXPECT_NEAR(error.max, 0.004, 1e-9);
  EXPECT_NEAR(error.mean, 0.007 / 3, 1e-9);
  EXPECT_NEAR(error.rms, 0.005 / std::sqrt(3), 1e-9);
}

TEST(CloudError, RefusesCloudsThatCannotBeCompared) {
  EXPECT_THROW(compare(Scene(flat_world()), {}), UnusableInput);
  EXPECT_THROW(compare(Scene(flat_world()), {{0, NAN, 0}}), UnusableInput);
  EXPECT_THROW(compare(Scene(World{}), {{0, 0, 0}}), UnusableInput);
}

TEST(Sample, LiesOnWhatIsSeenFromAbove) {
  World world = flat_world();
  world.parts.push_back(box("box", {0.4, 0.8, 0.1}, pose(0, 0, 0)));
  const Scene scene(world);
  std::size_t on_top = 0;
  for (const Vector3d& point : sample(scene, 20000, 3, 0)) {
    const bool over_box = std::abs(point.x()) < 0.2 && std::abs(point.y()) < 0.4;
    EXPECT_NEAR(point.z(), over_box ? 0.1 : 0, 1e-9);
    on_top += over_box;
  }
  // 0.32 of 2.56 square metres; three standard deviations
  EXPECT_NEAR(static_cast<double>(on_top) / 20000, 0.125, 0.0071);
}

TEST(Sample, HasTheNoiseAskedForAndIsTheSameForTheSameSeed) {
  const Scene scene(flat_world());
  const std::vector<Vector3d> points = sample(scene, 20000, 5, 0.002);
  EXPECT_NEAR(compare(scene, points).rms, 0.002, 0.00004);
  EXPECT_EQ(points, sample(scene, 20000, 5, 0.002));
  EXPECT_NE(points, sample(scene, 20000, 6, 0.002));
}

TEST(CrestPath, RunsAroundTheReferenceFramesCrest) {
  const World world = load_world(std::string(CONFIG_FOLDER) + "/reference_frame.yaml");
  const ToolPath path = crest_path(world.part("frame"), 0.002);
  EXPECT_GE(path.size(), 200U);
  EXPECT_LE(path.size(), 400U);
  EXPECT_TRUE(path.front().isApprox(path.back()));
  const double x = 0.1 - Moulding().crest().x();
  const double y = 0.075 - Moulding().crest().x();
  double length = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vector3d p = path[i].translation();
    EXPECT_NEAR(p.z(), 0.020, 1e-12);
    EXPECT_NEAR(std::max(std::abs(p.x()) / x, std::abs(p.y()) / y), 1, 1e-12);
    EXPECT_TRUE(path[i].linear().col(2).isApprox(-Vector3d::UnitZ()));
    EXPECT_NEAR(path[i].linear().determinant(), 1, 1e-12);
    if (i == 0) continue;
    const Vector3d step = p - path[i - 1].translation();
    EXPECT_LE(step.norm(), 0.002 + 1e-12);
    EXPECT_TRUE(path[i - 1].linear().col(0).isApprox(step.normalized(), 1e-9));
    length += step.norm();
  }
  EXPECT_NEAR(length, 4 * (x + y), 1e-9);
}

TEST(TaughtPath, LiesOnTheSurfaceOfEachKindOfPart) {
  const std::string config = CONFIG_FOLDER;
  for (const auto& [file, part, length] :
       {std::tuple("/frame_with_sheet.yaml", "frame", 5 * 0.124 + 0.074),
        std::tuple("/boxes_moved.yaml", "large_box", 2 * (0.08 + 0.05)),
        std::tuple("/pipe_elbow.yaml", "elbow", 2 * 0.07 + 0.1 * M_PI / 2)}) {
    World world = load_world(config + file);
    world.floor.reset();
    const Scene scene(world);
    const ToolPath path = taught_path(world.part(part), 0.002);
    double way = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      EXPECT_NEAR(scene.distance_to_surface(path[i].translation()), 0, 5e-6) << file << ' ' << i;
      EXPECT_TRUE(path[i].linear().col(2).isApprox(-Vector3d::UnitZ(), 1e-9)) << file << ' ' << i;
      if (i > 0) way += (path[i].translation() - path[i - 1].translation()).norm();
    }
    EXPECT_NEAR(way, length, 1e-4) << file;
  }
}

TEST(TaughtPath, IsNotOnASheetThatBulgesOfItself) {
  const World world = load_world(std::string(CONFIG_FOLDER) + "/frame_and_box.yaml");
  EXPECT_THROW(taught_path(world.part("frame"), 0.002), UnusableInput);
}

TEST(CrestPath, OfABentFrameIsTheImageOfTheReferences) {
  const std::string config = CONFIG_FOLDER;
  const World reference = load_world(config + "/reference_frame.yaml");
  const World object = load_world(config + "/object_frame.yaml");
  const ToolPath taught = crest_path(reference.part("frame"), 0.01);
  const ToolPath image = true_image(reference.part("frame"), object.part("frame"), taught);
  const ToolPath direct = crest_path(object.part("frame"), 0.01);
  const Scene scene(object);
  ASSERT_EQ(image.size(), direct.size());
  for (std::size_t i = 0; i < image.size(); ++i) {
    EXPECT_TRUE(image[i].isApprox(direct[i], 1e-9));
    EXPECT_LT(scene.distance_to_surface(image[i].translation()), 5e-6);
    // The tool points at the surface: the surface's normal there is against the tool's z.
    const Vector3d z = image[i].linear().col(2);
    const auto hit = scene.first_hit(image[i].translation() - 0.01 * z, z);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 0.01, 1e-5);
    EXPECT_LT((hit->normal + z).norm(), 0.03);  // of one flat triangle near the rounded crest
  }
}

TEST(CrestPath, RefusesWhatHasNoCrest) {
  EXPECT_THROW(crest_path(box("box", {0.1, 0.1, 0.1}, pose(0, 0, 0)), 0.002), UnusableInput);
  EXPECT_THROW(crest_path(bent_frame(), 0), scan_cell_common::InvalidParameter);
}

class ToolPathFile : public testing::Test {
 protected:
  ToolPathFile() {
    char name[] = "/tmp/pathXXXXXX";
    EXPECT_GE(mkstemp(name), 0);
    file_ = name;
  }
  ~ToolPathFile() override { std::filesystem::remove(file_); }
  void write(const std::string& text) const { std::ofstream(file_) << text; }

  std::string file_;
};

TEST_F(ToolPathFile, GivesBackWhatWasSaved) {
  const ToolPath path = crest_path(bent_frame(), 0.02);
  save_tool_path(file_, path);
  const ToolPath loaded = load_tool_path(file_);
  ASSERT_EQ(loaded.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    EXPECT_TRUE(loaded[i].isApprox(path[i], 1e-12));
}

TEST_F(ToolPathFile, RefusesLinesThatMakeNoSense) {
  const std::string header = "x,y,z,qx,qy,qz,qw\n";
  for (const char* line : {"1,2,3", "1,2,3,0,0,0,2", "1,2,x,0,0,0,1", "1,2,3,0,0,0,1,9",
                           "1,nan,3,0,0,0,1", "1;2;3;0;0;0;1"}) {
    write(header + line + "\n");
    EXPECT_THROW(load_tool_path(file_), UnusableInput) << line;
  }
  write(header);
  EXPECT_THROW(load_tool_path(file_), UnusableInput);
  write("x,y,z\n1,2,3\n");
  EXPECT_THROW(load_tool_path(file_), UnusableInput);
  EXPECT_THROW(load_tool_path("/nowhere.csv"), scan_cell_common::FileError);
}

}  // namespace
}  // namespace scan_cell_sim
