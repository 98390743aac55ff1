// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Every pose, joint and angle that c4g_protocol.md shows, compared with the arm.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "degree.h"
#include "robot/closed_form.h"
#include "robot/motion_check.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_sim/controller/path.h"
#include "wire/wire_units.h"

using c4g_driver::Joints;
using c4g_driver::WireSix;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// The page's text, each run of blanks and line ends as one blank.
const std::string& page() {
  static const std::string text =
      std::regex_replace(scan_cell_common::read_file(PROTOCOL_DOCUMENT), std::regex("\\s+"), " ");
  return text;
}

WireSix six_of(const std::string& text) {
  WireSix six{};
  std::istringstream stream(std::regex_replace(text, std::regex(","), " "));
  for (double& number : six)
    stream >> number;
  EXPECT_TRUE(stream) << text;
  return six;
}

const std::string kSix = R"(\[(-?[\d.]+(?:, -?[\d.]+){5})\])";

/// All groups of six numbers in brackets that follow these words.
std::vector<WireSix> sixes_after(const std::string& words) {
  std::vector<WireSix> found;
  const std::regex wanted(words + kSix);
  for (std::sregex_iterator it(page().begin(), page().end(), wanted), end; it != end; ++it)
    found.push_back(six_of((*it)[it->size() - 1]));
  return found;
}

const char* const kPose = "(?:\"pose\": |\"tool\": |\"via\": |pose `)";
const char* const kJoints = "(?:\"joints\": |joints `)";
const char* const kFrame = "\"value\": ";

WireSix matched(const std::string& pattern, int group) {
  std::smatch match;
  EXPECT_TRUE(std::regex_search(page(), match, std::regex(pattern))) << pattern;
  return match.empty() ? WireSix{} : six_of(match[static_cast<std::size_t>(group)]);
}

double number_after(const std::string& words) {
  std::smatch match;
  EXPECT_TRUE(std::regex_search(page(), match, std::regex(words + R"((-?[\d.]*\d))"))) << words;
  return match.empty() ? 0 : std::stod(match[1]);
}

/// Within the page's rounding: half of 0.001 mm and half of 0.0001 degree in each number, and their
/// sum over an arm of a metre.
void expect_belongs(const WireSix& joints, const WireSix& pose) {
  const Isometry3d shown = c4g_driver::pose_from_wire(pose);
  const Joints q = c4g_driver::joints_from_wire(joints);
  for (const Isometry3d& flange : {flange_by_denavit_hartenberg(q), smart5_six().flange_at(q)}) {
    EXPECT_LT((flange.translation() - shown.translation()).norm(), 5e-6);
    EXPECT_LT(Eigen::AngleAxisd(flange.linear().transpose() * shown.linear()).angle(),
              3e-4 * kDegree);
  }
}

/// The columns are the flange's axes in the base.
Matrix3d axes(const Vector3d& x, const Vector3d& z) {
  return (Matrix3d() << x, z.cross(x), z).finished();
}

c4g_driver::RobotState standing(const WireSix& joints) {
  c4g_driver::RobotState state;
  state.mode = c4g_driver::ControllerMode::kRemote;
  state.joints = c4g_driver::joints_from_wire(joints);
  state.flange = flange_by_denavit_hartenberg(state.joints);
  return state;
}

c4g_driver::MotionCheck check_from(const c4g_driver::RobotState& from) {
  c4g_driver::RobotLimits limits;
  limits.operation = c4g_driver::Operation::kAutomatic;
  return {smart5_six(), narrowed(limits, smart5_six()), from, {}};
}

}  // namespace

TEST(ProtocolExamples, AreAllPosesJointsOrFrames) {
  EXPECT_EQ(sixes_after("").size(),
            sixes_after(kPose).size() + sixes_after(kJoints).size() + sixes_after(kFrame).size());
  EXPECT_GE(sixes_after(kPose).size(), 3u);
  EXPECT_GE(sixes_after(kJoints).size(), 5u);
}

