// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "gcode/gcode.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

ProgramText read(const std::string& text, const ReadSettings& settings = {}) {
  return gcode().read({{"part.nc", text}}, settings);
}

std::string fault_of(const std::string& text, const ReadSettings& settings = {}) {
  try {
    read(text, settings);
  } catch (const UnusableInput& error) {
    return error.thing() + ": " + error.value();
  }
  return "";
}

const Move& move_of(const ProgramText& text, std::size_t step) {
  return std::get<Move>(text.program.steps.at(step));
}

TEST(GcodeReader, ReadsModalWordsCommentsOutputsAndFrames) {
  const ProgramText text = read(
      "%\nO0042 (RIM)\nN10 G21 G17 G90 G94 G40 (mm; absolute)\nN20 T3 M6 ; torch\nN30 G43 H3\n"
      "N40 G54\nG64 P.05\nG0 X0 Y0\nZ50\nM3 S900\nG1 Z5 F600\nX10.5\nG61\nM64 P2\ny-.5 f300\n"
      "G4 P0.5\nM65 P2\nM5\nG55 G0 Z50\nM30\nG1 X99\n%\n");
  EXPECT_EQ(text.dialect, "xyz");
  EXPECT_EQ(text.program.name, "part");
  ASSERT_EQ(text.program.steps.size(), 10u);
  EXPECT_TRUE(std::holds_alternative<JointMove>(text.program.steps[0]));  // Z is unknown
  EXPECT_EQ(move_of(text, 1).kind, MotionKind::kJoint);
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[2]).output, "spindle");
  EXPECT_EQ(move_of(text, 3).kind, MotionKind::kLinear);
  EXPECT_NEAR(move_of(text, 3).speed, 0.01, 1e-15);
  EXPECT_NEAR(move_of(text, 3).zone, 5e-5, 1e-15);
  EXPECT_TRUE(
      move_of(text, 4).pose.translation().isApprox(Eigen::Vector3d(0.0105, 0, 0.005), 1e-12));
  EXPECT_EQ(text.steps[4].place.line, 12u);
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[5]).output, "2");
  EXPECT_NEAR(move_of(text, 6).speed, 0.005, 1e-15);
  EXPECT_EQ(move_of(text, 6).zone, 0);
  EXPECT_FALSE(std::get<SetOutput>(text.program.steps[7]).on);
  EXPECT_EQ(text.program.frames[move_of(text, 6).frames].user.name, "G54");
  EXPECT_EQ(text.program.frames[move_of(text, 6).frames].tool.name, "3");
  EXPECT_EQ(text.program.frames[move_of(text, 9).frames].user.name, "G55");
}

TEST(GcodeReader, InchesAreInches) {
  const ProgramText text = read("G20\nG0 X1 Y2 Z0\nG1 X-.5 F10\n");
  EXPECT_NEAR(move_of(text, 1).pose.translation().x(), -0.0127, 1e-15);
  EXPECT_NEAR(move_of(text, 1).speed, 0.254 / 60, 1e-15);
}

TEST(GcodeReader, ArcsHaveTheirMiddleAsVia) {
  const ProgramText text = read("G0 X10 Y0 Z3\nG3 X0 Y10 I-10 J0 F100\n");
  EXPECT_EQ(move_of(text, 1).kind, MotionKind::kCircular);
  EXPECT_LT((1e3 * move_of(text, 1).via->translation() -
             Eigen::Vector3d(10 * M_SQRT1_2, 10 * M_SQRT1_2, 3))
                .norm(),
            1e-9);
}

TEST(GcodeReader, TellsTheDialectByItsAxes) {
  EXPECT_EQ(read("G0 X0 Y0 Z0 A1 C1\n").dialect, "xyzac");
  EXPECT_EQ(read("G0 X0 Y0 Z0 B1 C1\n").dialect, "xyzbc");
  EXPECT_EQ(read("G0 X0 Y0 Z0 A1 B1 C1\n").dialect, "xyzabc");
  EXPECT_EQ(fault_of("G0 X0 Y0 Z0 A1\n"), "part.nc: rotary axes A");
  ReadSettings settings;
  settings.dialect = "xyz";
  EXPECT_EQ(fault_of("G0 X0 Y0 Z0 A1\n", settings),
            "part.nc, line 1: A1, an axis that xyz does not have");
}

TEST(GcodeReader, PlacesOfTheMachineItselfStay) {
  const ProgramText text = read("G91 G28 Z0\nG90\nG0 X1 Y1\nG53 G0 Z-10\nG0 X1 Y1 Z1\nG28\nX5\n");
  std::vector<bool> stay;
  for (const Step& step : text.program.steps)
    stay.push_back(std::holds_alternative<JointMove>(step));
  EXPECT_EQ(stay, (std::vector<bool>{true, true, true, false, true, true}));
}

TEST(GcodeReader, RefusesWhatItCannotResolve) {
  const std::string start = "G0 X0 Y0 Z0\nF100\n";
  const auto fault = [&](const std::string& line) { return fault_of(start + line + "\n"); };
  EXPECT_EQ(fault("G1 X#3"), "part.nc, line 3: X#3");
  EXPECT_EQ(fault("G1 X[2+3]"), "part.nc, line 3: X[2+3]");
  EXPECT_EQ(fault("G91 G1 X1"), "part.nc, line 3: incremental positions (G91)");
  EXPECT_EQ(fault("G81 X1 Z-3 R1"), "part.nc, line 3: G81");
  EXPECT_EQ(fault("G92 X0"), "part.nc, line 3: G92");
  EXPECT_EQ(fault("G41 D1"), "part.nc, line 3: G41");
  EXPECT_EQ(fault("G10 L2 P1 X5"), "part.nc, line 3: G10");
  EXPECT_EQ(fault("o100 sub"), "part.nc, line 3: a subroutine or a condition (O word)");
  EXPECT_EQ(fault("M98 P1000"), "part.nc, line 3: calls M98");
  EXPECT_EQ(fault("M101"), "part.nc, line 3: calls M101");
  EXPECT_EQ(fault("/G1 X1"), "part.nc, line 3: a move that may be skipped (/)");
  EXPECT_EQ(fault("G1 X1 E5"), "part.nc, line 3: E5, an axis that xyz does not have");
  EXPECT_EQ(fault("G1 X1 (open"), "part.nc, line 3: a bracket that is not closed on its line");
  EXPECT_EQ(fault("G2 X0 Y0 I5"),
            "part.nc, line 3: an arc from a place that is not known, a whole circle, a helix, or "
            "none at all");
  EXPECT_EQ(fault("G1 X1 F0"), "part.nc, line 3: a move without a feed (F)");
  EXPECT_EQ(fault_of("X1 Y1 Z1\n"), "part.nc, line 1: a move without G0, G1, G2 or G3");
  ReadSettings settings;
  settings.calls_without_motion = {"M101"};
  EXPECT_EQ(fault_of(start + "M101\n", settings), "");
}

}  // namespace
}  // namespace tool_path_programs
