// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "cloud_preprocess/edited_cloud.h"
#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {
namespace {

/// Points throughout a cube of 1 m about the origin, a few of them not finite.
Cloud scattered() {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(-0.5F, 0.5F);
  Cloud cloud;
  for (int i = 0; i < 3000; ++i)
    cloud.push_back({place(random), place(random), place(random)});
  for (const std::size_t i : {7u, 1500u})
    cloud[i].y = std::numeric_limits<float>::quiet_NaN();
  return cloud;
}

CloudEdit box_at(double x, double size, bool keep = false) {
  BoxShape box;
  box.pose.translation().x() = x;
  box.size.setConstant(size);
  return {keep, box};
}

/// One of each kind.
std::vector<CloudEdit> some_edits() {
  HalfSpace half;
  half.point = {0, 0, 0.3};
  PrismShape prism;
  prism.corners = {{-0.3, -0.3, 0}, {0.3, -0.3, 0}, {0, 0.4, 0}};
  prism.nearest = -0.05;
  prism.farthest = 0.05;
  BrushShape brush;
  brush.places = {{0.2, 0.2, 0.2}, {0.3, 0.2, 0.2}};
  brush.radius = 0.1;
  ClusterShape cluster;
  cluster.gap = 0.2;
  return {box_at(0.2, 0.3), {false, half}, {false, prism}, {false, brush}, {true, cluster}};
}

/// What CloudEdits leaves; other tests check that against closed forms.
Cloud left_by(const std::vector<CloudEdit>& edits) {
  StageReport report;
  return CloudEdits(edits).run(scattered(), report);
}

void expect_left(const EditedCloud& edited, const Cloud& expected) {
  const EditedCloud::Indices kept = edited.kept();
  ASSERT_EQ(kept.size(), expected.size());
  EXPECT_EQ(edited.count(), expected.size());
  for (std::size_t i = 0; i < kept.size(); ++i)
    EXPECT_EQ(edited.source()[kept[i]].getVector3fMap(), expected[i].getVector3fMap());
}

TEST(EditedCloud, IsAfterEachEditWhatTheListOfThemLeaves) {
  EditedCloud edited(scattered());
  expect_left(edited, left_by({}));
  std::vector<CloudEdit> edits;
  for (const CloudEdit& edit : some_edits()) {
    edits.push_back(edit);
    const std::size_t would_go = edited.would_take(edit).size();
    EXPECT_EQ(edited.add(edit), would_go);
    EXPECT_EQ(edited.taken_by(edits.size() - 1).size(), would_go);
    EXPECT_EQ(edited.counts().back(), would_go);
    expect_left(edited, left_by(edits));
  }
  EXPECT_EQ(to_yaml(edited.edits()), to_yaml(edits));
}

TEST(EditedCloud, GoesBackAndForthOverAllOfThem) {
  const std::vector<CloudEdit> edits = some_edits();
  EditedCloud edited(scattered());
  EXPECT_FALSE(edited.undo());
  for (const CloudEdit& edit : edits)
    edited.add(edit);
  for (int times = 0; times < 3; ++times) {
    for (std::size_t left = edits.size(); left > 0; --left) {
      ASSERT_TRUE(edited.undo());
      expect_left(edited, left_by({edits.begin(), edits.begin() + static_cast<long>(left) - 1}));
    }
    EXPECT_FALSE(edited.undo());
    for (std::size_t done = 1; done <= edits.size(); ++done) {
      ASSERT_TRUE(edited.redo());
      expect_left(edited, left_by({edits.begin(), edits.begin() + static_cast<long>(done)}));
    }
    EXPECT_FALSE(edited.redo());
  }
}

TEST(EditedCloud, ForgetsWhatWasUndoneWhenAnotherEditComes) {
  EditedCloud edited(scattered());
  edited.add(box_at(0.2, 0.3));
  edited.add(box_at(-0.2, 0.3));
  edited.undo();
  edited.add(box_at(0, 0.1));
  EXPECT_FALSE(edited.redo());
  expect_left(edited, left_by({box_at(0.2, 0.3), box_at(0, 0.1)}));
}

TEST(EditedCloud, RefusesAnEditThatLeavesNothingAndStaysAsItIs) {
  EditedCloud edited(scattered());
  edited.add(box_at(0.2, 0.3));
  edited.add(box_at(-0.2, 0.3));
  edited.undo();
  EXPECT_THROW(edited.add(box_at(0, 2)), scan_cell_common::UnusableInput);
  EXPECT_THROW(edited.add(box_at(9, 1, true)), scan_cell_common::UnusableInput);
  expect_left(edited, left_by({box_at(0.2, 0.3)}));
  EXPECT_TRUE(edited.redo()) << "what was undone is still there";
}

}  // namespace
}  // namespace cloud_preprocess