TEST(ProtocolExamples, ShowAnglesAsTheyAreSent) {
  auto shown = sixes_after(kPose);
  const auto frames = sixes_after(kFrame);
  shown.insert(shown.end(), frames.begin(), frames.end());
  for (const WireSix& pose : shown) {
    EXPECT_TRUE(pose[3] > -180 && pose[3] <= 180) << pose[3];
    EXPECT_TRUE(pose[4] >= 0 && pose[4] <= 180) << pose[4];
    EXPECT_TRUE(pose[5] > -180 && pose[5] <= 180) << pose[5];
    EXPECT_TRUE(pose[3] == 0 || (pose[4] > 0 && pose[4] < 180)) << pose[3];
  }
}

TEST(ProtocolExamples, ShowJointsWithinTheRobotsRanges) {
  for (const WireSix& joints : sixes_after(kJoints)) {
    const Joints q = c4g_driver::joints_from_wire(joints);
    EXPECT_TRUE((q.array() >= smart5_six().lower().array()).all()) << q.transpose();
    EXPECT_TRUE((q.array() <= smart5_six().upper().array()).all()) << q.transpose();
  }
  EXPECT_NEAR(number_after("J3 5 deg is outside "), smart5_six().lower()[2] / kDegree, 1e-9);
  EXPECT_NEAR(number_after("J3 5 deg is outside -170 .. "), smart5_six().upper()[2] / kDegree,
              1e-9);
}

TEST(ProtocolExamples, ShowAStateWhoseJointsBelongToItsPose) {
  const std::string both = "\"pose\": " + kSix + ", \"joints\": " + kSix;
  expect_belongs(matched(both, 2), matched(both, 1));
}

TEST(ProtocolExamples, ShowAStateOnTheWayOfItsMotion) {
  const WireSix start = matched("\"MOVE_JOINT\", \"joints\": " + kSix, 1);
  const WireSix end = matched("\"MOVE_CARTESIAN\", \"pose\": " + kSix, 1);
  const WireSix now = matched("\"type\": \"state\".*?\"pose\": " + kSix, 1);
  const double motion = number_after("\"type\": \"state\".*?\"motion\": ");
  EXPECT_EQ(motion, number_after("\"seq\": (?=\\d+, \"cmd\": \"MOVE_CARTESIAN\")"));
  const double progress = number_after("\"type\": \"state\".*?\"progress\": ");
  const Isometry3d from = standing(start).flange;
  const Isometry3d to = c4g_driver::pose_from_wire(end);
  const Vector3d expected = from.translation() + progress * (to.translation() - from.translation());
  EXPECT_LT((c4g_driver::pose_from_wire(now).translation() - expected).norm(), 1e-6);
  EXPECT_TRUE(to.linear().isApprox(from.linear(), 1e-9)) << "the line does not turn";
  EXPECT_EQ(number_after("\"type\": \"state\".*?\"linear_speed\": "),
            number_after("\"SET_LINSPEED\", \"linear_speed\": "));
}

TEST(ProtocolExamples, ShowMotionsThatTheRobotCanMake) {
  const auto start = standing(matched("\"MOVE_JOINT\", \"joints\": " + kSix, 1));
  const auto target =
      c4g_driver::pose_from_wire(matched("\"MOVE_CARTESIAN\", \"pose\": " + kSix, 1));
  EXPECT_NO_THROW(check_from(start).to_pose(target));
  EXPECT_NO_THROW(scan_cell_sim::plan_line(start.joints, target, {}));
}

