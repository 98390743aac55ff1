// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "scan_cell_common/errors/errors.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/stretcher.h"
#include "tool_paths/tool_path_files.h"

using namespace tool_path_stretcher;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMillimetres = 1000;
constexpr double kInches = 1 / 0.0254;

/// A frame, the same frame rotated and moved, and a path on it.
struct Input {
  Points reference;
  Points object;
  ToolPath path;

  std::vector<Waypoint>& waypoints() { return path.segments[0].waypoints; }
};

const Input& good_input() {
  static const Input input = [] {
    const synthetic::Part part = synthetic::photo_frame();
    const Similarity moved =
        synthetic::similarity(1.08, synthetic::random_rotation(4), {0.4, 0, 1});
    synthetic::Scan scan;
    Input result;
    result.object = synthetic::scan(part, moved, synthetic::no_deformation(), scan);
    scan.seed = 11;
    result.reference = synthetic::scan(part, {}, synthetic::no_deformation(), scan);
    result.path = synthetic::path_on(part, 100);
    return result;
  }();
  return input;
}

/// Runs like the command and the action: an error is a refusal too.
StretchResult run(const Input& input, const StretchParameters& parameters = {}) {
  StretchResult result;
  try {
    result = stretch(surface_from_cloud(input.reference, parameters.leaf, "reference"),
                     surface_from_cloud(input.object, parameters.leaf, "object"), input.path,
                     parameters);
  } catch (const scan_cell_common::Error& error) {
    result.verdict = {Reason::kUnusableInput, error.what(), {}};
  }
  return result;
}

void scale(Points& points, double factor) {
  for (Eigen::Vector3d& point : points)
    point *= factor;
}

void scale(ToolPath& path, double factor) {
  for (Segment& segment : path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.pose.translation() *= factor;
  }
}

Points repeated(const Points& points, int times) {
  Points result;
  for (const Eigen::Vector3d& point : points)
    result.insert(result.end(), static_cast<std::size_t>(times), point);
  return result;
}

struct BadCase {
  const char* name;
  std::function<void(Input&)> spoil;
  Reason reason;
  std::vector<std::string> said;
};

void PrintTo(const BadCase& bad, std::ostream* out) {
  *out << bad.name;
}

class BadInput : public testing::TestWithParam<BadCase> {};

const BadCase kClouds[] = {
    {"NanPoints",
     [](Input& input) {
       for (std::size_t i = 0; i < input.object.size(); i += 2)
         input.object[i].z() = kNan;
     },
     Reason::kUnusableInput,
     {"object: 10000 of 20000 points are not finite", "remove them"}},
    {"InfinitePoint",
     [](Input& input) { input.reference[7].x() = -kInfinity; },
     Reason::kUnusableInput,
     {"reference: 1 of 20000 points are not finite"}},
    {"EmptyObject",
     [](Input& input) { input.object.clear(); },
     Reason::kUnusableInput,
     {"object: no points"}},
    {"EmptyReference",
     [](Input& input) { input.reference.clear(); },
     Reason::kUnusableInput,
     {"reference: no points"}},
    {"OnePlace",
     [](Input& input) {
       input.object.assign(20000, {1, 2, 3});
     },
     Reason::kUnusableInput,
     {"object: all its points lie on one line or in one place", "covers the surface"}},
    {"OneLine",
     [](Input& input) {
       for (std::size_t i = 0; i < input.object.size(); ++i)
         input.object[i] = {1e-4 * static_cast<double>(i), 2, 3};
     },
     Reason::kUnusableInput,
     {"object: all its points lie on one line"}},
    {"TwoPoints",
     [](Input& input) { input.object.resize(2); },
     Reason::kUnusableInput,
     {"object: all its points lie on one line"}},
    {"ThreePoints",
     [](Input& input) {
       input.object = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
     },
     Reason::kTooFewPoints,
     {"object: 3 points after the grid reduction", "scan more densely"}},
    {"OnePointFarAway",
     [](Input& input) { input.object[9].x() = 1e6; },
     Reason::kUnusableInput,
     {"object: 1 of ", "points lie far away from all others", "cloud_preprocess"}},
    {"OnePointBeyondAllCells",
     [](Input& input) { input.object[9].x() = 1e30; },
     Reason::kUnusableInput,
     {"object, point 9: at 1e+30 m", "remove outliers"}},
    {"TinyCloud",
     [](Input& input) { scale(input.object, 1e-30); },
     Reason::kUnusableInput,
     {"object: all its points lie on one line or in one place"}},
    {"HugeCloud",
     [](Input& input) { scale(input.object, 1e10); },
     Reason::kUnusableInput,
     {"object: its size is 1.", "e+10 times the reference's"}},
};

