// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzzing/robot_program_targets.h"
#include "urscript/urscript.h"

namespace {

const char* const kScript =
    "def part():\n  # a comment\n  set_tcp(p[0, 0, 0.1, 0, 0, 0])\n"
    "  global table = p[0.4, 0, 0, 0, 0, 1.57]\n  global fast = 0.2\n"
    "  global home = [0, -1.57, 1.57, -1.57, -1.57, 0]\n"
    "  global P1_p=p[.433, -.4679, .5223, 1.5003, .5212, .53]\n"
    "  def weld(to, v=0.01):\n    movel(to, a=1.2, v=fast * 0.5, r=0.001)\n"
    "    set_standard_digital_out(1, True)\n  end\n"
    "  thread count():\n    while (True):\n      n = n + 1\n      sync()\n    end\n  end\n"
    "  run count()\n  if (get_digital_in(1) == True):\n    popup(\"x\", title=\"y\")\n  end\n"
    "  $ 1 \"Robot Program\"\n  while (True):\n    movej(home)\n"
    "    movej(get_inverse_kin(P1_p, qnear=home), a=1.39, v=1.04)\n"
    "    weld(p[0.5, 0.1, 0.2, 0, 3.1416, 0])\n"
    "    movec(pose_trans(table, p[0.1, 0.2, 0.3, 3.9, 1.6, 1.6]),\n"
    "          pose_trans(table, p[0.2, 0.2, 0.3, 0, 0, 0]), 1.2, 0.25, 0, 1)\n"
    "    movep(p[0.5, 0.1, 0.3, -2.22, 2.22, 0], 1.2, fast, 0.002)\n"
    "    set_digital_out(8, False)\n    sleep(0.1)\n  end\nend\n";

}  // namespace

scan_cell_common::FuzzTarget urscript_target() {
  return {
      "urscript",
      {kScript},
      {"def ",
       "end\n",
       "while ",
       "True",
       "if ",
       "(",
       ")",
       "[",
       "]",
       "p[",
       ",",
       ":",
       "=",
       "==",
       "\n",
       "\r\n",
       "#",
       "\"",
       "$ 1",
       "global ",
       "local ",
       "return",
       "break",
       "thread ",
       "movel(",
       "movej(",
       "movec(",
       "movep(",
       "set_tcp(",
       "pose_trans(",
       "d2r(",
       "get_inverse_kin(",
       "set_digital_out(",
       "-",
       "+",
       "*",
       "/",
       "1e9",
       "0",
       "home",
       "P1_p",
       "table",
       "weld(",
       "switch ",
       "case ",
       "."},
      [](const std::string& bytes) { check_robot_program(tool_path_programs::urscript(), bytes); }};
}
