// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scan_cell/scan_request.h"
#include "scan_cell_common/errors/errors.h"

using scan_cell::PassKind;
using scan_cell::ScanPass;
using scan_cell::ScanRequest;

namespace {

Eigen::Isometry3d at(double x, double y) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, 0.6));
}

ScanPass line() {
  ScanPass pass;
  pass.poses = {at(0.6, 0), at(0.9, 0)};
  pass.speed = 0.1;
  pass.rate = 100;
  return pass;
}

/// What check() names as wrong after `change`.
template <class Change>
std::string refused(const Change& change) {
  ScanRequest request;
  request.passes = {line(), line()};
  change(request);
  try {
    check(request, {});
  } catch (const scan_cell_common::Refused& error) {
    return error.thing();
  }
  return "nothing";
}

}  // namespace

TEST(ScanRequest, IsAcceptedWithinTheLimits) {
  EXPECT_EQ(refused([](ScanRequest&) {}), "nothing");
}

TEST(ScanRequest, IsRefusedByThePassAndTheNameOfWhatIsOutsideTheLimits) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto in_second = [](const auto& change) {
    return refused([&](ScanRequest& request) { change(request.passes[1]); });
  };
  EXPECT_EQ(in_second([](ScanPass& p) { p.speed = 0; }), "pass 2: speed");
  EXPECT_EQ(in_second([](ScanPass& p) { p.speed = -0.1; }), "pass 2: speed");
  EXPECT_EQ(in_second([&](ScanPass& p) { p.speed = nan; }), "pass 2: speed");
  EXPECT_EQ(in_second([](ScanPass& p) { p.rate = 501; }), "pass 2: frame rate");
  EXPECT_EQ(in_second([](ScanPass& p) { p.rate = 1.9; }), "pass 2: frame rate");
  EXPECT_EQ(in_second([](ScanPass& p) { p.camera.exposure = 0.0099; }), "nothing");
  EXPECT_EQ(in_second([](ScanPass& p) { p.camera.exposure = 0.01; }), "pass 2: exposure");
  EXPECT_EQ(in_second([](ScanPass& p) { p.camera.exposure = 0; }), "pass 2: exposure");
  EXPECT_EQ(in_second([&](ScanPass& p) { p.camera.exposure = nan; }), "pass 2: exposure");
  EXPECT_EQ(in_second([](ScanPass& p) { p.poses[1] = p.poses[0]; }), "pass 2: pose 2");
  EXPECT_EQ(in_second([](ScanPass& p) { p.poses[1] = at(5, 0); }), "pass 2: length");
  EXPECT_EQ(in_second([&](ScanPass& p) { p.poses[0] = at(nan, 0); }), "pass 2: pose 1");
  EXPECT_EQ(in_second([](ScanPass& p) { p.poses.pop_back(); }), "pass 2: poses");
  EXPECT_EQ(in_second([](ScanPass& p) { p.poses.push_back(at(1, 0)); }), "pass 2: poses");
  EXPECT_EQ(in_second([](ScanPass& p) {
              p.name = "flank";
              p.speed = 0;
            }),
            "pass 2 (flank): speed");
}

TEST(ScanRequest, IsRefusedWithoutAPass) {
  EXPECT_EQ(refused([](ScanRequest& request) { request.passes.clear(); }), "passes");
}

TEST(ScanRequest, IsRefusedWhereTheThreePosesOfAnArcAreOnNoCircle) {
  const auto with_arc = [](const Eigen::Isometry3d& via, const Eigen::Isometry3d& end) {
    return refused([&](ScanRequest& request) {
      request.passes[0].kind = PassKind::kArc;
      request.passes[0].poses = {at(0.6, 0), via, end};
    });
  };
  EXPECT_EQ(with_arc(at(0.7, 0.1), at(0.8, 0)), "nothing");
  EXPECT_EQ(with_arc(at(0.7, 0), at(0.8, 0)), "pass 1: arc") << "on a line";
  EXPECT_EQ(with_arc(at(0.9, 0), at(0.8, 0)), "pass 1: arc") << "there and back";
  EXPECT_EQ(with_arc(at(0.6, 0), at(0.8, 0)), "pass 1: pose 2");
  EXPECT_EQ(with_arc(at(0.8, 0), at(0.6, 0)), "pass 1: arc") << "back where it began";
}

TEST(ScanRequest, KnowsHowLongAnArcIs) {
  ScanPass arc = line();
  arc.kind = PassKind::kArc;
  const auto on_circle = [](double angle) {
    return at(0.8 + 0.2 * std::cos(angle), 0.1 + 0.2 * std::sin(angle));
  };
  for (const double angle : {0.1, 1.0, M_PI, 4.0, 6.0}) {
    arc.poses = {on_circle(0.3), on_circle(0.3 + 0.3 * angle), on_circle(0.3 + angle)};
    EXPECT_NEAR(length(arc), 0.2 * angle, 1e-12);
  }
}

TEST(ScanRequest, AddsUpTheLinesOfAPolyline) {
  ScanPass way = line();
  way.kind = PassKind::kPolyline;
  way.poses = {at(0, 0), at(0.3, 0), at(0.3, 0.4), at(0, 0)};
  EXPECT_NEAR(length(way), 1.2, 1e-12);
}

TEST(ScanRequest, IsRefusedWhereTheFlangeWouldTurnBackOnALongArc) {
  const auto arc_over = [](double via, double end, double share_of_turn) {
    const auto on_circle = [&](double degrees) {
      const double angle = degrees * M_PI / 180;
      Eigen::Isometry3d pose = at(0.8 + 0.2 * std::cos(angle), 0.1 + 0.2 * std::sin(angle));
      pose.rotate(Eigen::AngleAxisd(share_of_turn * angle, Eigen::Vector3d::UnitZ()));
      return pose;
    };
    return refused([&](ScanRequest& request) {
      request.passes[1].kind = PassKind::kArc;
      request.passes[1].poses = {on_circle(0), on_circle(via), on_circle(end)};
    });
  };
  EXPECT_EQ(arc_over(135, 270, 1), "nothing");
  EXPECT_EQ(arc_over(170, 340, 1), "nothing");
  EXPECT_EQ(arc_over(60, 270, 1), "pass 2: arc from pose 2 to pose 3") << "150 degrees back";
  EXPECT_EQ(arc_over(210, 270, 1), "pass 2: arc from pose 1 to pose 2") << "150 degrees back";
  EXPECT_EQ(arc_over(-60, -270, 1), "pass 2: arc from pose 2 to pose 3") << "the other way round";
  EXPECT_EQ(arc_over(60, 270, 0), "nothing") << "it does not turn at all";
  EXPECT_EQ(arc_over(60, 270, 0.2), "nothing") << "it turns along, less than the arc";
  EXPECT_EQ(arc_over(60, 150, -1), "nothing") << "against the arc, but by less than half a turn";
}
