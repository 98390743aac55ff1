// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "config_folder.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/scene.h"
#include "test_worlds.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector3d;

/// A world file with this text, gone at the end.
class WorldFile {
 public:
  explicit WorldFile(const std::string& text) {
    char name[] = "/tmp/worldXXXXXX";
    const int handle = mkstemp(name);
    EXPECT_GE(handle, 0);
    path_ = name;
    std::ofstream(path_) << text;
  }
  ~WorldFile() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string thing_refused(const std::string& text) {
  const WorldFile file(text);
  try {
    load_world(file.path());
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.thing().substr(error.thing().find(": ") + 2);
  }
  return "nothing";
}

TEST(WorldFile, EveryShippedWorldLoadsAndFitsOnePass) {
  for (const char* name :
       {"reference_frame", "scaled_frame", "object_frame", "two_boxes", "frame_and_box"}) {
    const World world = load_world(kConfig + "/" + name + ".yaml");
    ASSERT_FALSE(world.parts.empty()) << name;
    EXPECT_TRUE(world.floor) << name;
    for (const Part& part : world.parts) {
      for (const Vector3d& vertex : part.mesh(1e-4).vertices) {
        EXPECT_LT(std::max(std::abs(vertex.x()), std::abs(vertex.y())), 0.14) << name;
      }
    }
  }
}

TEST(WorldFile, ReadsEveryEntry) {
  const WorldFile file(R"(
floor: {height: 0.01, size: [1, 2], reflectance: 0.3}
board: {inner_corners: [9, 6], square_size: 0.03, margin: 0.01, white: 0.7, black: 0.1,
        pose: {translation: [1, 2, 3], rotation: [1, 0, 0, 0]}}
parts:
  - name: a
    shape: frame
    size: [0.3, 0.2]
    sheet: {height: 0.004, bulge: 0.01}
    scale: 1.1
    reflectance: 0.9
    pose: {translation: [1, 2, 3], rotation: [0, 0, 0, 1]}
    deformations:
      - {kind: bulge, centre: [0, 0, 0], radius: 0.05, height: 0.01}
      - {kind: bend, along: [2, 0, 0], towards: [0, 0, 1], curvature: 1}
      - {kind: filed_edge, from: [0, 1, 0], to: [1, 1, 0], towards: [0, -1, 0], radius: 0.01, depth: 0.002}
  - {name: b, shape: box, size: [0.1, 0.2, 0.3]}
  - {name: c, shape: elbow, size: [0.03, 0.09, 0.05]}
)");
  const World world = load_world(file.path());
  EXPECT_EQ(world.floor->height, 0.01);
  EXPECT_EQ(world.board->columns, 9);
  EXPECT_EQ(world.board->rows, 6);
  EXPECT_EQ(world.board->square_size, 0.03);
  EXPECT_EQ(world.board->margin, 0.01);
  EXPECT_EQ(world.board->white, 0.7);
  EXPECT_EQ(world.board->black, 0.1);
  EXPECT_EQ(world.board->pose.translation(), Vector3d(1, 2, 3));
  const Part& part = world.part("a");
  EXPECT_EQ(std::get<FrameShape>(part.shape).size, Eigen::Vector2d(0.3, 0.2));
  EXPECT_EQ(std::get<FrameShape>(part.shape).sheet->bulge, 0.01);
  EXPECT_EQ(part.scale, 1.1);
  EXPECT_EQ(part.reflectance, 0.9);
  EXPECT_EQ(part.pose.translation(), Vector3d(1, 2, 3));
  EXPECT_NEAR(part.deformation.apply(Vector3d::Zero()).z(), 0.01, 1e-15);
  EXPECT_NEAR(part.deformation.apply({0.5, 1, 0}).y(), 0.998, 1e-15);
  EXPECT_EQ(std::get<BoxShape>(world.part("b").shape).size, Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(std::get<ElbowShape>(world.part("c").shape).bend_radius, 0.09);
  EXPECT_THROW(world.part("d"), scan_cell_common::UnusableInput);
}

TEST(WorldFile, TheShippedBoardLiesFaceUpInTheMiddle) {
  const World world = load_world(kConfig + "/calibration_board.yaml");
  ASSERT_TRUE(world.board);
  const Checkerboard& board = *world.board;
  const Vector3d middle = board.pose * Vector3d((board.columns - 1) * board.square_size / 2,
                                                (board.rows - 1) * board.square_size / 2, 0);
  EXPECT_LT(middle.head<2>().norm(), 1e-9);
  EXPECT_NEAR(board.pose.linear().col(2).z(), -1, 1e-9);
}

TEST(WorldFile, RefusalsNameTheEntry) {
  EXPECT_EQ(thing_refused("parts: [{name: a, shape: ball}]"), "parts[0].shape");
  EXPECT_EQ(thing_refused("parts: [{name: a}]"), "parts[0].shape");
  EXPECT_EQ(thing_refused("parts: [{name: a, shape: elbow, size: [0.03, 0.03, 0.1]}]"),
            "parts[0].size");
  EXPECT_EQ(thing_refused("parts: [{name: a, shape: box, scale: 0}]"), "parts[0].scale");
  EXPECT_EQ(thing_refused("parts: [{name: a, shape: box, scle: 1}]"), "parts[0].scle");
  EXPECT_EQ(thing_refused("parts: [{name: a, shape: box, size: [1, 2]}]"), "parts[0].size");
  EXPECT_EQ(thing_refused("parts: [{name: a, shape: box}, {name: a, shape: box}]"),
            "parts[1].name");
  EXPECT_EQ(thing_refused("parts: [{name: a, shape: box, deformations: [{kind: twist}]}]"),
            "parts[0].deformations[0].kind");
  EXPECT_EQ(thing_refused("board: {square_size: 0.02}"), "board.inner_corners");
  EXPECT_EQ(thing_refused("board: {inner_corners: [9.5, 6], square_size: 0.02}"),
            "board.inner_corners");
  EXPECT_EQ(thing_refused("board: {inner_corners: [9, 6], square_size: 20}"), "board.square_size");
  EXPECT_EQ(thing_refused("flor: {}"), "flor");
  EXPECT_THROW(load_world("/nowhere.yaml"), scan_cell_common::FileError);
}

TEST(Scene, TellsTheFirstSurfaceAlongARay) {
  World world;
  world.floor = Floor{};
  world.parts.push_back(box("box", {0.1, 0.1, 0.04}, pose(0.2, 0, 0)));
  const Scene scene(world);
  const auto floor = scene.first_hit({0, 0, 1}, -Vector3d::UnitZ());
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->distance, 1, 1e-12);
  EXPECT_LT((floor->normal - Vector3d::UnitZ()).norm(), 1e-12);
  const auto top = scene.first_hit({0.2, 0, 1}, -Vector3d::UnitZ());
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->point.z(), 0.04, 1e-9);
  EXPECT_FALSE(scene.first_hit({0, 0, 1}, Vector3d::UnitZ()));
}

