// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/program_path.h"
#include "urscript/urscript.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

ProgramText read(const std::string& text, const ReadSettings& settings = {}) {
  return urscript().read({{"part.script", text}}, settings);
}

/// "part.script, line 3: value"
std::string fault_of(const std::string& text, const ReadSettings& settings = {}) {
  try {
    read(text, settings);
  } catch (const UnusableInput& error) {
    return error.thing() + ": " + error.value();
  }
  return "";
}

std::string fault_in_program(const std::string& statement) {
  return fault_of("def part():\n" + statement + "\nend\n");
}

const Move& move_of(const ProgramText& text, std::size_t step) {
  return std::get<Move>(text.program.steps.at(step));
}

// As the pendant saves its program tree: waypoints as variables, labels, an endless loop, a thread
// that counts.
const char* const kSavedByThePendant =
    "def Rim():\n"
    "  global _hidden_verificationVariable=0\n"
    "  step_count_1 = 0.0\n"
    "  thread Step_Counter_Thread_1():\n"
    "    while (True):\n"
    "      step_count_1 = step_count_1 + 1.0\n"
    "      sync()\n"
    "    end\n"
    "  end\n"
    "  run Step_Counter_Thread_1()\n"
    "  set_standard_analog_input_domain(0, 1)\n"
    "  set_tcp(p[0.0,0.0,0.12,0.0,0.0,0.0])\n"
    "  set_payload(1.5)\n"
    "  set_gravity([0.0, 0.0, 9.82])\n"
    "  global Waypoint_1_p=p[.433025361705, -.467959205379, .522310714714, 1.5, .52, .53]\n"
    "  global Waypoint_1_q=[1.99, -1.66, 1.93, -0.27, 1.32, 0.003]\n"
    "  global Plane_1=p[0.4, 0.1, 0.02, 0.0, 0.0, 0.5]\n"
    "  while (True):\n"
    "    $ 1 \"Robot Program\"\n"
    "    $ 2 \"MoveJ\"\n"
    "    movej(get_inverse_kin(Waypoint_1_p, qnear=Waypoint_1_q), a=1.396, v=1.0471975511965976)\n"
    "    $ 4 \"MoveL\"\n"
    "    movel(pose_trans(Plane_1, p[.1, .2, .03, .0, 3.141592653589793, .0]), a=1.2, v=0.25, "
    "r=0.005)\n"
    "    if (get_standard_digital_in(0) == False):\n"
    "      popup(\"No part\", title=\"Stop\", blocking=True)\n"
    "      halt\n"
    "    end\n"
    "    sleep(0.5)\n"
    "    set_standard_digital_out(2, True)\n"
    "  end\n"
    "end\n";

TEST(UrscriptReader, ReadsWhatThePendantSaves) {
  const ProgramText text = read(kSavedByThePendant);
  EXPECT_EQ(text.program.name, "Rim");
  ASSERT_EQ(text.program.steps.size(), 3u);
  EXPECT_EQ(move_of(text, 0).kind, MotionKind::kJoint);
  EXPECT_NEAR(move_of(text, 0).joint_speed, 1 / 3.0, 1e-12);
  EXPECT_EQ(move_of(text, 0).joints->at(2), 1.93);
  EXPECT_EQ(text.poses[0].place.line, 15u);
  EXPECT_EQ(text.steps[0].place.line, 21u);
  EXPECT_NEAR(text.poses[0].pose.translation().y(), -0.467959205379, 1e-15);
  const Move& line = move_of(text, 1);
  EXPECT_EQ(line.kind, MotionKind::kLinear);
  EXPECT_EQ(line.zone, 0.005);
  EXPECT_EQ(line.speed, 0.25);
  EXPECT_EQ(text.program.frames[line.frames].user.name, "Plane_1");
  EXPECT_NEAR(text.program.frames[line.frames].user.pose->translation().x(), 0.4, 1e-15);
  EXPECT_NEAR(text.program.frames[line.frames].tool.pose->translation().z(), 0.12, 1e-15);
  EXPECT_TRUE(line.pose.linear().col(2).isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[2]).output, "2");
}

