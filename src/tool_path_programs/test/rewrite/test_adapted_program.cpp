// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Programs in all languages with an arc that is no circle on the part.
#include <gtest/gtest.h>

#include <functional>

#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/adapted_program.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;
using Map = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

constexpr double kRadius = 0.1;
constexpr double kTolerance = 1e-4;
constexpr double kTurn = 40;  // [degrees] of the tool about z, along the arc

/// A line to the arc's start at x 100 mm, an arc about z to y 100 mm, and a line from there. In
/// languages that ignore the via's orientation, it is not between those of start and end.
struct Example {
  std::string language;
  std::string file;
  std::string text;
  double turn_of_via;  // [degrees]; NaN: ignored
};

const std::string kFanucPosition = "]{\n   GP1:\n\tUF : 2, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 0',\n";

std::string fanuc_position(int number, const std::string& x, const std::string& y,
                           const std::string& r) {
  return "P[" + std::to_string(number) + kFanucPosition + "\tX = " + x + " mm,\tY = " + y +
         " mm,\tZ = 0.000 mm,\n\tW = 0.000 deg,\tP = 0.000 deg,\tR = " + r + " deg\n};\n";
}

const Example kExamples[] = {
    {"krl", "part.src",
     "DEF part ( )\r\n$VEL.CP=0.02\r\n$APO.CDIS=1\r\nLIN {X 100,Y 0,Z 0,A 0,B 0,C 0,E1 5}\r\n"
     "$OUT[3]=TRUE\r\n  CIRC {X 70.710678,Y 70.710678,Z 0,A 90,B 0,C 0}, "
     "{Y 100,X 0,A 40,E1 5} ; rim\r\n$OUT[3]=FALSE\r\n"
     "LIN {X -50,Y 100,Z 0,A 40,B 0,C 0}\r\nEND\r\n",
     NAN},
    {"rapid", "part.mod",
     "MODULE m\n"
     "CONST robtarget p1:=[[100,0,0],[1,0,0,0],[0,1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
     "CONST robtarget p2:=[[70.710678,70.710678,0],[0.70710678,0,0,0.70710678],[0,0,0,0],"
     "[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
     "CONST robtarget p3:=[[0,100,0],[0.93969262,0,0,0.34202014],[0,1,-1,0],"
     "[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
     "PROC main()\n  MoveL p1,v20,z1,tool0;\n  SetDO glue,1;\n"
     "  MoveCDO p2,p3,v20,fine,tool0,glue,0; ! rim\n"
     "  MoveL [[-50,100,0],[0.93969262,0,0,0.34202014],[0,1,0,0],"
     "[9E9,9E9,9E9,9E9,9E9,9E9]],v20,fine,tool0;\nENDPROC\nENDMODULE\n",
     NAN},
    {"pdl2", "part.pdl",
     "PROGRAM part PROG_ARM = 1\nVAR\n  p1 : POSITION\nBEGIN\n  $LIN_SPD := 0.02\n  $FLY_DIST := "
     "2\n"
     "  MOVE LINEAR TO POS(100, 0, 0, 0, 0, 0, 'S')\n  $DOUT[3] := ON\n"
     "  $MOVE_TYPE := CIRCULAR\n"
     "  MOVE TO POS(0, 100, 0, 40, 0, 0, 'S W') VIA POS(70.710678, 70.710678, 0, 30, 0, 0, ''),\n"
     "    WITH $LIN_SPD = 0.01,\n  ENDMOVE -- rim\n  $DOUT[3] := OFF\n"
     "  MOVE LINEAR TO POS(-50, 100, 0, 40, 0, 0, 'S')\nEND part\n",
     30},
    {"fanuc", "part.ls",
     "/PROG  PART\n/ATTR\n/MN\n   1:  UFRAME_NUM=2 ;\n   2:  UTOOL_NUM=1 ;\n"
     "   3:L P[1] 20mm/sec FINE    ;\n   4:  DO[3]=ON ;\n"
     "   5:C P[2]    \n    :  P[3] 20mm/sec FINE ACC80    ;\n   6:  DO[3]=OFF ;\n"
     "   7:L P[7] 20mm/sec FINE    ;\n/POS\n" +
         fanuc_position(1, "100.000", ".000", ".000") +
         fanuc_position(2, "70.710678", "70.710678", "30.000") +
         fanuc_position(3, ".000", "100.000", "40.000") +
         fanuc_position(7, "-50.000", "100.000", "40.000") + "/END\n",
     30},
    {"urscript", "part.script",
     "def part():\n  movel(p[0.1, 0, 0, 0, 0, 0], v=0.02)\n  set_digital_out(3, True)\n"
     "  movec(p[0.070710678, 0.070710678, 0, 0, 0, 1.5],  # via\n"
     "        pose_to=p[0, 0.1, 0, 0, 0, 0.6981317], v=0.02)\n  set_digital_out(3, False)\n"
     "  movel(p[-0.05, 0.1, 0, 0, 0, 0.6981317], v=0.02)\nend\n",
     NAN},
    {"gcode", "part.ngc",
     "G21 G90 G94\nG0 X100 Y0 Z0 A0 B0 C0\nM3 S1000\nG3 X0 Y100 C40 I-100 J0 F1200 (rim)\nM5\n"
     "G1 X-50\n",
     NAN},
};

