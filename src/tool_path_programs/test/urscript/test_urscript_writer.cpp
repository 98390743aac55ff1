// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <clocale>

#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/read_back.h"
#include "urscript/urscript.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

Eigen::Isometry3d at(double x, double y, double z = 0) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// A line of moves 10 mm apart, the first by the joints; output 3 on at the second, off at the
/// last.
Program example(std::size_t moves = 4) {
  Program program;
  program.name = "ADAPTED";
  program.comments = {"part 7", "run 3"};
  program.frames = {{{"", at(0, 0, 0.1)}, {"", at(0.5, 0)}}};
  for (std::size_t i = 0; i < moves; ++i) {
    Move move;
    move.kind = i == 0 ? MotionKind::kJoint : MotionKind::kLinear;
    move.pose = at(0.01 * static_cast<double>(i), 0.1, -0.2);
    move.pose.rotate(Eigen::AngleAxisd(0.001 * static_cast<double>(i % 1000) + M_PI - 0.5,
                                       Eigen::Vector3d(0.6, 0.8, 0)));
    const bool stop = i < 2 || i + 1 == moves;
    move.zone = stop ? 0 : 0.002;
    program.steps.emplace_back(move);
    if (i == 1) program.steps.emplace_back(SetOutput{"3", true});
  }
  program.steps.emplace_back(SetOutput{"3", false});
  return program;
}

Move& move_of(Program& program, std::size_t step) {
  return std::get<Move>(program.steps.at(step));
}

std::string written(const Program& program, const WriteSettings& settings = {}) {
  return write_checked(urscript(), program, settings).files.at(0).text;
}

/// The refused thing and value.
std::string fault_after(const std::function<void(Program&)>& change) {
  Program program = example();
  change(program);
  try {
    written(program);
  } catch (const UnusableInput& error) {
    return error.thing() + ": " + error.value();
  }
  return "";
}

TEST(UrscriptWriter, WritesFramesCommentsMovesAndOutputs) {
  Program program = example(2);
  program.frames[0].user.name = "fixture";
  move_of(program, 0).pose = at(0.1, 0, 0.2);
  move_of(program, 1).pose = at(-0.1, 0, 0.25);
  move_of(program, 1).speed = 0.0125;
  program.steps.pop_back();
  EXPECT_EQ(
      written(program),
      "def ADAPTED():\n"
      "  # part 7\n"
      "  # run 3\n"
      "  global fixture = p[0.5000000, 0.0000000, 0.0000000, 0.0000000, 0.0000000, 0.0000000]\n"
      "  set_tcp(p[0.0000000, 0.0000000, 0.1000000, 0.0000000, 0.0000000, 0.0000000])\n"
      "  movej(pose_trans(fixture, p[0.1000000, 0.0000000, 0.2000000, 0.0000000, 0.0000000, "
      "0.0000000]), a=1.4, v=0.314159)\n"
      "  movel(pose_trans(fixture, p[-0.1000000, 0.0000000, 0.2500000, 0.0000000, 0.0000000, "
      "0.0000000]), a=1.2, v=0.0125)\n"
      "  set_standard_digital_out(3, True)\n"
      "end\n"
      "ADAPTED()\n");
}

TEST(UrscriptWriter, EverythingComesBack) {
  Program program = example(40);
  Move arc = move_of(program, 40);
  arc.kind = MotionKind::kCircular;
  arc.via = at(0.4, 0.11, -0.2);
  arc.pose = at(0.42, 0.1, -0.2);
  program.steps.emplace_back(arc);
  for (const char* output : {"0", "7", "configurable_5", "tool_1"})
    program.steps.emplace_back(SetOutput{output, true});
  move_of(program, 0).joints = JointAngles{0.1, -1.5, 1.5, -1.57, -1.57, 3};
  EXPECT_NO_THROW(written(program));
  const ProgramText read = urscript().read(urscript().write(program, {}).files, {});
  EXPECT_TRUE(read.program.frames.at(0).tool.pose->isApprox(at(0, 0, 0.1), 1e-9));
  EXPECT_TRUE(read.program.frames.at(0).user.pose->isApprox(at(0.5, 0), 1e-9));
  EXPECT_NEAR(std::get<Move>(read.program.steps[0]).joints->at(5), 3, 1e-9);
  EXPECT_EQ(read.program.name, "ADAPTED");
}

TEST(UrscriptWriter, LongProgramsAreSplitAndFollowed) {
  WriteSettings settings;
  settings.max_lines = 7;
  const Program program = example(1000);
  const WrittenProgram split = write_checked(urscript(), program, settings);
  std::size_t longest = 0;
  std::size_t lines = 0;
  for (std::size_t at = 0; at < split.files[0].text.size();) {
    const std::size_t end = split.files[0].text.find('\n', at);
    const std::string line = split.files[0].text.substr(at, end - at);
    at = end + 1;
    lines = line.find("def ") == std::string::npos ? lines + 1 : 0;
    if (line == "  end") longest = std::max(longest, lines - 1);
  }
  EXPECT_EQ(longest, 7u);
  // 144 of statements, 21 and 3 of calls
  EXPECT_EQ(split.notes.back(), "1003 statements in 168 functions of at most 7");
}