// As written by post processors: speeds as variables, positional arguments, subprograms, a call at
// the end.
TEST(UrscriptReader, ReadsWhatPostProcessorsWrite) {
  const ProgramText text = read(
      "def Prog():\n"
      "  global speed_ms    = 0.250\n"
      "  global speed_rads  = 0.750\n"
      "  global accel_mss   = 1.200\n"
      "  global accel_radss = 1.200\n"
      "  global blend_radius_m = 0.001\n"
      "  # Subprogram Arc\n"
      "  def Arc():\n"
      "    movec(p[0.52, 0.1, 0.2, 0, 3, 0],p[0.5, 0.2, 0.2, 0, 3, 0],accel_mss,speed_ms,0)\n"
      "  end\n"
      "  movej([-1.6, -1.2, 1.9, -2.2, -1.57, 0.1],accel_radss,speed_rads,0,0)\n"
      "  speed_ms    = 0.010\n"
      "  movel(p[0.5, 0.0, 0.2, 0, 3, 0],accel_mss,speed_ms,0,blend_radius_m)\n"
      "  Arc()\n"
      "  set_digital_out(9, True)\n"
      "end\n"
      "\n"
      "Prog()\n");
  ASSERT_EQ(text.program.steps.size(), 4u);
  EXPECT_EQ(std::get<JointMove>(text.program.steps[0]).joints.at(3), -2.2);
  EXPECT_EQ(move_of(text, 1).speed, 0.01);
  EXPECT_EQ(move_of(text, 1).zone, 0.001);
  EXPECT_EQ(move_of(text, 2).kind, MotionKind::kCircular);
  EXPECT_EQ(text.steps[2].place.line, 9u);
  EXPECT_EQ(*text.steps[2].via, 1u);
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[3]).output, "tool_1");
  EXPECT_FALSE(path_of(text).path.segments.empty());
}

TEST(UrscriptReader, FollowsCallsWithTheirArguments) {
  const ProgramText text = read(
      "def weld(to, speed=0.01):\n  movel(to, v=speed)\nend\n"
      "start = p[0, 0, 0, 0, 0, 0]\n"
      "weld(start, 0.02)\nweld(p[1, 0, 0, 0, 0, 0], speed = 0.5 * (0.1 - 0.04))\n");
  ASSERT_EQ(text.poses.size(), 2u);
  EXPECT_EQ(text.poses[0].place.line, 4u);
  EXPECT_EQ(move_of(text, 0).speed, 0.02);
  EXPECT_NEAR(move_of(text, 1).speed, 0.03, 1e-15);
}

TEST(UrscriptReader, RoutinesInOtherFilesAreFollowed) {
  const SourceFile main{"main.script", "def main():\n  rim()\nend\n"};
  const SourceFile rim{"rim.script", "def rim():\n  movel(p[0, 0, 0, 0, 0, 0])\nend\n"};
  const ProgramText text = urscript().read({main, rim}, {});
  ASSERT_EQ(text.poses.size(), 1u);
  EXPECT_EQ(text.poses[0].place.file, 1u);
  EXPECT_EQ(text.program.name, "main");
}

TEST(UrscriptReader, AVariableThatIsUsedTwiceIsOnePose) {
  const ProgramText text =
      read("a = p[0, 0, 0, 0, 0, 0]\nmovel(a)\nmovel(p[1, 0, 0, 0, 0, 0])\nmovel(a)\n");
  EXPECT_EQ(text.poses.size(), 2u);
  EXPECT_EQ(*text.steps[2].pose, 0u);
}

TEST(UrscriptReader, FramesOutsideTheFilesComeFromTheSettings) {
  const std::string script = "movel(pose_trans(Table, p[0, 0, 0, 0, 0, 0]))\n";
  EXPECT_FALSE(read(script).program.frames.at(0).user.pose);
  ReadSettings settings;
  settings.frames["Table"] = Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3));
  EXPECT_EQ(read(script, settings).program.frames.at(0).user.pose->translation().z(), 3);
}

TEST(UrscriptReader, CallsWithoutMotionMustBeNamed) {
  const std::string script = "movel(p[0, 0, 0, 0, 0, 0])\nrq_close_and_wait()\n";
  EXPECT_EQ(fault_of(script),
            "part.script, line 2: calls rq_close_and_wait, which is not in the files");
  ReadSettings settings;
  settings.calls_without_motion = {"rq_close_and_wait"};
  EXPECT_EQ(fault_of(script, settings), "");
}

TEST(UrscriptReader, RefusesPositionsThatAreComputed) {
  for (const char* target :
       {"pose_add(a, p[0, 0, 0.1, 0, 0, 0])", "get_actual_tcp_pose()", "b", "p[x, 0, 0, 0, 0, 0]",
        "pose_trans(get_target_tcp_pose(), p[0, 0, 0.1, 0, 0, 0])"})
    EXPECT_NE(fault_in_program("a = p[0, 0, 0, 0, 0, 0]\nb = pose_inv(a)\nx = get_flag(1)\nmovel(" +
                               std::string(target) + ")")
                  .find("part.script, line 5: "),
              std::string::npos)
        << target;
  EXPECT_EQ(fault_in_program("a = p[0, 0, 0, 0, 0, 0]\na[2] = 0.1\nmovel(a)"),
            "part.script, line 4: a is computed");
  EXPECT_EQ(fault_in_program("movel(Waypoint_9)"),
            "part.script, line 2: Waypoint_9 is not in the files");
}

