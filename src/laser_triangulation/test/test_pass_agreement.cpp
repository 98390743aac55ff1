// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <random>

#include "pass_agreement.h"

using namespace laser_triangulation;  // NOLINT

namespace {

constexpr double kNoise = 20e-6;       // [m] of a point
constexpr double kDeviation = 0.2e-3;  // [m] of a scanned point, from the calibration

/// A table with a block of 60 x 40 x 20 mm with flanks inclined by 45 degrees, seen from above by
/// the passes.
class Table {
 public:
  static constexpr double kHeight = 0.02;
  static constexpr double kHalfLength = 0.03;
  static constexpr double kHalfWidth = 0.02;

  double block_at = 0;   // [m] along x
  double lifted_by = 0;  // [m] lift of the block

  double height(double x, double y) const {
    const double out = std::max(std::abs(x - block_at) - kHalfLength, std::abs(y) - kHalfWidth);
    return std::clamp(kHeight + lifted_by - out, 0., kHeight + lifted_by);
  }
};

class Passes {
 public:
  /// Adds profiles 0.6 mm apart, with a point every 0.3 mm.
  /// @param error error of the whole pass, in the frame of the cloud
  void scan(std::uint8_t pass, std::uint8_t laser, const std::function<double(double, double)>& z,
            const Eigen::Isometry3d& error = Eigen::Isometry3d::Identity(), double begin = -0.08,
            double end = 0.08) {
    std::mt19937 random(pass * 7U + laser + 1);
    std::normal_distribution<double> noise(0, kNoise);
    std::vector<ScanPoint> points;
    for (double x = begin + 1e-4 * pass; x < end; x += 0.6e-3) {
      for (double y = -0.06; y < 0.06; y += 0.3e-3) {
        const double height = z(x, y);
        if (std::isnan(height)) continue;
        const Eigen::Vector3f p =
            (error * Eigen::Vector3d(x, y, height + noise(random))).cast<float>();
        points.push_back({p.x(), p.y(), p.z(), 100, laser, pass, {0, 0}, 3, 0, 0, 0.5F});
      }
    }
    cloud.append(points);
  }
  void scan(std::uint8_t pass, const Table& table,
            const Eigen::Isometry3d& error = Eigen::Isometry3d::Identity()) {
    scan(
        pass, 0, [&table](double x, double y) { return table.height(x, y); }, error);
  }

  /// Adds a flank of an upright sheet, 160 x 30 mm, seen from its side.
  /// @param y [m] its position; the camera is on the side with this sign
  void scan_flank(std::uint8_t pass, double y) {
    std::mt19937 random(pass + 1U);
    std::normal_distribution<double> noise(0, kNoise);
    std::vector<ScanPoint> points;
    for (double x = -0.08 + 1e-4 * pass; x < 0.08; x += 0.6e-3) {
      for (double z = 0; z < 0.03; z += 0.3e-3) {
        const Eigen::Vector3f p = Eigen::Vector3d(x, y + noise(random), z).cast<float>();
        const float camera = y > 0 ? 0.3F : -0.3F;
        points.push_back({p.x(), p.y(), p.z(), 100, 0, pass, {0, 0}, 3, 0, camera, 0.4F});
      }
    }
    cloud.append(points);
  }

  PassAgreement mend() { return bring_together(cloud, {kDeviation, kDeviation}); }
  PassAgreement measure() { return bring_together(cloud, {}); }

  /// [m] RMS of the heights above the table and the block.
  double error(const Table& table) const {
    double sum = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double off = static_cast<double>(cloud[i].z) -
                         table.height(static_cast<double>(cloud[i].x), cloud[i].y);
      sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(cloud.size()));
  }

  ScanCloud cloud;
};

Eigen::Isometry3d small_motion(const Eigen::Vector3d& shift, const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  return Eigen::Translation3d(shift) *
         Eigen::AngleAxisd(angle, angle > 0 ? turn / angle : Eigen::Vector3d::UnitX().eval());
}

}  // namespace

TEST(PassAgreement, OfOneSweepIsNotAsked) {
  Passes passes;
  passes.scan(0, Table());
  const PassAgreement result = passes.mend();
  EXPECT_EQ(result.agreement, Agreement::kNotCompared);
  EXPECT_TRUE(result.message.empty());
}