const BadCase kUnits[] = {
    {"ObjectInMillimetres",
     [](Input& input) { scale(input.object, kMillimetres); },
     Reason::kUnusableInput,
     {"object: its size is 107", "a ratio near 1000", "millimetres"}},
    {"ReferenceInMillimetres",
     [](Input& input) { scale(input.reference, kMillimetres); },
     Reason::kUnusableInput,
     {"object: its size is 0.0010", "0.001 means that one is in millimetres"}},
    {"BothCloudsInMillimetres",
     [](Input& input) {
       scale(input.reference, kMillimetres);
       scale(input.object, kMillimetres);
     },
     Reason::kUnusableInput,
     {"reference: its points lie 8", "m from their middle", "seems to be in millimetres"}},
    {"AllInMillimetres",
     [](Input& input) {
       scale(input.reference, kMillimetres);
       scale(input.object, kMillimetres);
       scale(input.path, kMillimetres);
     },
     Reason::kUnusableInput,
     {"reference: its points lie 8", "seems to be in millimetres"}},
    {"PathInMillimetres",
     [](Input& input) { scale(input.path, kMillimetres); },
     Reason::kUnusableInput,
     {"tool path: it lies on the reference only if it is divided by 1000", "--path-units mm"}},
    {"PathInInches",
     [](Input& input) { scale(input.path, kInches); },
     Reason::kUnusableInput,
     {"only if it is divided by 39.37", "--path-units inch"}},
};

const BadCase kPaths[] = {
    {"NoSegments",
     [](Input& input) { input.path.segments.clear(); },
     Reason::kUnusableInput,
     {"no waypoints", "give at least one"}},
    {"EmptySegment",
     [](Input& input) { input.path.segments[1].waypoints.clear(); },
     Reason::kUnusableInput,
     {"segment 1: no waypoints"}},
    {"NanWaypoint",
     [](Input& input) { input.waypoints()[5].pose.translation().y() = kNan; },
     Reason::kUnusableInput,
     {"segment 0 waypoint 5: not finite"}},
    {"ScaledRotation",
     [](Input& input) { input.waypoints()[5].pose.linear() *= 2; },
     Reason::kUnusableInput,
     {"segment 0 waypoint 5: its orientation is not a rotation", "unit quaternions"}},
    {"ZeroRotation",
     [](Input& input) { input.waypoints()[5].pose.linear().setZero(); },
     Reason::kUnusableInput,
     {"segment 0 waypoint 5: its orientation is not a rotation"}},
    {"MirroredRotation",
     [](Input& input) { input.waypoints()[5].pose.linear().col(0) *= -1; },
     Reason::kUnusableInput,
     {"segment 0 waypoint 5: its orientation is not a rotation"}},
    {"ProcessValueMissing",
     [](Input& input) { input.waypoints()[5].process_values.pop_back(); },
     Reason::kUnusableInput,
     {"segment 0 waypoint 5: 1 process values for 2 names"}},
    {"ProcessValueNan",
     [](Input& input) { input.waypoints()[5].process_values[0] = kNan; },
     Reason::kUnusableInput,
     {"segment 0 waypoint 5: a process value is not finite"}},
    {"PathFarAway",
     [](Input& input) {
       for (Waypoint& waypoint : input.waypoints())
         waypoint.pose.translation().x() += 100;
     },
     Reason::kPathOffReference,
     {"tool path: 50 of 100 waypoints lie off the reference", "max_stand_off"}},
    {"PathBeyondAllDistances",
     [](Input& input) { scale(input.path, 1e200); },
     Reason::kPathOffReference,
     {"tool path: 100 of 100 waypoints lie off the reference"}},
};

}  // namespace

