// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/case_list.h"

#include <array>

#include "parts/scan.h"

namespace scanner_views {
namespace {

using Eigen::Vector3d;

/// Seeds of draws that have nothing to do with each other (Steele et al. 2014, SplitMix64).
std::uint64_t scrambled(std::uint64_t seed, std::uint64_t what) {
  std::uint64_t bits = seed * 0x9E3779B97F4A7C15ULL + what;
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBULL;
  return bits ^ (bits >> 31U);
}

/// About the middle of the part's box.
cases::Deformation about_middle(const cases::Deformation& deformation, const Mesh& part) {
  const Eigen::AlignedBox3d box = box_of(part);
  const Vector3d middle(box.center().x(), box.center().y(), 0);
  return [=](const Vector3d& at) -> Vector3d { return deformation(at - middle) + middle; };
}

double either_way(Draws& draws) {
  return draws.one_of(2) == 0 ? 1 : -1;
}

/// Lying on another side of the table, turned.
Similarity lying(double scale, Draws& draws) {
  Similarity similarity;
  similarity.scale = scale;
  similarity.rotation =
      Eigen::AngleAxisd(draws.between(-M_PI, M_PI), Vector3d::UnitZ()).toRotationMatrix();
  similarity.translation = {draws.between(-0.3, 0.3), draws.between(-0.3, 0.3), 0};
  return similarity;
}

/// The cloud in the scanner's own frame rather than in the table's, or in that of the table.
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

/// Its mirror image.
Mesh mirrored(Mesh mesh) {
  for (Vector3d& vertex : mesh.vertices)
    vertex.y() = -vertex.y();
  for (auto& triangle : mesh.triangles)
    std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// What all families have in common.
ViewCase drawn(const ViewPart& part, std::uint64_t seed, Draws& draws) {
  constexpr std::array kPaths = {PathKind::kRaster, PathKind::kRim, PathKind::kWave};
  ViewCase each;
  each.reference = each.object = part;
  each.similarity = lying(1, draws);
  each.viewing = any_viewing(draws);
  each.frame = any_frame(draws);
  each.path = kPaths[draws.one_of(kPaths.size())];
  each.seed = seed;
  return each;
}

// Each family: one thing that is done to a part.

ViewCase moved_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn(part, seed, draws);
  each.family = each.what = "moved";
  return each;
}

ViewCase bent_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn(part, seed, draws);
  each.family = each.what = "bent";
  const double width = box_of(part.mesh).sizes().x();
  const double rise = either_way(draws) * draws.between(0.004, 0.02) * width;  // 1 to 6 mm of 0.3 m
  each.deformation = about_middle(cases::bend(rise, width), part.mesh);
  return each;
}

ViewCase scaled_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn(part, seed, draws);
  each.family = each.what = "scaled, scan as reference";
  each.similarity.scale = draws.between(0.75, 1.3);
  each.reference_scanned = true;
  return each;
}

ViewCase warped_case(const ViewPart& part, std::uint64_t seed) {
  Draws draws(seed);
  ViewCase each = drawn(part, seed, draws);
  each.family = each.what = "warped, scan as reference";
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
  ViewCase each = drawn(part, seed, draws);
  each.family = each.what = "dented";
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
  ViewCase each = drawn(part, seed, draws);
  each.family = each.what = "in a scene, cleaned";
  each.surroundings = {true, true, draws.one_of(2) == 0};
  each.scattered = 0.002;
  each.cleaned = true;
  each.frame.setIdentity();  // cleaning takes z for up
  return each;
}

/// A path of its own, as it is: also where it leads through the air.
ViewCase real_path_case(const ViewPart& part, std::uint64_t seed) {
  ViewCase each = moved_case(part, seed);
  each.family = "real path";
  each.what = "moved, whole path";
  each.viewing = Viewing::kTwoSides;
  each.whole_path = true;
  return each;
}

ViewCase bent_real_path_case(const ViewPart& part, std::uint64_t seed) {
  ViewCase each = real_path_case(part, seed);
  each.what = "bent, whole path";
  const double width = box_of(part.mesh).sizes().x();
  each.deformation = about_middle(cases::bend(0.006 * width, width), part.mesh);
  return each;
}

ViewCase symmetric_case(const ViewPart& part, std::uint64_t seed) {
  ViewCase each = moved_case(part, seed);
  each.family = "to refuse";
  each.what = "symmetric";
  each.expected = Reason::kAmbiguous;
  return each;
}

/// The part lies on the side that is worked on.
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
  each.path = PathKind::kRaster;  // past what differs
  each.object = object;
  each.expected = Reason::kWrongPart;
  return each;
}

/// Numbers the cases of one list: each has draws of its own.
class List {
 public:
  explicit List(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t next_seed() { return scrambled(seed_, ++count_); }

  template <class Family>
  void add(Family family, const std::vector<ViewPart>& parts) {
    for (const ViewPart& part : parts)
      cases.push_back(family(part, next_seed()));
  }

  std::vector<ViewCase> cases;

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

/// What must not be accepted.
void add_refusals(const std::vector<ViewPart>& parts, std::uint64_t seed, List& list) {
  Draws draws(scrambled(seed, 0));
  const std::vector<ViewPart> variant = {bracket_variant(draws)};
  list.add(symmetric_case, symmetric_parts(draws));
  list.add(mirrored_case, {parts[0], parts[6], parts[7], parts[10]});
  list.add(upside_down_case, {parts[0], parts[2], parts[11]});
  list.cases.push_back(wrong_case(parts[0], variant.front(), list.next_seed()));
  for (const std::size_t other : {1, 4, 8, 13})
    list.cases.push_back(wrong_case(parts[other], parts[other + 1], list.next_seed()));
}

}  // namespace

std::vector<ViewCase> all_cases(std::uint64_t seed, const std::string& data) {
  Draws draws(scrambled(seed, 0));
  std::vector<ViewPart> parts = plate_parts(draws);
  for (const auto& more : {profile_parts(draws), curved_parts(draws)})
    parts.insert(parts.end(), more.begin(), more.end());
  List list(seed);
  for (const auto family :
       {moved_case, bent_case, scaled_case, warped_case, dented_case, scene_case})
    list.add(family, parts);
  add_refusals(parts, seed, list);
  for (const ViewPart& part : real_parts(data)) {
    const bool own_path = !part.path.segments.empty();
    for (const auto family : own_path ? std::array{real_path_case, bent_real_path_case, moved_case}
                                      : std::array{moved_case, bent_case, scene_case})
      list.add(family, {part});
  }
  return list.cases;
}

}  // namespace scanner_views