TEST(Scene, SeesUnlessSomethingStandsBetween) {
  World world;
  world.floor = Floor{};
  world.parts.push_back(box("box", {0.1, 0.1, 0.04}, pose(0.2, 0, 0.3)));
  const Scene scene(world);
  EXPECT_TRUE(scene.sees({0, 0, 0}, {0, 0, 1}));
  EXPECT_FALSE(scene.sees({0.2, 0, 0}, {0.2, 0, 1}));
  EXPECT_TRUE(scene.sees({0.2, 0, 0.34}, {0.2, 0, 1}));
}

TEST(Scene, MeasuresTheDistanceToTheNearestSurface) {
  World world;
  world.floor = Floor{};
  world.parts.push_back(box("box", {0.1, 0.1, 0.04}, pose(0.2, 0, 0)));
  EXPECT_NEAR(Scene(world).distance_to_surface({0, 0, 0.025}), 0.025, 1e-9);
  EXPECT_NEAR(Scene(world).distance_to_surface({0.2, 0, 0.05}), 0.01, 1e-9);
  EXPECT_NEAR(Scene(world, "box").distance_to_surface({0.12, 0, 0.02}), 0.03, 1e-9);
  EXPECT_NEAR(Scene(world, "box").distance_to_surface({0.12, 0, 0.08}), 0.05, 1e-9);  // 3-4-5
}

}  // namespace
}  // namespace scan_cell_sim
