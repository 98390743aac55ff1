// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "fake_scan_cell.h"

using scan_cell::Outcome;
using scan_cell::PassKind;
using scan_cell::PassLasers;
using scan_sequence_test::ScanSequence;

namespace {

/// Three passes: a line with each laser, an arc with both in turn, and a way of two lines.
class ScanInPasses : public ScanSequence {
 protected:
  ScanInPasses() {
    scan_cell::ScanPass there_and_back = line(0.6, 0.9);
    there_and_back.lasers = PassLasers::kEach;
    scan_cell::ScanPass arc = line(0.6, 0.8);
    arc.kind = PassKind::kArc;
    arc.poses = {at(0.6), at(0.7, 0.1), at(0.8)};
    arc.lasers = PassLasers::kAlternate;
    scan_cell::ScanPass way = line(0.6, 0.8);
    way.kind = PassKind::kPolyline;
    way.poses = {at(0.6), at(0.8), at(0.8, 0.2)};
    way.lasers = PassLasers::kLaser1;
    request_.passes = {there_and_back, arc, way};
  }

  std::vector<std::string> targets() const {
    std::vector<std::string> texts;
    for (const scan_cell::MoveTarget& target : robot_.targets) {
      const auto text = [](const Eigen::Isometry3d& pose) {
        return fmt::format("{:g},{:g}", pose.translation().x(), pose.translation().y());
      };
      texts.push_back((target.via ? text(*target.via) + " -> " : "") + text(target.flange));
    }
    return texts;
  }
};

}  // namespace

TEST_F(ScanInPasses, GoesAlongEachPassInItsOrder) {
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kFinished) << end.message;
  EXPECT_EQ(targets(), (std::vector<std::string>{"0.6,0", "0.9,0",    // with laser_0
                                                 "0.6,0",             // back with laser_1
                                                 "0.7,0.1 -> 0.8,0",  // the arc
                                                 "0.6,0", "0.8,0", "0.8,0.2"}));
  EXPECT_EQ(std::count(cell_.log.begin(), cell_.log.end(), "start stages"), 1);
  EXPECT_EQ(std::count(cell_.log.begin(), cell_.log.end(), "start camera"), 1);
  EXPECT_EQ(std::count(cell_.log.begin(), cell_.log.end(), "start run"), 4);
  EXPECT_EQ(std::count(cell_.log.begin(), cell_.log.end(), "triangulate"), 1) << "one cloud";
}

TEST_F(ScanInPasses, RefusesAPassThatCannotBeBoundBeforeAnythingMoves) {
  cell_.unbound_pass = 1;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kRefused);
  EXPECT_EQ(end.message, "pass: cannot be bound; use another method");
  EXPECT_TRUE(cell_.log.empty());
}

TEST_F(ScanInPasses, LightsEachPassAsItAsksAndTellsWhichItIs) {
  run();
  ASSERT_EQ(trigger_.armings.size(), 4U);
  const auto expect = [this](std::size_t i, int lasers, bool alternate) {
    EXPECT_EQ(trigger_.armings[i].lasers, lasers) << i;
    EXPECT_EQ(trigger_.armings[i].alternate, alternate) << i;
  };
  expect(0, 1, false);
  expect(1, 2, false);
  expect(2, 3, true);
  expect(3, 2, false);
  EXPECT_EQ(stages_.passes, (std::vector<std::size_t>{0, 0, 1, 2}));
}

TEST_F(ScanInPasses, BindsThePulsesOfAllPasses) {
  run();
  EXPECT_EQ(stages_.finished_pulses, 4 * 77U);
}

TEST_F(ScanInPasses, KeepsThePassesBeforeOneThatFails) {
  cell_.refused_at = "move 5";  // the way to the last pass
  scan_cell::ScanSequence sequence(robot_, camera_, trigger_, stages_, observer_, {}, timing_);
  const scan_cell::SequenceEnd end = sequence.run(request_, [] { return ""; });
  EXPECT_EQ(end.outcome, Outcome::kMotionFailed);
  EXPECT_EQ(sequence.passes_finished(), 2U);
  EXPECT_EQ(stages_.finished_pulses, 3 * 77U) << "what was captured must be kept";
  EXPECT_TRUE(cell_.noted("triangulate"));
  EXPECT_FALSE(stages_.whole_cloud);
}

TEST_F(ScanInPasses, RefusesABadLaterPassBeforeAnythingMoves) {
  request_.passes[2].speed = 100;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kRefused);
  EXPECT_NE(end.message.find("pass 3: speed"), std::string::npos) << end.message;
  EXPECT_TRUE(cell_.log.empty());
}

TEST_F(ScanInPasses, NamesThePassWhoseLastFramesAreMissing) {
  stages_.missing_at_the_end = 5;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kCameraLost);
  EXPECT_NE(end.message.find("of 77 pulses of pass 1"), std::string::npos) << end.message;
}

TEST_F(ScanInPasses, NamesThatPassAlsoWhereOneBeforeItWasNotPulsed) {
  request_.passes.erase(request_.passes.begin());
  trigger_.silent_arming = 1;
  stages_.missing_at_the_end = 5;
  const scan_cell::SequenceEnd end = run();
  EXPECT_NE(end.message.find("of 77 pulses of pass 2"), std::string::npos) << end.message;
}

TEST_F(ScanInPasses, LosesATriggerThatRefusesInMidMotionWhatItTookBefore) {
  cell_.refused_at = "arm";
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kTriggerLost) << "refused is what was never begun";
  EXPECT_EQ(end.message, "arm: refused; ask for less");
  EXPECT_TRUE(cell_.noted("disarm"));
  EXPECT_TRUE(cell_.noted("stop robot"));
}

TEST_F(ScanInPasses, EndsWhereThePassesMakeNoSingleSurface) {
  stages_.apart = "the passes disagree: 2 mm";
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kPassesDisagree);
  EXPECT_NE(end.message.find("2 mm"), std::string::npos) << end.message;
  EXPECT_TRUE(cell_.noted("triangulate")) << "what was captured is kept";
}
