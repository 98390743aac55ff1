// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "growth.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>

#include "cases/case_list.h"
#include "stopwatch.h"
#include "tool_path_stretcher/stretcher.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using namespace tool_path_stretcher;

/// Peak memory of this process [GiB], without what its parent held before.
double peak_of_memory() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    double kibibytes = 0;
    if (std::sscanf(line.c_str(), "VmHWM: %lf kB", &kibibytes) == 1) return kibibytes / (1 << 20);
  }
  throw std::runtime_error("/proc/self/status does not say VmHWM");
}

/// [s] duration of each stage. A stage is reported while it runs and when it ends; `adapt` is
/// reported when it begins, and `done` when it has ended.
struct StageTimes {
  double align = 0;
  double refine = 0;
  double slide = 0;
  double place = 0;

  Progress watch() {
    return [this, last = wall_seconds()](const std::string& stage, double) mutable {
      const double now = wall_seconds();
      const double passed = now - last;
      last = now;
      if (stage == "align") align += passed;
      if (stage == "refine") refine += passed;
      if (stage == "adapt") slide += passed;
      if (stage == "done") place += passed;
      return true;
    };
  }
};

/// The output of run_growth() in a separate process of this program.
std::string run_in_child(std::size_t points, bool reduced) {
  const std::string command = "'" + fs::read_symlink("/proc/self/exe").string() + "' --growth-of " +
                              std::to_string(points) + (reduced ? " --reduced" : "");
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  if (!output) throw std::runtime_error(command + " did not start");
  std::string row;
  std::array<char, 512> text{};
  while (std::fgets(text.data(), text.size(), output.get()) != nullptr)
    row += text.data();
  return row;
}

}  // namespace

void run_growth(std::size_t points, bool reduced) {
  cases::Case each;
  each.reference = each.object = cases::curved_panel();
  each.deformation = cases::bend(0.006, 0.3);
  each.similarity = {1.1, cases::random_rotation(23), {0.31, -0.12, 0.2}};
  each.reference_scan.points = each.object_scan.points = points;
  each.object_scan.seed = 2;
  const cases::Scene scene = cases::scene_of(each);
  StretchParameters parameters;
  if (!reduced) parameters.leaf.setConstant(1e-5);
  Surface reference, object;
  const double surfaces = seconds_of([&] {
    reference = surface_from_cloud(scene.reference, parameters.leaf, "reference");
    object = surface_from_cloud(scene.object, parameters.leaf, "object");
  });
  StageTimes times;
  const StretchResult result = stretch(reference, object, scene.path, parameters, times.watch());
  std::printf("%.2f | %.2f | %.2f | %.2f | %.2f | %.2f ", peak_of_memory(), surfaces, times.align,
              times.refine, times.slide, times.place);
  if (!result.verdict.accepted()) {
    std::printf("| %s | | ", to_string(result.verdict.reason).c_str());
  } else {
    const cases::PathError error = cases::error_of(result.path, scene.truth, {});
    std::printf("| accepted | %.3f | %.3f ", 1e3 * error.normal, 1e3 * error.tangential);
  }
  std::printf("| %zu |\n", object.points.size());
}

namespace {

void print_table(bool reduced) {
  std::printf(
      "\n| points a cloud | s | s a million points | of 20,000's | peak GiB | s: surfaces | align "
      "| refine | slide | place | verdict | normal | tangential | points left |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  double first = 0;
  for (const std::size_t points : {20000, 100000, 300000, 1000000}) {
    const std::string row = run_in_child(points, reduced);
    double peak = 0;
    std::array<double, 5> stages{};
    if (std::sscanf(row.c_str(), "%lf | %lf | %lf | %lf | %lf | %lf", &peak, &stages[0], &stages[1],
                    &stages[2], &stages[3], &stages[4]) != 6) {
      throw std::runtime_error("the run with " + std::to_string(points) + " points said nothing");
    }
    const double whole = std::accumulate(stages.begin(), stages.end(), 0.0);
    const double each = 1e6 * whole / static_cast<double>(points);
    if (first == 0) first = each;
    std::printf("| %zu | %.2f | %.2f | %.2f | %s", points, whole, each, each / first, row.c_str());
    std::fflush(stdout);
  }
}

}  // namespace

void print_growth() {
  std::printf(
      "\n### Growth\n\nThe curved panel in any pose, x 1.1, bent by 6 mm; each size in a process "
      "of its own. Both clouds reduced on the default grid:\n");
  print_table(true);
  std::printf("\nNext to nothing reduced (a grid of 0.01 mm):\n");
  print_table(false);
}

}  // namespace bench
