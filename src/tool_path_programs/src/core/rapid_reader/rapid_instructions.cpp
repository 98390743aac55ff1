// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/rapid_instructions.h"

#include <map>

#include "scan_cell_common/errors/text.h"
#include "text/words.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

constexpr auto kJoint = MotionKind::kJoint;
constexpr auto kLinear = MotionKind::kLinear;
constexpr auto kCircular = MotionKind::kCircular;

// By name in lower case: the base system, then arc welding, gluing, painting, cutting.
const std::map<std::string, RapidMotion>& motions() {
  static const std::map<std::string, RapidMotion> all = {
      {"movej", {kJoint}},
      {"movel", {kLinear}},
      {"movec", {kCircular}},
      {"moveabsj", {kJoint, true}},
      {"movejdo", {kJoint, false, 2, true}},
      {"moveldo", {kLinear, false, 2, true}},
      {"movecdo", {kCircular, false, 2, true}},
      {"movejao", {kJoint, false, 2}},
      {"movelao", {kLinear, false, 2}},
      {"movecao", {kCircular, false, 2}},
      {"movejgo", {kJoint, false, 2}},
      {"movelgo", {kLinear, false, 2}},
      {"movecgo", {kCircular, false, 2}},
      {"triggj", {kJoint}},
      {"triggl", {kLinear}},
      {"triggc", {kCircular}},
      {"arcl", {kLinear}},
      {"arclstart", {kLinear}},
      {"arclend", {kLinear}},
      {"arcc", {kCircular}},
      {"arccstart", {kCircular}},
      {"arccend", {kCircular}},
      {"displ", {kLinear}},
      {"dispc", {kCircular}},
      {"paintl", {kLinear}},
      {"paintc", {kCircular}},
      {"cutl", {kLinear}},
      {"cutlstart", {kLinear}},
      {"cutlend", {kLinear}},
      {"cutc", {kCircular}},
      {"cutcstart", {kCircular}},
      {"cutcend", {kCircular}},
  };
  return all;
}

// Statements that neither move the robot nor change a pose.
constexpr std::string_view kMoveNothing =
    "accset actunit add arckill arcrefresh bitclear bitset break cirpathmode clear "
    "clearpath clkreset clkstart clkstop close confj confl connect cornerpathwarning "
    "corrclear deactunit decr eoffsoff eoffson eoffsset erasemodule errlog errwrite "
    "gripload idelete idisable ienable incr invertdo isignalai isignaldi isignaldo isleep "
    "itimer iwatch load mechunitload motionsup open pathacclim pathresol pdispoff pulsedo "
    "rewind save setao setgo singarea softact softdeact speedrefresh startload stop "
    "syncmoveoff syncmoveon systemstopaction texttabinstall tperase tpreadfk tpreadnum "
    "tpshow tpwrite triggcheckio triggequip triggint triggio triggrampao triggspeed "
    "tunereset tuneservo uimsgbox unload waitai waitao waitdi waitdo waitgi waitgo "
    "waitload waitrob waitsynctask waittestandset waittime waituntil worldacclim write "
    "writeanybin writebin writestrbin wzdisable wzenable wzfree retry trynext raise "
    "resetretrycount stopmove startmove testsigndefine";

}  // namespace

const RapidMotion* rapid_motion(const std::string& name) {
  const auto found = motions().find(lower_case(name));
  return found == motions().end() ? nullptr : &found->second;
}

const char* rapid_line_in_place_of(const std::string& name) {
  // Without those that begin or end a process, or trigger something at a distance from an end.
  static const std::map<std::string, const char*> lines = {
      {"movec", "MoveL"}, {"movecdo", "MoveLDO"}, {"movecao", "MoveLAO"}, {"movecgo", "MoveLGO"},
      {"arcc", "ArcL"},   {"dispc", "DispL"},     {"paintc", "PaintL"},   {"cutc", "CutL"}};
  const auto found = lines.find(lower_case(name));
  return found == lines.end() ? nullptr : found->second;
}

bool rapid_moves_nothing(const std::string& name) {
  static const Words words = words_of(kMoveNothing);
  return words.count(lower_case(name)) != 0;
}

const char* rapid_unresolvable(const std::string& name) {
  const std::string key = lower_case(name);
  if (key == "pdispon" || key == "pdispset") return "a displacement of all poses at run time";
  if (key.compare(0, 6, "search") == 0) return "a motion that ends where the robot finds something";
  if (key == "restopath" || key == "stepbwdpath") return "a motion that is not in the program";
  return nullptr;
}

}  // namespace tool_path_programs