TEST(PassAgreement, IsThereWhereTheScannerIsCalibratedAndMendingMakesItNoWorse) {
  Passes passes;
  for (const std::uint8_t pass : {0, 1, 2})
    passes.scan(pass, Table());
  const double before = passes.error(Table());
  EXPECT_EQ(passes.measure().agreement, Agreement::kAgree);
  const PassAgreement result = passes.mend();
  EXPECT_EQ(result.agreement, Agreement::kMended) << result.message;
  ASSERT_TRUE(result.correction);
  for (const SweepMotion& motion : result.correction->motions) {
    EXPECT_LE(motion.shift.norm(), 3e-6) << "a seventh of the noise of one point";
    EXPECT_LE(motion.turn.norm(), 5e-5);
  }
  EXPECT_LE(passes.error(Table()), 1.01 * before);
}

TEST(PassAgreement, ComesBackWhereThePassesAreTurnedWithinTheUncertainty) {
  Passes passes;
  passes.scan(0, Table(), small_motion({0, 0, 0.08e-3}, {0.6e-3, 0, 0}));
  passes.scan(1, Table(), small_motion({0.1e-3, 0, -0.08e-3}, {-0.6e-3, 0, 0}));
  const double before = passes.error(Table());
  const PassAgreement result = passes.mend();
  ASSERT_EQ(result.agreement, Agreement::kMended) << result.message;
  ASSERT_EQ(result.overlaps.size(), 1U);
  EXPECT_LE(result.overlaps[0].median, 1.2 * 0.674 * kNoise) << "what is left is the noise";
  EXPECT_LE(passes.error(Table()), 0.6 * before);
}

TEST(PassAgreement, IsMeasuredButNotMendedWithoutAnUncertainty) {
  Passes passes;
  passes.scan(0, Table());
  passes.scan(1, Table(), small_motion({0, 0, 0.3e-3}, {0, 0, 0}));
  const float first = passes.cloud[0].z;
  const PassAgreement result = passes.measure();
  EXPECT_EQ(result.agreement, Agreement::kAgree);
  ASSERT_EQ(result.overlaps.size(), 1U);
  EXPECT_NEAR(result.overlaps[0].median, 0.3e-3, 0.02e-3);
  EXPECT_FALSE(result.correction);
  EXPECT_EQ(passes.cloud[0].z, first);
}

TEST(PassAgreement, SaysOfWhichLaserNobodyKnowsHowWellItsPointsAreKnown) {
  const auto plane = [](double, double) { return 0.; };
  Passes passes;
  passes.scan(0, 0, plane);
  passes.scan(0, 1, plane);
  for (const std::vector<double>& deviations : {std::vector<double>{kDeviation, 0}, {kDeviation}}) {
    const PassAgreement result = bring_together(passes.cloud, deviations);
    EXPECT_EQ(result.agreement, Agreement::kAgree);
    EXPECT_NE(
        result.message.find("not corrected: the scanner model has no uncertainty for laser_1"),
        std::string::npos)
        << result.message;
  }
}

TEST(PassAgreement, EndsWhereMoreWouldHaveToMoveThanTheUncertaintyExplains) {
  Passes passes;
  passes.scan(0, Table());
  passes.scan(1, Table(), small_motion({0, 0, 0.9e-3}, {0, 0, 0}));
  const float last = passes.cloud[passes.cloud.size() - 1].z;
  const PassAgreement result = passes.mend();
  EXPECT_EQ(result.agreement, Agreement::kDisagree);
  EXPECT_NE(result.message.find("0.9"), std::string::npos) << result.message;
  EXPECT_NE(result.message.find("time offset"), std::string::npos);
  EXPECT_FALSE(result.correction);
  EXPECT_EQ(passes.cloud[passes.cloud.size() - 1].z, last) << "as it was captured";
}

TEST(PassAgreement, EndsWhereAPartMovedOnATableThatDidNot) {
  for (const double by : {2e-3, 4e-3, -10e-3}) {
    Table moved;
    moved.block_at = by;
    Passes passes;
    passes.scan(0, Table());
    passes.scan(1, moved);
    EXPECT_EQ(passes.measure().agreement, Agreement::kDisagree) << by;
    const PassAgreement result = passes.mend();
    EXPECT_EQ(result.agreement, Agreement::kDisagree) << by << ": " << result.message;
    EXPECT_NE(result.message.find("a part moved"), std::string::npos) << result.message;
  }
}