Eigen::Vector3d of_arc(double degrees) {
  const double angle = degrees * M_PI / 180;
  return kRadius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
}

/// Bends out of the arc's plane: 0 at both ends and in the middle.
Eigen::Vector3d bent(const Eigen::Vector3d& place) {
  return {place.x(), place.y(), 1e-3 * std::sin(4 * std::atan2(place.y(), place.x()))};
}

class AnArc : public testing::TestWithParam<Example> {
 protected:
  const Language& language() const { return language_named(GetParam().language); }

  ProgramText read(const std::string& text) const {
    return language().read({{GetParam().file, text}}, {});
  }

  AdaptedProgram adapted(const ProgramText& text, const Map& map,
                         double tolerance = kTolerance) const {
    ProgramPathSettings settings;
    settings.turns_by_via = language().turns_by_via();
    const ProgramPath path = path_of(text, settings);
    tool_paths::ToolPath moved = path.path;
    for (auto& segment : moved.segments)
      for (auto& waypoint : segment.waypoints)
        waypoint.pose.translation() = map(waypoint.pose.translation());
    return adapted_program(language(), text, {}, path, moved, tolerance);
  }
};

/// The moves between the one that begins an arc and the one that ends it.
std::vector<Move> moves_along_arc(const Program& program) {
  std::vector<Move> moves;
  for (const Move* const move : moves_of(program))
    moves.push_back(*move);
  return moves;
}

double distance_to_line(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b) {
  const double share = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (point - a - share * (b - a)).norm();
}

double turn_of(const Move& move) {
  return std::atan2(move.pose.linear()(1, 0), move.pose.linear()(0, 0)) * 180 / M_PI;
}

TEST_P(AnArc, ThatIsNoCircleOnThePartBecomesLinesAlongIt) {
  const ProgramText text = read(GetParam().text);
  const AdaptedProgram result = adapted(text, bent);
  const ProgramText lines = read(result.files.at(0).text);
  const auto moves = moves_along_arc(lines.program);
  ASSERT_GT(moves.size(), 30u) << result.files[0].text;
  for (const Move& move : moves)
    EXPECT_NE(move.kind, MotionKind::kCircular);
  double farthest = 0;
  for (double degrees = 0; degrees <= 90; degrees += 0.1) {
    double nearest = 1;
    for (std::size_t i = 1; i + 1 < moves.size(); ++i)
      nearest =
          std::min(nearest, distance_to_line(bent(of_arc(degrees)), moves[i - 1].pose.translation(),
                                             moves[i].pose.translation()));
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, kTolerance);
  EXPECT_TRUE(moves[moves.size() - 2].pose.translation().isApprox(of_arc(90), 1e-6));
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find(GetParam().file + ", line "), std::string::npos);
  EXPECT_NE(result.notes[0].find(std::to_string(moves.size() - 2) + " lines"), std::string::npos)
      << result.notes[0];
}

TEST_P(AnArc, ThatBecameLinesTurnsTheToolAsItDid) {
  const auto moves =
      moves_along_arc(read(adapted(read(GetParam().text), bent).files[0].text).program);
  bool passes_turn_of_via = false;
  for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
    const double turn = turn_of(moves[i]);
    EXPECT_GT(turn, turn_of(moves[i - 1])) << i;
    EXPECT_LT(turn, kTurn + 1e-3);
    const double place =
        std::atan2(moves[i].pose.translation().y(), moves[i].pose.translation().x()) * 180 / M_PI;
    if (std::isnan(GetParam().turn_of_via)) {
      EXPECT_NEAR(turn, place * kTurn / 90, 0.01);
      continue;
    }
    passes_turn_of_via = passes_turn_of_via || std::abs(turn - GetParam().turn_of_via) < 0.01;
  }
  EXPECT_EQ(passes_turn_of_via, !std::isnan(GetParam().turn_of_via));
}

