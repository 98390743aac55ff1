// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cases/draws.h"
#include "parts/shapes.h"

using namespace tool_path_stretcher;

// The first of the draws that bench_drawn_parts takes 200 of.

namespace {

void expect_right(cases::Draw what, cases::Shapes shapes, double noise, unsigned count) {
  constexpr double kFar = 0.001;  // [m]
  for (unsigned i = 0; i < count; ++i) {
    const cases::DrawnPart part = cases::draw(what, shapes, noise, i);
    SCOPED_TRACE(part.name + ", draw " + std::to_string(i));
    const StretchResult result = cases::run(part);
    EXPECT_EQ(to_string(result.verdict.reason), to_string(part.expected)) << result.verdict.message;
    if (!result.verdict.accepted()) continue;
    EXPECT_LT(cases::farthest_off(part, result.path), kFar);
  }
}

constexpr double kNoise = 1e-4;  // [m]

StretchResult stretched(const cases::Part& reference, const cases::Part& object, double noise) {
  cases::Scan scan;
  scan.noise = noise;
  const StretchParameters parameters;
  const Points first = cases::scan(reference, cases::none(), {}, scan);
  scan.seed = 2;
  const Similarity moved{0.9, cases::random_rotation(5), {0.2, -0.1, 0.3}};
  const Points second = cases::scan(object, cases::none(), moved, scan);
  return stretch(surface_from_cloud(first, parameters.leaf, "reference"),
                 surface_from_cloud(second, parameters.leaf, "object"), reference.path, parameters);
}

/// The mirror image of the part.
cases::Part other_hand(cases::Part part) {
  for (cases::Facet& facet : part.facets) {
    facet.at = [at = facet.at](double u, double v) {
      cases::SurfacePoint point = at(u, v);
      point.position.x() *= -1;
      point.normal.x() *= -1;
      return point;
    };
  }
  return part;
}

}  // namespace

TEST(DrawnParts, ThatAreTheirOwnImageAreAmbiguousWithoutAnyNoise) {
  expect_right(cases::Draw::kSymmetric, cases::Shapes::kKnown, 0, 10);
}

TEST(DrawnParts, WithAHoleThatTellsThePoseAreAccepted) {
  expect_right(cases::Draw::kDistinguishable, cases::Shapes::kKnown, 0, 7);
}

TEST(DrawnParts, OfTheOtherHandAreRefusedAsMirrored) {
  expect_right(cases::Draw::kMirrored, cases::Shapes::kKnown, 0, 2);
  expect_right(cases::Draw::kMirrored, cases::Shapes::kKnown, kNoise, 2);
}

TEST(DrawnParts, WithAMirrorPlaneAreNotTakenForMirrored) {
  expect_right(cases::Draw::kMirrorSymmetric, cases::Shapes::kKnown, 0, 2);
  expect_right(cases::Draw::kMirrorSymmetric, cases::Shapes::kKnown, kNoise, 2);
}

TEST(OtherHand, OfAPartThatNearlyFitsIsRefusedAsMirrored) {
  for (const double noise : {0.0, kNoise}) {
    for (const cases::Part& part : {cases::box(true), cases::ribbed_plate()}) {
      const StretchResult result = stretched(part, other_hand(part), noise);
      EXPECT_EQ(to_string(result.verdict.reason), "mirrored_part") << result.verdict.message;
      EXPECT_NE(result.verdict.message.find("mirror image"), std::string::npos);
    }
  }
}

TEST(OtherHand, OfAPartWithAMirrorPlaneIsThePartItself) {
  for (const cases::Part& part : {cases::bracket(), cases::shaft(true), cases::elbow()}) {
    const StretchResult result = stretched(part, other_hand(part), kNoise);
    EXPECT_TRUE(result.verdict.accepted()) << result.verdict.message;
  }
}