TEST(PassAgreement, EndsWhereAPartMovedByLessThanAMillimetreOnATableThatDidNot) {
  for (const Table& moved : {Table{0, 0.5e-3}, Table{0.7e-3, 0}}) {
    for (const double deviation : {0.02e-3, 0.2e-3}) {
      Passes passes;
      passes.scan(0, Table());
      passes.scan(1, moved);
      const PassAgreement result = bring_together(passes.cloud, {deviation});
      EXPECT_EQ(result.agreement, Agreement::kDisagree)
          << moved.block_at << " m aside, " << moved.lifted_by << " m up, " << deviation
          << " m: " << result.message;
      EXPECT_NE(result.message.find("a part moved"), std::string::npos) << result.message;
      ASSERT_EQ(result.overlaps.size(), 1U);
      EXPECT_LT(result.overlaps[0].median, 0.1e-3) << "most of it is the table";
    }
  }
}

TEST(PassAgreement, DoesNotSlideAPlane) {
  const auto plane = [](double, double) { return 0.; };
  Passes passes;
  passes.scan(0, 0, plane);
  passes.scan(1, 0, plane, small_motion({0, 0, 0.1e-3}, {0, 0, 0}));
  const PassAgreement result = passes.mend();
  ASSERT_TRUE(result.correction) << result.message;
  for (const SweepMotion& motion : result.correction->motions) {
    EXPECT_LE(motion.shift.head<2>().norm(), 6e-6)
        << "a twentieth of what the calibration would allow";
    EXPECT_LE(std::abs(motion.turn.z()), 60e-6);
    EXPECT_NEAR(std::abs(motion.shift.z()), 0.05e-3, 0.01e-3) << "each its half";
  }
}

TEST(PassAgreement, IsNotComparedWherePassesHardlyShareASurface) {
  const auto plane = [](double, double) { return 0.; };
  Passes passes;
  passes.scan(0, 0, plane, Eigen::Isometry3d::Identity(), -0.08, 0);
  passes.scan(1, 0, plane, Eigen::Isometry3d::Identity(), -0.05, 0);
  passes.scan(2, 0, plane, Eigen::Isometry3d::Identity(), 0.03, 0.08);
  const PassAgreement result = passes.mend();
  EXPECT_NE(result.agreement, Agreement::kDisagree);
  EXPECT_NE(result.message.find("not compared, since"), std::string::npos) << result.message;
  EXPECT_NE(result.message.find("pass 3 laser_0"), std::string::npos) << result.message;
  Passes apart;
  apart.scan(0, 0, plane, Eigen::Isometry3d::Identity(), -0.08, -0.03);
  apart.scan(1, 0, plane, Eigen::Isometry3d::Identity(), 0.03, 0.08);
  EXPECT_EQ(apart.mend().agreement, Agreement::kNotCompared);
}

TEST(PassAgreement, RaisesNoAlarmWhereASheetIsSeenFromBothSidesAndMovesNothing) {
  for (const double thickness : {2e-3, 0.5e-3}) {
    Passes passes;
    passes.scan_flank(0, -thickness / 2);
    passes.scan_flank(1, thickness / 2);
    const std::vector<float> before = {passes.cloud[0].y, passes.cloud[passes.cloud.size() - 1].y};
    const PassAgreement result = passes.mend();
    EXPECT_NE(result.agreement, Agreement::kDisagree) << thickness << ": " << result.message;
    EXPECT_EQ(passes.cloud[0].y, before[0]) << thickness;
    EXPECT_EQ(passes.cloud[passes.cloud.size() - 1].y, before[1]) << thickness;
  }
}

namespace {

/// Two pairs of passes over a plane, 1.4 m apart. The correction of one must not depend on the
/// others.
class PairsFarApart : public testing::Test {
 protected:
  /// @param error error of the second pass, about its own middle
  /// @param length [m] of each pass
  PassAgreement mend(const Eigen::Isometry3d& error, double length) {
    const auto plane = [](double, double) { return 0.; };
    const Eigen::Translation3d middle(-0.7, 0, 0);
    const auto right = Eigen::Isometry3d::Identity();
    passes_.scan(0, 0, plane, right, -0.7 - length / 2, -0.7 + length / 2);
    passes_.scan(1, 0, plane, middle * error * middle.inverse(), -0.7 - length / 2,
                 -0.7 + length / 2);
    passes_.scan(2, 0, plane, right, 0.7 - length / 2, 0.7 + length / 2);
    passes_.scan(3, 0, plane, right, 0.7 - length / 2, 0.7 + length / 2);
    return passes_.mend();
  }