TEST(ProtocolExamples, ShowAnArcRoundAnUprightAxisThatTheRobotCanMake) {
  const std::string arc = "\"MOVE_CIRCULAR\", \"via\": " + kSix + ", \"pose\": " + kSix;
  const auto start =
      c4g_driver::pose_from_wire(matched("\"MOVE_CARTESIAN\", \"pose\": " + kSix, 1));
  const auto via = c4g_driver::pose_from_wire(matched(arc, 1));
  const auto target = c4g_driver::pose_from_wire(matched(arc, 2));
  const Isometry3d quarter = via * start.inverse();
  EXPECT_TRUE((quarter * via).isApprox(target, 1e-9)) << "it turns evenly";
  EXPECT_TRUE(quarter.linear().col(2).isApprox(Vector3d::UnitZ(), 1e-9));
  c4g_driver::RobotState standing;
  standing.mode = c4g_driver::ControllerMode::kRemote;
  standing.joints = scan_cell_sim::reach(start, Joints::Zero());
  standing.flange = flange_by_denavit_hartenberg(standing.joints);
  EXPECT_NO_THROW(check_from(standing).along_arc(via, target));
  EXPECT_NO_THROW(scan_cell_sim::plan_arc(standing.joints, via, target, {}));
}

TEST(ProtocolExamples, ShowTheFlangeLookingDownAsTheyDescribeIt) {
  const WireSix joints = matched("With the joints `" + kSix + "` the upper arm stands upright", 1);
  const Isometry3d flange = standing(joints).flange;
  EXPECT_TRUE(flange.linear().isApprox(axes(Vector3d::UnitX(), -Vector3d::UnitZ()), 1e-12));
  // by hand: the forearm, 130 mm above the upper arm's end, is level; the flange hangs below it
  const Vector3d expected(0.150 + 0.64707, 0, 0.450 + 0.590 + 0.130 - 0.095);
  EXPECT_TRUE(flange.translation().isApprox(expected, 1e-12));
}

TEST(ProtocolExamples, ShowALineThroughTheStraightWristThatIsRefused) {
  const std::string line =
      "from the joints `" + kSix + "` to the pose `" + kSix + "`, which the joints `" + kSix + "`";
  const WireSix pose = matched(line, 2);
  expect_belongs(matched(line, 3), pose);
  const auto from = standing(matched(line, 1));
  const auto target = c4g_driver::pose_from_wire(pose);
  EXPECT_THROW(check_from(from).to_pose(target), scan_cell_common::Refused);
  try {
    scan_cell_sim::plan_line(from.joints, target, {});
    ADD_FAILURE() << "was not refused";
  } catch (const scan_cell_sim::ControllerRefusal& refused) {
    EXPECT_EQ(static_cast<int>(refused.code()), number_after("It is refused with error "));
  }
  const double stretched = number_after("J3 = ");
  EXPECT_NEAR(stretched, -std::atan2(0.130, 0.64707) / kDegree, 5e-5);
}

TEST(ProtocolExamples, ShowAnglesThatTurnTheFlangeAsTheySay) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const std::map<std::string, Matrix3d> said = {{"like the base", axes(x, z)},
                                                {"z down, x along the base's x", axes(x, -z)},
                                                {"z down, x along the base's y", axes(y, -z)},
                                                {"z along the base's x, x down", axes(-z, x)},
                                                {"z along the base's y, x down", axes(-z, y)}};
  const std::string text = scan_cell_common::read_file(PROTOCOL_DOCUMENT);
  const std::string head = "| pose of the flange | A, E, R |\n|---|---|\n";
  ASSERT_NE(text.find(head), std::string::npos);
  std::istringstream table(text.substr(text.find(head) + head.size()));
  const std::regex angles(R"((-?\d+), (-?\d+), (-?\d+))");
  std::size_t rows = 0;
  for (std::string row; std::getline(table, row) && !row.empty(); ++rows) {
    const std::string words = row.substr(2, row.find(" |") - 2);
    ASSERT_EQ(said.count(words), 1u) << words;
    for (std::sregex_iterator it(row.begin(), row.end(), angles), end; it != end; ++it) {
      const WireSix wire = six_of("0, 0, 0, " + it->str());
      EXPECT_TRUE(c4g_driver::pose_from_wire(wire).linear().isApprox(said.at(words), 1e-12)) << row;
    }
  }
  EXPECT_EQ(rows, said.size());
}
