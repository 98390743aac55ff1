// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numeric>

#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/program_path.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

Eigen::Isometry3d at(double x, double y, double z = 0) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// A program with its poses in its text, one after the other.
class Text {
 public:
  Text() { text_.files = {{"part.src", ""}}; }

  Text& frames(const Frame& user) {
    text_.program.frames.push_back({{}, user});
    return *this;
  }
  Text& move(MotionKind kind, const Eigen::Isometry3d& pose) {
    Move move;
    move.kind = kind;
    move.pose = pose;
    return add(move);
  }
  Text& arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& pose) {
    Move move;
    move.kind = MotionKind::kCircular;
    move.via = via;
    move.pose = pose;
    return add(move);
  }
  Text& again(std::size_t pose) {
    move(MotionKind::kLinear, text_.poses[pose].pose);
    text_.poses.pop_back();
    text_.steps.back().pose = pose;
    return *this;
  }
  Text& other(const Step& step) {
    text_.program.steps.push_back(step);
    text_.steps.push_back({{0, ++line_}, {}, {}});
    return *this;
  }
  const ProgramText& done() {
    if (text_.program.frames.empty()) frames({});
    return text_;
  }

 private:
  Text& add(Move move) {
    move.frames = text_.program.frames.empty() ? 0 : text_.program.frames.size() - 1;
    StepText step{{0, ++line_}, {}, {}};
    if (move.via) {
      step.via = text_.poses.size();
      text_.poses.push_back({*move.via, {0, line_}});
    }
    step.pose = text_.poses.size();
    text_.poses.push_back({move.pose, {0, line_}});
    text_.program.steps.emplace_back(move);
    text_.steps.push_back(step);
    return *this;
  }

  ProgramText text_;
  std::size_t line_ = 0;
};

constexpr auto kLinear = MotionKind::kLinear;
constexpr auto kJoint = MotionKind::kJoint;

std::size_t waypoints(const ProgramPath& path) {
  return tool_paths::waypoint_count(path.path);
}

TEST(ProgramPath, HasTheLinesAndTheJointMovesNearThem) {
  Text text;
  text.move(kJoint, at(0, 0, 2)).move(kJoint, at(0, 0, 0.1)).move(kLinear, at(0, 0, 0));
  text.move(kLinear, at(0.1, 0)).move(kJoint, at(0, 0, 2));
  const ProgramPath path = path_of(text.done());
  EXPECT_EQ(waypoints(path), 3u);
  ASSERT_EQ(path.kept.size(), 2u);
  EXPECT_EQ(path.kept[0],
            "part.src, line 1: a joint move 2 m from all lines and arcs; it stays as it is");
  EXPECT_EQ(path.sources[0].step, 1u);
}

TEST(ProgramPath, MovesToAnglesOfTheAxesStayAndAreNamed) {
  Text text;
  text.other(JointMove{{0, 0, 0}}).move(kLinear, at(0, 0)).move(kLinear, at(0.1, 0));
  const ProgramPath path = path_of(text.done());
  EXPECT_EQ(waypoints(path), 2u);
  EXPECT_EQ(path.kept[0], "part.src, line 1: goes to angles of the axes; it stays as it is");
  EXPECT_THROW(path_of(Text().other(JointMove{{0}}).done()), UnusableInput);
}

TEST(ProgramPath, SegmentsEndWhereTheOutputChanges) {
  Text text;
  text.move(kLinear, at(0, 0, 0.1)).other(SetOutput{"1", true}).move(kLinear, at(0, 0));
  text.move(kLinear, at(0.1, 0)).other(SetOutput{"1", false}).move(kLinear, at(0.1, 0, 0.1));
  EXPECT_EQ(path_of(text.done()).path.segments.size(), 3u);
}

TEST(ProgramPath, APoseThatIsUsedTwiceIsOneWaypoint) {
  Text text;
  text.move(kLinear, at(0, 0)).move(kLinear, at(0.1, 0)).again(0);
  EXPECT_EQ(waypoints(path_of(text.done())), 2u);
}

TEST(ProgramPath, APoseInTwoFramesIsRefused) {
  Text text;
  text.frames({"base_1", at(1, 0)}).move(kLinear, at(0, 0)).move(kLinear, at(0.1, 0));
  text.frames({"base_2", at(0, 2)}).again(0);
  try {
    path_of(text.done());
    FAIL();
  } catch (const UnusableInput& error) {
    EXPECT_EQ(error.thing(), "part.src, line 3");
  }
}

