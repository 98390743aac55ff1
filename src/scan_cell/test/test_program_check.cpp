// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// A whole program is checked before anything moves.
#include "fake_scan_cell.h"
#include "sequence/program_check.h"

using scan_cell::Outcome;
using scan_cell::PassKind;
using scan_cell::PassLasers;
using scan_sequence_test::ScanSequence;

namespace {

class ProgramCheck : public ScanSequence {
 protected:
  ProgramCheck() {
    scan_cell::ScanPass there_and_back = line(0.6, 0.9);
    there_and_back.name = "flank";
    there_and_back.lasers = PassLasers::kEach;
    scan_cell::ScanPass arc = line(0.6, 0.8);
    arc.kind = PassKind::kArc;
    arc.poses = {at(0.6), at(0.7, 0.1), at(0.8)};
    arc.speed = 0.05;
    scan_cell::ScanPass way = line(0.6, 0.8);
    way.kind = PassKind::kPolyline;
    way.poses = {at(0.7), at(0.8), at(0.8, 0.2)};
    request_.passes = {there_and_back, arc, way};
  }

  std::vector<std::string> check_at_rest() {
    return scan_cell::check_at_rest({robot_, trigger_, stages_},
                                    scan_cell::runs_of(request_.passes), 0.2);
  }

  std::string refusal_of(std::size_t motion) {
    robot_.impossible = motion;
    const scan_cell::SequenceEnd end = run();
    EXPECT_EQ(end.outcome, Outcome::kRefused) << end.message;
    EXPECT_TRUE(cell_.log.empty()) << "nothing may move, no stage begins";
    observer_.last = 0;
    return end.message;
  }
};

}  // namespace

TEST_F(ProgramCheck, AsksForJustTheMotionsThatAreMadeLater) {
  EXPECT_EQ(run().outcome, Outcome::kFinished);
  ASSERT_EQ(robot_.checked.size(), robot_.targets.size());
  for (std::size_t i = 0; i < robot_.targets.size(); ++i) {
    EXPECT_TRUE(robot_.checked[i].target.flange.isApprox(robot_.targets[i].flange)) << i;
    EXPECT_EQ(robot_.checked[i].target.via.has_value(), robot_.targets[i].via.has_value()) << i;
  }
  const std::vector<std::pair<double, double>> speeds_and_rates = {
      {0.2, 0},    {0.1, 100}, {0.1, 100},  // to the start, there, and back
      {0.05, 100},                          // the arc begins where the line ends
      {0.2, 0},    {0.1, 100}, {0.1, 100}};
  ASSERT_EQ(robot_.checked.size(), speeds_and_rates.size());
  for (std::size_t i = 0; i < speeds_and_rates.size(); ++i) {
    EXPECT_EQ(robot_.checked[i].speed, speeds_and_rates[i].first) << i;
    EXPECT_EQ(robot_.checked[i].camera_rate, speeds_and_rates[i].second) << i;
  }
}

TEST_F(ProgramCheck, NamesThePassAndThePlaceThatTheRobotCannotGoBeforeAnythingMoves) {
  const std::string where =
      ": the robot cannot follow it at 1.000 2.000 3.000 m in its base frame; line: passes a "
      "singular posture";
  EXPECT_EQ(refusal_of(0), "pass 1 (flank), the way to its start" + where);
  EXPECT_EQ(refusal_of(2), "pass 1 (flank), its line" + where);
  EXPECT_EQ(refusal_of(3), "pass 2, its arc" + where);
  EXPECT_EQ(refusal_of(4), "pass 3, the way to its start" + where);
  EXPECT_EQ(refusal_of(6), "pass 3, its line 2 of 2" + where);
}

TEST_F(ProgramCheck, ScansAndSaysSoWhereTheDriverCannotCheck) {
  robot_.checks = false;
  scan_cell::ScanSequence sequence(robot_, camera_, trigger_, stages_, observer_, {}, timing_);
  EXPECT_EQ(sequence.run(request_, [] { return ""; }).outcome, Outcome::kFinished);
  ASSERT_EQ(sequence.warnings().size(), 1U);
  EXPECT_NE(sequence.warnings()[0].find("were not checked"), std::string::npos);
  robot_.checks = true;
  observer_.last = 0;
  EXPECT_EQ(sequence.run(request_, [] { return ""; }).outcome, Outcome::kFinished);
  EXPECT_TRUE(sequence.warnings().empty()) << "those of the last scan are forgotten";
}

TEST_F(ProgramCheck, IsARobotThatIsLostWhereItDoesNotAnswer) {
  cell_.throws_at = "check";
  EXPECT_EQ(run().outcome, Outcome::kRobotLost);
  EXPECT_FALSE(cell_.noted("move 1"));
}

TEST_F(ProgramCheck, SaysSoWhereTheTriggerCannotTellWhetherItWouldBeArmed) {
  trigger_.checks = false;
  scan_cell::ScanSequence sequence(robot_, camera_, trigger_, stages_, observer_, {}, timing_);
  EXPECT_EQ(sequence.run(request_, [] { return ""; }).outcome, Outcome::kFinished);
  ASSERT_EQ(sequence.warnings().size(), 1U);
  EXPECT_NE(sequence.warnings()[0].find("rates and lasers"), std::string::npos);
}

TEST_F(ProgramCheck, LeavesTheCameraAloneWhereNothingIsScannedAndSaysWhatThatLeavesOpen) {
  EXPECT_EQ(check_at_rest(), std::vector<std::string>());
  request_.passes[0].camera.detector = "threshold";
  request_.passes[1].lasers = PassLasers::kAlternate;
  const std::vector<std::string> warnings = check_at_rest();
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[0].find("settings of its pass was not checked (pass 1 (flank)):"),
            std::string::npos)
      << warnings[0];
  EXPECT_NE(warnings[1].find("take turns was not checked (pass 2):"), std::string::npos)
      << warnings[1];
  EXPECT_TRUE(camera_.settings.empty());
  EXPECT_TRUE(cell_.log.empty());
}

TEST_F(ProgramCheck, RefusesAnExposureOfItsOwnThatLeavesLasersNoTimeAlsoWhereNothingIsScanned) {
  trigger_.most_to_alternate = 0.003;
  request_.passes[1].lasers = PassLasers::kAlternate;
  EXPECT_NO_THROW(check_at_rest()) << "nobody knows the exposure";
  request_.passes[1].camera.exposure = 0.004;
  try {
    check_at_rest();
    FAIL() << "it was not refused";
  } catch (const scan_cell::EndEarly& end) {
    EXPECT_EQ(end.outcome, Outcome::kRefused);
    EXPECT_EQ(end.message.find("pass 2: trigger: arming refused"), 0U) << end.message;
  }
}

TEST_F(ProgramCheck, TellsADeviceThatDoesNotAnswerFromOneThatRefuses) {
  cell_.throws_at = "check";
  try {
    check_at_rest();
    FAIL() << "nobody was asked";
  } catch (const scan_cell::EndEarly& end) {
    EXPECT_EQ(end.outcome, Outcome::kRobotLost);
  }
}
