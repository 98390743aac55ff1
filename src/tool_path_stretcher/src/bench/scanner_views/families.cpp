// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/families.h"

#include <array>
#include <cmath>

#include "parts/scan.h"

namespace scanner_views {
namespace {

using Eigen::Vector3d;

/// The deformation about the middle of the part's box.
cases::Deformation about_middle(const cases::Deformation& deformation, const Mesh& part) {
  const Eigen::AlignedBox3d box = box_of(part);
  const Vector3d middle(box.center().x(), box.center().y(), 0);
  return [=](const Vector3d& at) -> Vector3d { return deformation(at - middle) + middle; };
}

double either_way(Draws& draws) {
  return draws.one_of(2) == 0 ? 1 : -1;
}

/// A pose elsewhere on the table, rotated.
Similarity lying(double scale, Draws& draws) {
  Similarity similarity;
  similarity.scale = scale;
  similarity.rotation =
      Eigen::AngleAxisd(draws.between(-M_PI, M_PI), Vector3d::UnitZ()).toRotationMatrix();
  similarity.translation = {draws.between(-0.3, 0.3), draws.between(-0.3, 0.3), 0};
  return similarity;
}

/// Puts the cloud in the scanner's own frame or the table's.
Eigen::Isometry3d any_frame(Draws& draws) {
  if (draws.one_of(2) == 0) return Eigen::Isometry3d::Identity();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = cases::random_rotation(static_cast<unsigned>(draws.one_of(1000)));
  const double x = draws.between(-0.5, 0.5), y = draws.between(-0.5, 0.5);
  frame.translation() = Vector3d(x, y, draws.between(0, 1));
  return frame;
}

Viewing any_viewing(Draws& draws) {
  constexpr std::array kAll = {Viewing::kAboveOneLaser, Viewing::kAboveBothLasers,
                               Viewing::kLeaningOneLaser, Viewing::kTwoSides};
  return kAll[draws.one_of(kAll.size())];
}

/// The mirror image of a mesh.
Mesh mirrored(Mesh mesh) {
  for (Vector3d& vertex : mesh.vertices)
    vertex.y() = -vertex.y();
  for (auto& triangle : mesh.triangles)
    std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// What all families share.
ViewCase drawn(const std::string& family, const ViewPart& part, std::uint64_t seed, Draws& draws) {
  constexpr std::array kPaths = {PathKind::kRaster, PathKind::kRim, PathKind::kWave};
  ViewCase each;
  each.family = each.what = family;
  each.reference = each.object = part;
  each.similarity = lying(1, draws);
  each.viewing = any_viewing(draws);
  each.frame = any_frame(draws);
  each.path = kPaths[draws.one_of(kPaths.size())];
  each.seed = seed;
  return each;
}

}  // namespace

ViewCase moved_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn("moved", part, seed, draws);
  return each;
}

ViewCase bent_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn("bent", part, seed, draws);
  const double width = box_of(part.mesh).sizes().x();
  const double rise = either_way(draws) * draws.between(0.004, 0.02) * width;  // 1 to 6 mm of 0.3 m
  each.deformation = about_middle(cases::bend(rise, width), part.mesh);
  return each;
}

ViewCase scaled_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn("scaled, scan as reference", part, seed, draws);
  each.similarity.scale = draws.between(0.75, 1.3);
  each.reference_scanned = true;
  return each;
}

ViewCase warped_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn("warped, scan as reference", part, seed, draws);
  const double width = box_of(part.mesh).sizes().x();
  const double angle = either_way(draws) * draws.between(0.01, 0.05);  // [rad] 0.6 to 3 degrees
  const double most = draws.between(0.002, 0.006) * width;
  each.deformation = about_middle(
      cases::both(cases::twist(angle, width), cases::swelling(most, width)), part.mesh);
  each.reference_scanned = true;
  return each;
}

ViewCase dented_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn("dented", part, seed, draws);
  const Eigen::AlignedBox3d box = box_of(part.mesh);
  const Vector3d at(draws.between(0.25, 0.75), draws.between(0.25, 0.75), 0.9);
  const Vector3d way(draws.between(-0.3, 0.3), draws.between(-0.3, 0.3), -1);
  each.deformation =
      cases::bulge_at(box.min() + box.sizes().cwiseProduct(at),
                      draws.between(0.001, 0.0025) * way.normalized(), draws.between(0.012, 0.03));
  return each;
}

ViewCase scene_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn("in a scene, cleaned", part, seed, draws);
  each.surroundings = {true, true, draws.one_of(2) == 0};
  each.scattered = 0.002;
  each.cleaned = true;
  each.frame.setIdentity();  // cleaning takes z as up
  return each;
}

ViewCase own_path_case(const ViewPart& part, std::uint64_t seed) {
  ViewCase each = moved_case(part, seed);
  each.family = "own path";
  each.what = "moved, whole path";
  each.viewing = Viewing::kTwoSides;
  each.whole_path = true;
  return each;
}

ViewCase bent_own_path_case(const ViewPart& part, std::uint64_t seed) {
  ViewCase each = own_path_case(part, seed);
  each.what = "bent, whole path";
  const double width = box_of(part.mesh).sizes().x();
  each.deformation = about_middle(cases::bend(0.006 * width, width), part.mesh);
  return each;
}

ViewCase symmetric_case(const ViewPart& part, std::uint64_t seed) {
  ViewCase each = moved_case(part, seed);
  each.family = "to refuse";
  each.what = "symmetric";
  each.path = PathKind::kRaster;  // a rim and a whole wave are symmetric too
  each.expected = Reason::kAmbiguous;
  return each;
}

ViewCase upside_down_case(const ViewPart& part, std::uint64_t seed) {
  ViewCase each = moved_case(part, seed);
  each.family = "to refuse";
  each.what = "upside down";
  each.similarity.rotation *= Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();
  each.expected = Reason::kPathNotScanned;
  return each;
}

ViewCase mirrored_case(const ViewPart& part, std::uint64_t seed) {
  ViewCase each = moved_case(part, seed);
  each.family = "to refuse";
  each.what = "mirrored";
  each.object.mesh = mirrored(part.mesh);
  each.expected = Reason::kMirroredPart;
  return each;
}

ViewCase wrong_case(const ViewPart& reference, const ViewPart& object, std::uint64_t seed) {
  ViewCase each = moved_case(reference, seed);
  each.family = "to refuse";
  each.what = "for " + reference.name;
  each.path = PathKind::kRaster;  // passes by the difference
  each.object = object;
  each.expected = Reason::kWrongPart;
  return each;
}

}  // namespace scanner_views
