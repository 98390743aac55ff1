// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <vector>

#include "cases/draws.h"
#include "scan_cell_common/tools/tool_main.h"
#include "stopwatch.h"

namespace {

using tool_path_stretcher::Reason;

using bench::seconds_of;

struct Draws {
  unsigned count = 20;  // of each kind
  unsigned first = 0;   // number of the first one
  std::string kind;     // a word in the kind's name; empty: all
  bool other_shapes = false;
};

struct Kind {
  const char* name;
  cases::Draw draw;
  double noise;  // [m]
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"symmetric, no noise", cases::Draw::kSymmetric, 0},
      {"symmetric, 0.1 mm noise", cases::Draw::kSymmetric, 1e-4},
      {"with a hole that tells, no noise", cases::Draw::kDistinguishable, 0},
      {"with a hole that tells, 0.1 mm noise", cases::Draw::kDistinguishable, 1e-4},
      {"mirrored, no noise", cases::Draw::kMirrored, 0},
      {"mirrored, 0.1 mm noise", cases::Draw::kMirrored, 1e-4},
      {"with a mirror plane, no noise", cases::Draw::kMirrorSymmetric, 0},
      {"with a mirror plane, 0.1 mm noise", cases::Draw::kMirrorSymmetric, 1e-4}};
  return all;
}

struct Counts {
  unsigned right = 0;
  unsigned accepted = 0;
  unsigned refused = 0;
  unsigned far_off = 0;
  double seconds = 0;
};

void add(const cases::DrawnPart& part, unsigned seed, Counts& counts) {
  constexpr double kFar = 0.001;  // [m]
  tool_path_stretcher::StretchResult result;
  counts.seconds += seconds_of([&] { result = cases::run(part); });
  const Reason reason = result.verdict.reason;
  const bool accepted = reason == Reason::kAccepted;
  const double off = accepted ? cases::farthest_off(part, result.path) : 0;
  ++(accepted ? counts.accepted : counts.refused);
  counts.far_off += off > kFar;
  counts.right += reason == part.expected && off <= kFar;
  if (reason == part.expected && off <= kFar) return;
  std::printf("- %s, draw %u: %s, should be %s, %.2f mm off %s\n", part.name.c_str(), seed,
              to_string(reason).c_str(), to_string(part.expected).c_str(), 1e3 * off,
              result.verdict.message.c_str());
  std::fflush(stdout);
}

/// Prints the verdicts on random parts, kind by kind, and each wrong one.
void print_draws(const Draws& draws) {
  const cases::Shapes shapes = draws.other_shapes ? cases::Shapes::kOthers : cases::Shapes::kKnown;
  std::printf("\n### Parts drawn at random\n\n");
  std::vector<std::pair<const Kind*, Counts>> table;
  for (const Kind& kind : kinds()) {
    if (std::string(kind.name).find(draws.kind) == std::string::npos) continue;
    table.push_back({&kind, {}});
    for (unsigned i = draws.first; i < draws.first + draws.count; ++i)
      add(cases::draw(kind.draw, shapes, kind.noise, i), i, table.back().second);
  }
  std::printf(
      "\n| parts | right | accepted | refused | accepted, over 1 mm off | s each |\n"
      "|---|---|---|---|---|---|\n");
  for (const auto& [kind, counts] : table) {
    std::printf("| %s | %u of %u | %u | %u | %u | %.2f |\n", kind->name, counts.right, draws.count,
                counts.accepted, counts.refused, counts.far_off, counts.seconds / draws.count);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Verdicts on parts drawn at random: symmetric, with a hole that tells, mirrored.");
  Draws draws;
  app.add_option("--count", draws.count, "number of parts of each kind");
  app.add_option("--first", draws.first, "number of the first draw");
  app.add_option("--kind", draws.kind, "only the kinds whose name contains this");
  app.add_flag("--other-shapes", draws.other_shapes,
               "draw shapes that were not used in development");
  return scan_cell_common::tool_main("bench_drawn_parts", app, argc, argv, [&] {
    print_draws(draws);
    return 0;
  });
}
