// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "deviation/adapted_part.h"
#include "deviation/deviation_files.h"
#include "deviation/statistics.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_path_stretcher/surface.h"

namespace {

struct Options {
  part_recipes::AdaptedFiles files;
  std::string places;
  std::string output;
  std::string summary;
  double tolerance = 0.0005;
};

void add_options(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  app.add_option("--reference", options.files.reference,
                 "reference part: a cloud (PLY, PCD, XYZ, CSV) or a mesh (STL, OBJ, PLY)")
      ->required();
  app.add_option("--reference-units", options.files.reference_units,
                 "units of the reference: m, mm or inch; default: those of the report")
      ->check(CLI::IsMember(scan_cell_common::length_units()));
  app.add_option("--object", options.files.object, "scanned object in metres")->required();
  app.add_option("--report", options.files.report, "what stretch wrote: JSON")->required();
  app.add_option("--tolerance", options.tolerance, "deviations within +- are good [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--places", options.places,
                 "places to follow: YAML list of name, position [m on the reference], radius [m]");
  outputs.add(app, "--output", options.output, "the object with a field deviation [m]: PLY or PCD")
      ->required();
  outputs.add(app, "--summary", options.summary, "statistics of the deviations: JSON")->required();
}

std::string millimetres(const std::optional<double>& metres) {
  using scan_cell_common::kMillimetres;
  return metres ? fmt::format("{:+.3f} mm", kMillimetres * *metres) : "not known";
}

void print(const part_recipes::DeviationSummary& summary) {
  const auto statistics = part_recipes::statistics_of(summary.deviations.values, summary.tolerance);
  constexpr double kPercent = 100;
  fmt::print("{} points, {} with no surface near; median {}, from {} to {}\n", statistics.points,
             statistics.unknown, millimetres(statistics.median), millimetres(statistics.min),
             millimetres(statistics.max));
  fmt::print("outside known from: {}; {:.1f} % of the reference not scanned\n",
             to_string(summary.outside), kPercent * summary.unscanned_share);
  for (const auto& place : summary.places)
    fmt::print("{}: {} ({} points)\n", place.place.name, millimetres(place.deviation),
               place.points);
}

void run(const Options& options) {
  using namespace part_recipes;
  scan_cell_common::check_cloud_output(options.output);
  scan_cell_common::check_output(options.summary, {".json"}, "write the summary as .json");
  DeviationSummary summary;
  summary.tolerance = options.tolerance;
  std::vector<Place> places;
  if (!options.places.empty()) places = load_places(options.places);
  const AdaptedPart part = load_adapted_part(options.files);
  if (!part.similarity) {
    throw scan_cell_common::Refused(options.files.report, "no pose of the part",
                                    "see its message; without a pose there are no deviations");
  }
  const Points object =
      tool_path_stretcher::to_points(scan_cell_common::load_cloud(options.files.object));
  const auto reference = ReferenceSurface::load(options.files.reference, part.metres_per_unit);
  summary.outside = reference->outside_known_by();
  summary.deviations = measure(*reference, *part.similarity, object, options.tolerance);
  summary.places = at_places(places, *part.similarity, object, summary.deviations.values);
  summary.unscanned_share = unscanned_share(
      scanned(reference->samples(), *part.similarity, object, summary.deviations.reach));
  save_fields(options.output, object, {"deviation"}, {summary.deviations.values});
  scan_cell_common::save_text(options.summary, to_json(summary));
  print(summary);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Signed distances of a scanned object from its reference.");
  Options options;
  scan_cell_common::Outputs outputs;
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "deviations", app, argc, argv,
      [&] {
        run(options);
        return 0;
      },
      scan_cell_common::kRefused, outputs);
}