TEST_P(AnArc, ThatBecameLinesDoesTheRestOnceAndInItsPlace) {
  const ProgramText text = read(GetParam().text);
  const AdaptedProgram result = adapted(text, bent);
  const ProgramText lines = read(result.files[0].text);
  std::vector<std::string> outputs[2];
  std::size_t moves_since_on = 0;
  for (const Step& step : lines.program.steps) {
    if (std::holds_alternative<Move>(step) && outputs[1].size() == 1) ++moves_since_on;
    if (const auto* output = std::get_if<SetOutput>(&step)) outputs[1].push_back(output->output);
  }
  for (const Step& step : text.program.steps)
    if (const auto* output = std::get_if<SetOutput>(&step)) outputs[0].push_back(output->output);
  EXPECT_EQ(outputs[0], outputs[1]);
  EXPECT_EQ(moves_since_on, moves_of(lines.program).size() - 2) << "it goes off too early";
  const auto moves = moves_of(lines.program);
  const auto old = moves_of(text.program);
  for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
    EXPECT_DOUBLE_EQ(moves[i]->speed, old[1]->speed);
    const bool flies =
        moves[i]->zone > 0 || GetParam().language == "gcode" || i + 2 == moves.size();
    EXPECT_TRUE(flies) << "it stops at each of them";
  }
  EXPECT_EQ(moves[moves.size() - 2]->zone, old[1]->zone);
  const std::string& now = result.files[0].text;
  const std::size_t first = GetParam().text.find("rim"), again = now.find("rim");
  if (first != std::string::npos) {
    ASSERT_NE(again, std::string::npos);
    EXPECT_EQ(now.find("rim", again + 1), std::string::npos);
  }
}

TEST_P(AnArc, ThatStaysACircleStaysAnArc) {
  const ProgramText text = read(GetParam().text);
  const AdaptedProgram result = adapted(text, [](const Eigen::Vector3d& place) {
    return Eigen::Vector3d(1.01 * place + Eigen::Vector3d(0.01, 0.02, 0.003));
  });
  const ProgramText again = read(result.files[0].text);
  const auto moves = moves_of(again.program);
  if (language().moves_arcs()) {
    EXPECT_EQ(moves.size(), 3u);
    EXPECT_EQ(moves[1]->kind, MotionKind::kCircular);
    EXPECT_TRUE(result.notes.empty());
  } else {
    EXPECT_GT(moves.size(), 30u);
    EXPECT_EQ(result.notes.size(), 1u);
  }
}

TEST_P(AnArc, ThatIsAllowedToMissStaysAnArc) {
  if (!language().moves_arcs()) return;
  const AdaptedProgram result = adapted(read(GetParam().text), bent, 0.002);
  EXPECT_EQ(moves_of(read(result.files[0].text).program).size(), 3u);
}

TEST_P(AnArc, OnTheSamePartChangesNoByte) {
  const AdaptedProgram result =
      adapted(read(GetParam().text), [](const Eigen::Vector3d& place) { return place; });
  EXPECT_EQ(result.files[0].text, GetParam().text);
}

/// A program bent only where x and y are above 0.
AdaptedProgram bent_in_first_quarter(const Language& language, const std::string& name,
                                     const std::string& text) {
  const ProgramText read = language.read({{name, text}}, {});
  const ProgramPath path = path_of(read);
  tool_paths::ToolPath moved = path.path;
  for (auto& segment : moved.segments)
    for (auto& waypoint : segment.waypoints) {
      Eigen::Vector3d place = waypoint.pose.translation();
      if (place.x() > 1e-6 && place.y() > 1e-6) waypoint.pose.translation() = bent(place);
    }
  return adapted_program(language, read, {}, path, moved, kTolerance);
}

TEST(AdaptedProgram, SaysTheMotionOfGcodeAnewBehindAnArcThatBecameLines) {
  const std::string quarter = "G0 X100 Y0 Z0\nG3 X0 Y100 I-100 J0 F1200\n";
  const std::string rest = "X-100 Y0 I0 J-100\nX0 Y-100 I100 J0\n";
  const std::string now =
      bent_in_first_quarter(language_named("gcode"), "part.ngc", quarter + rest).files[0].text;
  const std::string end = "\nG1 X0 Y100 Z0.0000\nG3 " + rest;
  ASSERT_GT(now.size(), end.size());
  EXPECT_EQ(now.substr(now.size() - end.size()), end);
}

