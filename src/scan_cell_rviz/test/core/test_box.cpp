// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "edit/box.h"

namespace scan_cell_rviz {
namespace {

using cloud_preprocess::BoxShape;
using Eigen::Vector3d;

BoxShape turned_box() {
  BoxShape box;
  box.pose.translation() = Vector3d(0.1, -0.2, 0.3);
  box.pose.linear() = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  box.size = Vector3d(0.4, 0.2, 0.1);
  return box;
}

TEST(Box, HasItsDraggedFaceWhereThePlaceIsAndTheOthersWhereTheyWere) {
  for (int face = 0; face < kFaces; ++face) {
    BoxShape box = turned_box();
    const Vector3d out = box.pose.linear() * outward(face);
    const Vector3d aside = box.pose.linear() * outward((face + 2) % kFaces);
    const Vector3d opposite = face_middle(box, face ^ 1);
    const Vector3d wanted = face_middle(box, face) + 0.03 * out;
    drag_face(box, face, wanted + 0.5 * aside);  // a hand also moves aside
    EXPECT_TRUE(face_middle(box, face).isApprox(wanted, 1e-12)) << face;
    EXPECT_TRUE(face_middle(box, face ^ 1).isApprox(opposite, 1e-12)) << face;
    EXPECT_NEAR(box.size[face / 2], turned_box().size[face / 2] + 0.03, 1e-12);
    EXPECT_EQ(box.size[(face / 2 + 1) % 3], turned_box().size[(face / 2 + 1) % 3]);
    EXPECT_EQ(box.pose.linear(), turned_box().pose.linear());
  }
}

TEST(Box, IsNeverTurnedInsideOut) {
  BoxShape box = turned_box();
  const Vector3d opposite = face_middle(box, 0);
  drag_face(box, 1, box.pose * Vector3d(-9, 0, 0));
  EXPECT_NEAR(box.size.x(), 1e-4, 1e-12);
  EXPECT_TRUE(face_middle(box, 0).isApprox(opposite, 1e-12));
}

TEST(Box, BeginsInTheMiddleOfWhatIsKept) {
  cloud_preprocess::Cloud cloud;
  cloud.push_back({0, 0, 0});
  cloud.push_back({1, 2, 3});
  cloud.push_back({99, 99, 99});
  const BoxShape box = box_within(cloud, {0, 1});
  EXPECT_TRUE(box.pose.translation().isApprox(Vector3d(0.5, 1, 1.5)));
  EXPECT_TRUE(box.size.isApprox(Vector3d(0.5, 1, 1.5)));
  EXPECT_TRUE((box_within(cloud, {}).size.array() > 0).all());
}

}  // namespace
}  // namespace scan_cell_rviz