TEST(UrscriptReader, VariablesThatThreadsOrConditionsSetAreComputed) {
  EXPECT_EQ(
      fault_in_program("a = p[0, 0, 0, 0, 0, 0]\nthread t():\n  a = get_target_tcp_pose()\nend\n"
                       "movel(a)"),
      "part.script, line 6: a is computed");
  EXPECT_EQ(fault_in_program("a = p[0, 0, 0, 0, 0, 0]\nif get_flag(0):\n  a = p[1, 0, 0, 0, 0, 0]\n"
                             "end\nmovel(a)"),
            "part.script, line 6: a is computed");
  EXPECT_EQ(
      fault_in_program("global a = p[0, 0, 0, 0, 0, 0]\ndef f():\n  a = get_target_tcp_pose()\n"
                       "  return 1\nend\nb = f()\nmovel(a)"),
      "part.script, line 8: a is computed");
}

TEST(UrscriptReader, RefusesMotionsThatAreKnownAtRunTimeOnly) {
  const std::string move = "\nmovel(p[0, 0, 0, 0, 0, 0])\nend";
  EXPECT_EQ(fault_in_program("if get_flag(1):" + move),
            "part.script, line 2: a motion or a tool frame within if");
  EXPECT_EQ(fault_in_program("while i < 3:" + move),
            "part.script, line 2: a motion or a tool frame within while");
  EXPECT_EQ(fault_in_program("def f():" + move + "\nif get_flag(1):\nf()\nend"),
            "part.script, line 5: a motion or a tool frame within if");
  EXPECT_EQ(fault_in_program("thread f():" + move + "\nrun f()"),
            "part.script, line 5: a motion within another statement");
  EXPECT_EQ(fault_in_program("def f():" + move + "\nx = f()"),
            "part.script, line 5: a motion within another statement");
  EXPECT_EQ(fault_in_program("if get_flag(1):\nreturn 0\nend\nmovel(p[0, 0, 0, 0, 0, 0])"),
            "part.script, line 3: return within if");
  EXPECT_EQ(fault_in_program("speedl([0, 0, 0.1, 0, 0, 0], 0.5, 1)"),
            "part.script, line 2: speedl does not move to a pose");
  EXPECT_EQ(fault_in_program("movel(p[0, 0, 0, 0, 0, 0], t=2)"),
            "part.script, line 2: a time for the way instead of a speed");
  EXPECT_EQ(fault_in_program("movel(p[0, 0, 0, 0, 0, 0], v=speed)"),
            "part.script, line 2: speed that only the controller knows");
  EXPECT_EQ(fault_in_program("set_tcp(pose_add(tool, shift))"),
            "part.script, line 2: the tool frame is computed");
}

TEST(UrscriptReader, ALoopWithoutEndIsReadOnceAndNothingBehindIt) {
  const ProgramText text =
      read("while True:\n  movel(p[0, 0, 0, 0, 0, 0])\nend\nmovel(p[1, 0, 0, 0, 0, 0])\n");
  EXPECT_EQ(text.program.steps.size(), 1u);
}

TEST(UrscriptReader, StandsCirclesDepthAndHugeCallTrees) {
  EXPECT_EQ(
      fault_of("def f():\n  g()\n  movel(p[0, 0, 0, 0, 0, 0])\nend\ndef g():\n  f()\nend\nf()\n"),
      "part.script, line 6: f calls itself");
  std::string brackets = "x = ";
  std::string loops;
  for (int i = 0; i < 100000; ++i) {
    brackets += "(";
    loops += "while True:\n";
  }
  EXPECT_NE(fault_of(brackets), "");
  loops += "movel(p[0, 0, 0, 0, 0, 0])\n";
  for (int i = 0; i < 100000; ++i)
    loops += "end\n";
  EXPECT_NE(fault_of(loops).find("calls or loops nested too deeply"), std::string::npos);
  std::string doubling = "def f0():\n  set_digital_out(1, True)\nend\n";
  for (int i = 1; i < 60; ++i) {
    const std::string call = "  f" + std::to_string(i - 1) + "()\n";
    doubling += "def f" + std::to_string(i) + "():\n" + call + call + "end\n";
  }
  EXPECT_NE(fault_of(doubling + "f59()\n").find("never seem to end"), std::string::npos);
}

TEST(UrscriptReader, SaysWhereATextIsNone) {
  EXPECT_EQ(fault_of("def part():\n  movel(p[0, 0, 0, 0, 0, 0])\n"),
            "part.script, line 1: def without an end");
  EXPECT_EQ(fault_of("movel(p[0, 0, 0, 0, 0])\n"), "part.script, line 1: a pose of 5 numbers");
  EXPECT_EQ(fault_of("movel(p[512, 0, 9000, 0, 0, 0])\n"),
            "part.script, line 1: a pose with numbers that are too large");
  EXPECT_EQ(fault_of("end\n"), "part.script, line 1: an end without a block");
}

}  // namespace
}  // namespace tool_path_programs