  Passes passes_;
};

}  // namespace

TEST_F(PairsFarApart, ComeTogetherWhereOneTurnedAboutItsOwnMiddle) {
  const PassAgreement result = mend(small_motion({0, 0, 0}, {0, 1.6e-3, 0}), 0.16);
  EXPECT_EQ(result.agreement, Agreement::kMended) << result.message;
  for (const PassOverlap& overlap : result.overlaps)
    EXPECT_LE(overlap.median, 1.5 * 0.674 * kNoise) << "what is left is the noise";
}

TEST_F(PairsFarApart, GetNoShiftForATurnAboutAPlaceFarAway) {
  const PassAgreement result = mend(small_motion({0, 0, 0.9e-3}, {0, 0, 0}), 0.02);
  EXPECT_EQ(result.agreement, Agreement::kDisagree)
      << "as where the other pair is not there: " << result.message;
}

TEST(PassAgreement, LeavesAPassAloneThatSharesTooLittleToBeCompared) {
  const auto plane = [](double, double) { return 0.; };
  const Eigen::Isometry3d off = small_motion({0, 0, 0.2e-3}, {0, 0, 0});
  Passes passes;
  passes.scan(0, 0, plane, Eigen::Isometry3d::Identity(), -0.08, 0);
  passes.scan(1, 0, plane, Eigen::Isometry3d::Identity(), -0.08, 0);
  passes.scan(2, 0, plane, off, -0.0022, 0.3);
  const float last = passes.cloud[passes.cloud.size() - 1].z;
  const PassAgreement result = passes.mend();
  ASSERT_EQ(result.agreement, Agreement::kMended) << result.message;
  ASSERT_EQ(result.overlaps.size(), 1U);
  EXPECT_NE(result.message.find("pass 3 laser_0"), std::string::npos) << result.message;
  EXPECT_EQ(passes.cloud[passes.cloud.size() - 1].z, last);
}

TEST(PassAgreement, TellsOfAMotionThatTheRobotMayExplainAndDoesNotEnd) {
  Passes passes;
  passes.scan(0, Table());
  passes.scan(1, Table(), small_motion({0, 0, 0.18e-3}, {0, 0, 0}));
  constexpr double kFine = 0.025e-3;  // [m] three of them along an axis are a quarter of that
  const float last = passes.cloud[passes.cloud.size() - 1].z;
  const PassAgreement result = bring_together(passes.cloud, {kFine, kFine});
  EXPECT_EQ(result.agreement, Agreement::kAgree) << result.message;
  EXPECT_NE(result.message.find("not corrected: pass"), std::string::npos) << result.message;
  EXPECT_NE(result.message.find("time offset"), std::string::npos) << result.message;
  EXPECT_FALSE(result.correction);
  EXPECT_EQ(passes.cloud[passes.cloud.size() - 1].z, last) << "as it was captured";
}

TEST(PassAgreement, RaisesNoAlarmAtTheEdgesOfShadows) {
  // A wall of 20 mm: one pass sees the side left of its shadow, the other the side right of it.
  const auto wall = [](double x) { return std::abs(x) < 0.005 ? 0.02 : 0.; };
  const auto from_left = [&](double x, double) {
    return x > 0.005 && x < 0.02 ? std::nan("") : wall(x);
  };
  const auto from_right = [&](double x, double) {
    return x < -0.005 && x > -0.02 ? std::nan("") : wall(x);
  };
  Passes passes;
  passes.scan(0, 0, from_left);
  passes.scan(1, 1, from_right);
  EXPECT_EQ(passes.measure().agreement, Agreement::kAgree);
  const PassAgreement result = passes.mend();
  EXPECT_EQ(result.agreement, Agreement::kMended) << result.message;
  ASSERT_EQ(result.overlaps.size(), 1U);
  EXPECT_EQ(result.overlaps[0].apart, 0U);
}
