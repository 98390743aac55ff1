// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "part/moulding.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/scene.h"
#include "test_worlds.h"

namespace scan_cell_sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kMicrometre = 1e-6;

TEST(Deformation, MovesMaterialByTheFormulasItIsDocumentedWith) {
  Deformation deformation;
  deformation.add(Bend{Vector3d::UnitX(), Vector3d::UnitZ(), 2});
  EXPECT_NEAR(deformation.apply({0.1, 0.5, 0}).z(), 2 * 0.1 * 0.1 / 2, 1e-15);
  deformation.add(Bulge{Vector3d(0, 0.3, 7), Vector3d::UnitZ(), 0.02, 0.004});
  EXPECT_NEAR(deformation.apply({0, 0.32, 0}).z(), 0.004 * std::exp(-0.5), 1e-15);
  Deformation filed;
  filed.add(FiledEdge{Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), -Vector3d::UnitY(), 0.01, 0.002});
  EXPECT_NEAR(filed.apply({0.05, 0, 0}).y(), -0.002, 1e-15);
  EXPECT_NEAR(filed.apply({0.05, 0, 0.01}).y(), -0.002 * std::exp(-0.5), 1e-15);
  EXPECT_NEAR(filed.apply({0.12, 0, 0}).y(), -0.002 * std::exp(-2), 1e-15);
}

TEST(Deformation, JacobianIsTheDerivative) {
  const Part part = bent_frame();
  constexpr double kStep = 1e-6;
  for (const Vector3d& point : {Vector3d(0.05, 0.07, 0.02), Vector3d(-0.03, -0.063, 0.018),
                                Vector3d(0.02, -0.066, 0.02), Vector3d(-0.09, 0.01, 0.004)}) {
    Matrix3d numeric;
    for (int i = 0; i < 3; ++i) {
      const Vector3d step = kStep * Vector3d::Unit(i);
      numeric.col(i) =
          (part.deformation.apply(point + step) - part.deformation.apply(point - step)) /
          (2 * kStep);
    }
    EXPECT_LT((numeric - part.deformation.jacobian(point)).norm(), 1e-7);
  }
}

TEST(Part, FindsBackThePointThatWentToAPlaceInTheWorld) {
  const Part part = bent_frame();
  for (const Vector3d& vertex : tessellate(part.shape, {}, 1e-4).vertices) {
    EXPECT_LT((part.to_part(part.to_world(vertex)) - vertex).norm(), 1e-10);
  }
}

TEST(Part, RefusesAPlaceThatNoPointWentTo) {
  Part part = bent_frame();
  part.deformation.add(Bend{Vector3d::UnitX(), Vector3d::UnitX(), 10});  // x + 5 x^2 >= -0.05
  EXPECT_THROW(part.to_part(part.pose * Vector3d(-0.2, 0, 0)), scan_cell_common::UnusableInput);
}

TEST(Part, RefusesADeformationThatFoldsIt) {
  Part part = bent_frame();
  part.deformation.add(FiledEdge{Vector3d(-0.05, -0.065, 0.02), Vector3d(0, -0.065, 0.02),
                                 -Vector3d::UnitZ(), 0.002, 0.02});
  EXPECT_THROW(part.mesh(1e-4), scan_cell_common::UnusableInput);
}

TEST(Mesh, FlatTrianglesStayWithinFiveMicrometresOfTheDeformedSurface) {
  const Part part = bent_frame();
  const Mesh undeformed = tessellate(part.shape, part.deformation, Scene::kTolerance / part.scale);
  const Mesh mesh = part.mesh(Scene::kTolerance);
  ASSERT_EQ(mesh.vertices.size(), undeformed.vertices.size());
  double worst = 0;
  const auto look = [&](const std::array<std::uint32_t, 3>& t, double a, double b, double c) {
    const auto mix = [&](const Mesh& m) -> Vector3d {
      return a * m.vertices[t[0]] + b * m.vertices[t[1]] + c * m.vertices[t[2]];
    };
    worst = std::max(worst, (part.to_world(mix(undeformed)) - mix(mesh)).norm());
  };
  for (const auto& triangle : mesh.triangles) {
    look(triangle, 1 / 3.0, 1 / 3.0, 1 / 3.0);
    look(triangle, 0.5, 0.5, 0);
    look(triangle, 0.5, 0, 0.5);
    look(triangle, 0, 0.5, 0.5);
  }
  EXPECT_LT(worst, 5 * kMicrometre);
}

TEST(Elbow, HasTheVolumeAndTheSurfaceOfAPipeAlongItsAxis) {
  const ElbowShape elbow{0.02, 0.06, 0.05};
  const Mesh mesh = tessellate(elbow, {}, Scene::kTolerance);
  double volume = 0;
  double surface = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vector3d& a = mesh.vertices[triangle[0]];
    const Vector3d& b = mesh.vertices[triangle[1]];
    const Vector3d& c = mesh.vertices[triangle[2]];
    volume += a.dot(b.cross(c)) / 6;  // divergence theorem: closed, and seen from outside
    surface += (b - a).cross(c - a).norm() / 2;
  }
  const double way =
      2 * 0.05 + 0.06 * M_PI / 2;  // Pappus and Guldin: the axis is the centroid's way
  const double section = M_PI * 0.02 * 0.02;
  EXPECT_NEAR(volume / (section * way), 1, 1e-3);
  EXPECT_NEAR(surface / (2 * M_PI * 0.02 * way + 2 * section), 1, 1e-3);
}