TEST(UrscriptWriter, CommasOfALocaleDoNotGetIn) {
  const std::string with_points = written(example());
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no such locale here";
  const std::string with_locale = written(example());
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(with_locale, with_points);
}

TEST(UrscriptWriter, WithoutFramesItSaysWhatIsLeftToTheController) {
  Program program = example();
  program.frames = {{{"torch", {}}, {"Plane_1", {}}}};
  const WrittenProgram split = write_checked(urscript(), program, {});
  EXPECT_EQ(split.files[0].text.find("set_tcp"), std::string::npos);
  EXPECT_NE(split.files[0].text.find("pose_trans(Plane_1, p["), std::string::npos);
  EXPECT_EQ(split.notes.at(0),
            "the tool's tip (TCP) is the one that is active on the controller: choose torch");
  EXPECT_EQ(split.notes.at(1),
            "Plane_1 is a variable of the controller: a feature of its installation that is "
            "variable");
}

TEST(UrscriptWriter, RefusesWhatItCannotSayAndNamesTheWaypoint) {
  EXPECT_EQ(fault_after([](Program& p) { move_of(p, 1).speed = 1e-7; }),
            "program ADAPTED, waypoint 2: speed 1e-07 m/s");
  EXPECT_EQ(fault_after([](Program& p) { move_of(p, 3).zone = 1e-7; }),
            "program ADAPTED, waypoint 3: zone 1e-07 m");
  EXPECT_EQ(fault_after([](Program& p) { move_of(p, 3).zone = 0.011; }),
            "program ADAPTED, waypoint 2 and 3: 10 mm apart with zones of 0 mm and 11 mm");
  EXPECT_EQ(fault_after([](Program& p) { move_of(p, 4).zone = 0.001; }),
            "program ADAPTED, waypoint 4: a zone where output 3 switches");
  EXPECT_EQ(fault_after([](Program& p) {
              p.steps.pop_back();
              move_of(p, 4).zone = 0.001;
            }),
            "program ADAPTED, waypoint 4: the last waypoint has a zone, but no move follows it");
  EXPECT_EQ(fault_after([](Program& p) {
              move_of(p, 3).pose.linear() = move_of(p, 1).pose.linear();
              move_of(p, 3).pose.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
            }),
            "program ADAPTED, waypoint 3: turned by 180.0 degrees from the one before");
  EXPECT_EQ(fault_after([](Program& p) {
              move_of(p, 0).kind = MotionKind::kCircular;
              move_of(p, 0).via = at(1, 1);
            }),
            "program ADAPTED, waypoint 1: an arc as the first move");
  EXPECT_EQ(fault_after([](Program& p) {
              p.steps.emplace_back(JointMove{{0, 0, 0, 0, 0, 0}});
            }),
            "program ADAPTED, waypoint 4: a move to angles of the axes");
  EXPECT_EQ(fault_after([](Program& p) {
              p.steps.emplace_back(SetOutput{"8", true});
            }),
            "output 8: not a digital output of the controller");
  EXPECT_NE(fault_after([](Program& p) { move_of(p, 1).pose.translation().x() = NAN; }), "");
}

TEST(UrscriptWriter, RefusesNamesAndSaysWhichWouldDo) {
  const auto cure_of = [](const std::string& name, bool of_frame) -> std::string {
    Program program = example();
    (of_frame ? program.frames[0].user.name : program.name) = name;
    try {
      written(program);
    } catch (const UnusableInput& error) {
      return error.cure();
    }
    return "";
  };
  EXPECT_EQ(cure_of("my part", false), "name it my_part, for example");
  EXPECT_EQ(cure_of("7up", false), "name it P_7up, for example");
  EXPECT_EQ(cure_of("while", true), "name it P_while, for example");
  EXPECT_EQ(cure_of("movel", true), "name it P_movel, for example");
  EXPECT_EQ(cure_of(std::string(200, 'x'), false),
            "name it " + std::string(64, 'x') + ", for example");
  EXPECT_EQ(cure_of("ADAPTED_1", true), "give one of them another name");
  EXPECT_EQ(cure_of("ADAPTED_frame", true), "");
}

TEST(UrscriptWriter, LargestZoneInTheCureWouldDo) {
  Program program = example(6);
  for (Step& step : program.steps)
    if (Move* move = std::get_if<Move>(&step)) move->zone *= 3;
  try {
    written(program);
    FAIL();
  } catch (const UnusableInput& error) {
    EXPECT_EQ(error.cure(), "give zones of at most 5.000 mm: zones of neighbours must not overlap");
  }
}

}  // namespace
}  // namespace tool_path_programs
