// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Passes with their own camera settings.
#include "fake_scan_cell.h"

using scan_cell::CameraRegion;
using scan_cell::Outcome;
using scan_cell::PassCamera;
using scan_cell::PassLasers;
using scan_sequence_test::ScanSequence;

namespace {

/// The first and the last pass leave the camera as it is, the others expose for longer.
class CameraOfPasses : public ScanSequence {
 protected:
  CameraOfPasses() {
    bright_.exposure = 0.004;
    bright_.region = CameraRegion{0, 600, 1000, 500};
    bright_.detector = "threshold";
    scan_cell::ScanPass second = line(0.9, 0.6);
    second.camera = bright_;
    second.lasers = PassLasers::kAlternate;
    scan_cell::ScanPass third = line(0.6, 0.9);
    third.camera = bright_;
    request_.passes = {line(0.6, 0.9), second, third, line(0.9, 0.6)};
  }

  std::size_t count(const std::string& call) const {
    return static_cast<std::size_t>(std::count(cell_.log.begin(), cell_.log.end(), call));
  }

  PassCamera bright_;
};

}  // namespace

TEST_F(CameraOfPasses, AreSetBeforeTheirPassAndUndoneAfterIt) {
  EXPECT_EQ(run().outcome, Outcome::kFinished);
  const std::vector<PassCamera> expected = {bright_,  // tried before anything moves
                                            {},
                                            bright_,
                                            {}};
  ASSERT_EQ(camera_.settings.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_TRUE(camera_.settings[i] == expected[i]) << i;
  EXPECT_EQ(count("restore camera"), 1U);
  EXPECT_LT(cell_.place("stop camera"), cell_.place("restore camera"));
}

TEST_F(CameraOfPasses, AreToldToTheTriggerWhichHoldsTheLasersForSoLong) {
  run();
  ASSERT_EQ(trigger_.armings.size(), 4U);
  EXPECT_EQ(trigger_.armings[0].exposure, 0.001) << "as the camera was";
  EXPECT_EQ(trigger_.armings[1].exposure, 0.004);
  EXPECT_TRUE(trigger_.armings[1].alternate);
  EXPECT_EQ(trigger_.armings[3].exposure, 0.001);
}

TEST_F(CameraOfPasses, AreRefusedByTheNameOfThePassBeforeAnythingMoves) {
  cell_.refused_at = "start camera";
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kRefused);
  EXPECT_EQ(end.message.find("pass 2: camera: settings refused; start camera: refused"), 0U)
      << end.message;
  EXPECT_EQ(cell_.moves, 0);
  EXPECT_TRUE(cell_.noted("restore camera"));
  EXPECT_FALSE(cell_.noted("start stages"));
}

TEST_F(CameraOfPasses, AreRefusedWhereTheyLeaveLasersNoTimeToTakeTurnsBeforeAnythingMoves) {
  trigger_.most_to_alternate = 0.003;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kRefused);
  EXPECT_EQ(end.message,
            "pass 2: trigger: arming refused; rate: 100 Hz to alternate; expose for less");
  EXPECT_EQ(cell_.moves, 0);
  EXPECT_FALSE(cell_.noted("start stages"));
  EXPECT_TRUE(cell_.noted("restore camera"));
}

TEST_F(CameraOfPasses, AreNotNeededToRefuseLasersThatHaveNoTimeToTakeTurns) {
  trigger_.most_to_alternate = 0.0005;
  request_.passes = {line(0.6, 0.9)};
  EXPECT_EQ(run().outcome, Outcome::kFinished) << "one laser takes no turns";
  cell_ = {};
  observer_.last = 0;
  request_.passes[0].lasers = PassLasers::kAlternate;
  EXPECT_EQ(run().outcome, Outcome::kRefused) << "the camera's own 1 ms";
  EXPECT_EQ(cell_.moves, 0);
}

TEST_F(CameraOfPasses, AreUndoneWhereTheScanEndsEarly) {
  robot_.fails = true;
  EXPECT_EQ(run().outcome, Outcome::kMotionFailed);
  EXPECT_TRUE(cell_.noted("restore camera"));
}

TEST_F(CameraOfPasses, AreUndoneWhateverTheStagesThrow) {
  stages_.breaks = true;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kStageFailed);
  EXPECT_TRUE(cell_.noted("restore camera"));
}

TEST_F(CameraOfPasses, AreAWarningWhereTheyCannotBeUndone) {
  camera_.restores = false;
  scan_cell::ScanSequence sequence(robot_, camera_, trigger_, stages_, observer_, {}, timing_);
  EXPECT_EQ(sequence.run(request_, [] { return ""; }).outcome, Outcome::kFinished);
  EXPECT_EQ(sequence.warnings(), std::vector<std::string>{"camera: not as before"});
}