TEST(Elbow, LiesOnTheFloor) {
  double lowest = 1;
  for (const Vector3d& vertex : tessellate(ElbowShape(), {}, Scene::kTolerance).vertices)
    lowest = std::min(lowest, vertex.z());
  EXPECT_NEAR(lowest, 0, Scene::kTolerance);
}

TEST(Moulding, ChordsStayWithinTheToleranceOfTheRoundings) {
  const std::vector<Vector2d> coarse = Moulding().points(0.005, 2 * kMicrometre);
  const std::vector<Vector2d> fine = Moulding().points(0.00002, 0.01 * kMicrometre);
  for (const Vector2d& point : fine) {
    double nearest = 1;
    for (std::size_t i = 1; i < coarse.size(); ++i) {
      const Vector2d chord = coarse[i] - coarse[i - 1];
      if (!(chord.norm() > 0)) continue;
      const double along =
          std::clamp((point - coarse[i - 1]).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (coarse[i - 1] + along * chord - point).norm());
    }
    ASSERT_LT(nearest, 2.05 * kMicrometre) << point.transpose();
  }
}

TEST(Moulding, CrestIsItsHighestPointAndLevel) {
  const Moulding moulding;
  for (const Vector2d& point : moulding.points(0.0005, kMicrometre)) {
    EXPECT_LE(point.y(), moulding.crest().y() + 1e-15);
  }
  EXPECT_NEAR(moulding.height(), 0.020, 1e-12);
  EXPECT_NEAR(moulding.width(), 0.028, 1e-12);
}

TEST(Frame, HasNoHalfTurnSymmetry) {
  World world;
  world.parts.push_back({"frame", FrameShape{}, {}, 1, Isometry3d::Identity(), 0.7});
  const Scene scene(world);
  double furthest = 0;
  for (const Vector3d& vertex : scene.meshes()[0].vertices) {
    const Vector3d turned(-vertex.x(), -vertex.y(), vertex.z());
    furthest = std::max(furthest, scene.distance_to_surface(turned));
  }
  EXPECT_GT(furthest, 0.009);  // the hanger sticks out by 10 mm
}

TEST(TrueImage, OfAScaledAndTurnedPartIsTheSimilarity) {
  Part reference = bent_frame();
  reference.deformation = {};
  reference.scale = 1;
  reference.pose = pose(0.1, 0.2, 0.3, 0.5);
  Part object = reference;
  object.scale = 1.25;
  object.pose = pose(-0.1, 0.05, 0, -1.2);
  Isometry3d tool = pose(0.12, 0.25, 0.31, 0.3);
  tool.linear() = tool.linear() * Eigen::AngleAxisd(M_PI, Vector3d::UnitX());
  const Isometry3d image = true_image(reference, object, tool);
  const Isometry3d between = object.pose * reference.pose.inverse();
  EXPECT_TRUE(image.linear().isApprox(between.linear() * tool.linear(), 1e-12));
  EXPECT_TRUE(image.translation().isApprox(
      object.pose * (1.25 * (reference.pose.inverse() * tool.translation())), 1e-12));
}

TEST(TrueImage, StandsOnTheBentSurfaceAgainstItsNormal) {
  Part reference;
  reference.name = "frame";
  reference.shape = FrameShape{};
  const Part object = bent_frame();
  const Moulding moulding;
  const double y = 0.075 - moulding.crest().x();
  Isometry3d tool = pose(0.045, y, moulding.height());
  tool.linear() = Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();
  const Isometry3d image = true_image(reference, object, tool);

  // Two small steps on the level crest give the deformed surface's tangents.
  constexpr double kStep = 1e-6;
  const auto tangent = [&](const Vector3d& way) {
    return Vector3d(object.to_world(tool.translation() + kStep * way) -
                    object.to_world(tool.translation() - kStep * way))
        .normalized();
  };
  const Vector3d along = tangent(Vector3d::UnitX());
  const Vector3d normal = along.cross(tangent(Vector3d::UnitY())).normalized();
  EXPECT_LT((image.linear().col(2) + normal).norm(), 1e-6);
  EXPECT_LT((image.linear().col(0) - along).norm(), 1e-6);
  EXPECT_LT((image.translation() - object.to_world(tool.translation())).norm(), 1e-15);

  World world;
  world.parts.push_back(object);
  EXPECT_LT(Scene(world).distance_to_surface(image.translation()), 5 * kMicrometre);
}

TEST(TrueImage, RefusesPartsOfDifferentShapes) {
  const Part frame = bent_frame();
  const Part other = box("box", {0.1, 0.1, 0.1}, pose(0, 0, 0));
  EXPECT_THROW(true_image(frame, other, Isometry3d::Identity()), scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace scan_cell_sim