TEST_P(BadInput, IsRefusedByNameWithTheCure) {
  Input input = good_input();
  GetParam().spoil(input);
  const StretchResult result = run(input);
  EXPECT_EQ(to_string(result.verdict.reason), to_string(GetParam().reason));
  EXPECT_TRUE(result.path.segments.empty());
  for (const std::string& part : GetParam().said)
    EXPECT_NE(result.verdict.message.find(part), std::string::npos) << result.verdict.message;
}

std::string name_of(const testing::TestParamInfo<BadCase>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Clouds, BadInput, testing::ValuesIn(kClouds), name_of);
INSTANTIATE_TEST_SUITE_P(Units, BadInput, testing::ValuesIn(kUnits), name_of);
INSTANTIATE_TEST_SUITE_P(Paths, BadInput, testing::ValuesIn(kPaths), name_of);

/// [m] Sums in another order round differently, and a fit may converge a step sooner.
constexpr double kRounded = 1e-5;

TEST(OddInput, PointsThatOccurThriceChangeNothing) {
  Input input = good_input();
  const StretchResult once = run(input);
  ASSERT_TRUE(once.verdict.accepted()) << once.verdict.message;
  input.object = repeated(input.object, 3);
  const StretchResult thrice = run(input);
  ASSERT_TRUE(thrice.verdict.accepted()) << thrice.verdict.message;
  EXPECT_LT(synthetic::error_of(thrice.path, once.path).max, kRounded);
}

TEST(OddInput, AMillionPointsInOnePlaceDoNotHideThePart) {
  Input input = good_input();
  const StretchResult without = run(input);
  input.object.insert(input.object.end(), 1000000, input.object[5]);
  const StretchResult result = run(input);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_LT(synthetic::error_of(result.path, without.path).max, 0.0001);
}

TEST(OddInput, OneWaypointIsAPath) {
  Input input = good_input();
  input.path.segments.resize(1);
  input.waypoints().resize(1);
  const StretchResult result = run(input);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_EQ(waypoint_count(result.path), 1U);
}

TEST(OddInput, WaypointsInOnePlaceStayThere) {
  Input input = good_input();
  for (Waypoint& waypoint : input.waypoints())
    waypoint.pose = input.waypoints()[0].pose;
  const StretchResult result = run(input);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const std::vector<Waypoint>& waypoints = result.path.segments[0].waypoints;
  for (const Waypoint& waypoint : waypoints)
    EXPECT_LT((waypoint.pose.translation() - waypoints[0].pose.translation()).norm(), 1e-9);
}

TEST(SameBytes, ComeFromSeveralThreadsAtOnce) {
  const std::string alone = tool_paths::tool_path_to_csv(run(good_input()).path);
  ASSERT_GT(alone.size(), 1000U);
  std::vector<std::string> results(3);
  std::vector<std::thread> threads;
  for (std::string& result : results)
    threads.emplace_back(
        [&result] { result = tool_paths::tool_path_to_csv(run(good_input()).path); });
  for (std::thread& thread : threads)
    thread.join();
  for (const std::string& result : results)
    EXPECT_TRUE(result == alone);
}

TEST(SameVerdict, ComesWhateverTheOrderOfThePoints) {
  Input input = good_input();
  const StretchResult before = run(input);
  std::mt19937 engine(3);
  std::shuffle(input.reference.begin(), input.reference.end(), engine);
  std::shuffle(input.object.begin(), input.object.end(), engine);
  const StretchResult after = run(input);
  ASSERT_TRUE(after.verdict.accepted()) << after.verdict.message;
  EXPECT_LT(synthetic::error_of(after.path, before.path).max, kRounded);
}