TEST(AdaptedProgram, LeavesTheExternalAxesOfAnEndWhoseOtherNumbersItCompletes) {
  const Example& krl = kExamples[0];
  const std::string now =
      bent_in_first_quarter(language_named("krl"), krl.file, krl.text).files[0].text;
  EXPECT_NE(now.find("{Y 100,X 0,A 40,E1 5,Z 0.0000,B"), std::string::npos) << now;
}

/// An example's arc with a piece of its text replaced.
std::string with(const std::string& language, const std::string& old, const std::string& other) {
  for (const Example& example : kExamples) {
    if (example.language != language) continue;
    std::string text = example.text;
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << language << ": " << old;
    return text.replace(at, old.size(), other);
  }
  return "";
}

/// Arcs that do more than move through their places: as lines they would do something else.
TEST(AdaptedProgram, RefusesArcsThatCannotBeSaidAsLines) {
  const std::string position = fanuc_position(3, ".000", "100.000", "40.000");
  const struct {
    std::string language, old, other;
  } cases[] = {
      {"krl", "  CIRC", "TRIGGER WHEN DISTANCE=1 DELAY=0 DO $OUT[3]=FALSE\r\n  CIRC"},
      {"krl", "  CIRC", "TRIGGER WHEN PATH=-10 DELAY=0 DO $OUT[GLUE]=FALSE\r\n  CIRC"},
      {"krl", "  CIRC", "$CIRC_TYPE=#PATH\r\n  CIRC"},
      {"krl", "E1 5} ; rim", "E1 90} ; rim"},
      {"rapid", "MoveCDO p2,p3,v20,fine,tool0,glue,0;", "DispC\\Off,p2,p3,v20,bead,fine,tool0;"},
      {"rapid", "MoveCDO p2,p3,v20,fine,tool0,glue,0;", "TriggC p2,p3,v20,gun,fine,tool0;"},
      {"rapid", "MoveCDO p2", "CirPathMode\\CirPointOri;\n  MoveCDO p2"},
      {"rapid", "[0,1,-1,0],[9E9", "[0,1,-1,0],[300"},
      {"pdl2", "WITH $LIN_SPD = 0.01", "WITH CONDITION[1]"},
      {"fanuc", "FINE ACC80", "FINE COORD"},
      {"fanuc", position, position.substr(0, position.size() - 4) + ",\n\tE1= 12.5 mm\n};\n"},
      {"urscript", "0.6981317], v=0.02)\n  set_digital_out(3, False)",
       "0.6981317], v=0.02, mode=1)\n  set_digital_out(3, False)"},
      {"urscript", "0.6981317], v=0.02)\n  set_digital_out(3, False)",
       "0.6981317], v=0.02, r=0.02)\n  set_digital_out(3, False)"},
      {"urscript", "p[0.1, 0, 0, 0, 0, 0], v=0.02)", "p[0.1, 0, 0, 0, 0, 0], v=0.02, r=0.01)"},
      {"gcode", "F1200", "F1200 M0"},
  };
  for (const auto& each : cases) {
    SCOPED_TRACE(each.language + ": " + each.other);
    const auto& language = language_named(each.language);
    const std::string name = "part" + language.extensions().front();
    try {
      const auto result =
          bent_in_first_quarter(language, name, with(each.language, each.old, each.other));
      ADD_FAILURE() << result.files[0].text;
    } catch (const UnusableInput& error) {
      EXPECT_NE(std::string(error.what()).find(name + ", line "), std::string::npos)
          << error.what();
    }
  }
}

TEST(AdaptedProgram, RefusesMoreThanHalfACircleAlongWhichTheToolTurns) {
  const std::string start = "G0 X100 Y0 Z0 A0 B0 C0\n", arc = "G3 X0 Y-100 I-100 J0 F1200";
  const auto& gcode = language_named("gcode");
  EXPECT_NO_THROW(bent_in_first_quarter(gcode, "part.ngc", start + arc + "\n"));
  EXPECT_THROW(bent_in_first_quarter(gcode, "part.ngc", start + arc + " C270\n"), UnusableInput);
}

INSTANTIATE_TEST_SUITE_P(OfEachLanguage, AnArc, testing::ValuesIn(kExamples),
                         [](const auto& info) { return info.param.language; });

}  // namespace
}  // namespace tool_path_programs