TEST(ProgramPath, MappedPosesComeBackInTheFramesTheyStandIn) {
  const Eigen::Isometry3d first = at(1, 0) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
  const Eigen::Isometry3d second = at(0, 2) * Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX());
  Text text;
  text.frames({"base_1", first}).move(kLinear, at(0.1, 0.2));
  text.frames({"base_2", second}).move(kLinear, at(0.3, 0.4));
  const Eigen::Isometry3d moved = at(0.5, 0.6) * Eigen::AngleAxisd(2, Eigen::Vector3d::UnitY());
  for (const bool in_base : {true, false}) {
    ProgramPathSettings settings;
    settings.in_base = in_base;
    const ProgramPath path = path_of(text.done(), settings);
    tool_paths::ToolPath adapted = path.path;
    for (auto& segment : adapted.segments)
      for (auto& waypoint : segment.waypoints)
        waypoint.pose = moved * waypoint.pose;
    const Eigen::Isometry3d in_world = in_base ? moved : first * moved * first.inverse();
    const auto poses = poses_of(text.done(), path, adapted);
    EXPECT_TRUE(poses[0].isApprox(first.inverse() * in_world * first * at(0.1, 0.2), 1e-12));
    EXPECT_TRUE(poses[1].isApprox(second.inverse() * in_world * second * at(0.3, 0.4), 1e-12));
  }
}

TEST(ProgramPath, AFrameWhosePlaceIsNotKnownIsRefusedOnlyWhereItMatters) {
  Text one;
  one.frames({"base_1", {}}).move(kLinear, at(0, 0));
  EXPECT_NO_THROW(path_of(one.done()));
  ProgramPathSettings in_base;
  in_base.in_base = true;
  EXPECT_THROW(path_of(one.done(), in_base), UnusableInput);
  one.frames({"base_2", at(0, 1)}).move(kLinear, at(0.1, 0));
  try {
    path_of(one.done());
    FAIL();
  } catch (const UnusableInput& error) {
    EXPECT_EQ(error.thing(), "part.src, line 2");
    EXPECT_EQ(error.value(), "the program does not say where base_1 is");
  }
}

/// Errors of a quarter circle of 0.1 m radius after its places were mapped by a function.
std::vector<double> errors_after(const std::function<Eigen::Vector3d(Eigen::Vector3d)>& map) {
  Text text;
  text.move(kLinear, at(0.1, 0)).arc(at(0.1 * M_SQRT1_2, 0.1 * M_SQRT1_2), at(0, 0.1));
  const ProgramPath path = path_of(text.done());
  tool_paths::ToolPath adapted = path.path;
  for (auto& segment : adapted.segments)
    for (auto& waypoint : segment.waypoints)
      waypoint.pose.translation() = map(waypoint.pose.translation());
  return arc_errors(text.done(), path, adapted);
}

TEST(ProgramPath, AnArcThatStaysACircleHasNoError) {
  const auto errors = errors_after([](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(1.2 * (Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()) * p) +
                           Eigen::Vector3d(1, 2, 3));
  });
  EXPECT_EQ(errors[0], 0);
  EXPECT_NEAR(errors[1], 0, 1e-9);
}

TEST(ProgramPath, AnArcThatIsBentHasItsFarthestPlaceAsError) {
  // out of its plane by 1 mm times sin of four times the angle: 0 at both ends and at the via
  const auto errors = errors_after([](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), 1e-3 * std::sin(4 * std::atan2(p.y(), p.x())));
  });
  EXPECT_NEAR(errors[1], 1e-3, 2e-5);
}

TEST(ProgramPath, AnArcThatIsNoneIsRefused) {
  Text text;
  text.move(kLinear, at(0, 0)).arc(at(0.1, 0), at(0.2, 0));
  EXPECT_THROW(path_of(text.done()), UnusableInput);
  Text unknown;
  unknown.other(JointMove{{0}}).arc(at(0.1, 0), at(0.2, 0.1));
  EXPECT_THROW(path_of(unknown.done()), UnusableInput);
}

}  // namespace
}  // namespace tool_path_programs
