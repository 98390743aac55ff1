// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>

#include "file_options.h"
#include "path_input.h"
#include "report.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using scan_cell_common::FileError;
using scan_cell_common::kRefused;
using scan_cell_common::kUnusable;
using scan_cell_common::Outputs;
using scan_cell_common::refuse_overwriting;
using scan_cell_common::remove_old;
using tool_path_stretcher::StretchParameters;
using tool_path_stretcher::StretchResult;

constexpr int kAccepted = 0;

struct Options {
  std::string reference;
  std::string object;
  std::string path;
  std::string output;
  std::string report;
  tool_path_stretcher::FileOptions files;
  tool_path_stretcher::ProgramOptions program;
  scan_cell_common::ParameterOptions typed;
  StretchParameters parameters;
};

void add_options(CLI::App& app, Options& options, Outputs& outputs) {
  app.add_option("--reference", options.reference,
                 "reference part: a cloud (PLY, PCD, XYZ, CSV) or a mesh (STL, OBJ, PLY)")
      ->required();
  app.add_option("--object", options.object, "scanned object: PLY, PCD, XYZ or CSV")->required();
  app.add_option("--path", options.path,
                 "tool path on the reference: CSV, YAML or a robot's program")
      ->required();
  outputs
      .add(app, "--output", options.output,
           "tool path on the object: CSV or YAML, or the same program with other poses")
      ->required();
  outputs.add(app, "--report", options.report, "report: JSON")->required();
  add_file_options(app, options.files);
  add_program_options(app, options.program);
  options.typed.add(app, options.parameters);
}

bool show_progress(const std::string& stage, double progress) {
  std::fprintf(stderr, "\r%3d %% %-16s", static_cast<int>(100 * progress), stage.c_str());
  if (progress >= 1) std::fputc('\n', stderr);
  std::fflush(stderr);
  return true;
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The state of a run.
struct Run {
  StretchResult result;
  tool_path_stretcher::RunRecord record;
  std::unique_ptr<tool_path_stretcher::PathInput> path;
};

/// Removes the path of an earlier run, which must not be taken for this one's.
void remove_old_path(const Options& options) {
  refuse_overwriting(options.output, {options.reference, options.object, options.path});
  remove_old(options.output);
}

void remove_old_report(const Options& options) {
  refuse_overwriting(options.report,
                     {options.reference, options.object, options.path, options.output});
  try {
    scan_cell_common::check_output(options.report, {".json"}, "write the report as .json");
    remove_old(options.report);
  } catch (const FileError&) {
    remove_old_path(options);
    throw;
  }
}

/// Checks the options before any file is read.
void check_options(Options& options) {
  tool_path_stretcher::PathInput::check_output(options.path, options.output);
  remove_old_path(options);
  options.typed.read(options.parameters);
}

void read_path(const Options& options, Run& run) {
  using namespace tool_path_stretcher;
  run.path = PathInput::load(options.path, options.files, options.program);
  if (options.parameters.resample_spacing > 0 && !run.path->may_be_resampled())
    throw scan_cell_common::InvalidParameter("--resample-spacing", "given for a program",
                                             "leave it out: a program keeps its moves");
  run.record.path = run.path->contents();
  run.record.path_file = record_of(options.path, run.record.path->units);
  std::cout << "path: " << to_string(*run.record.path) << std::endl;
}

tool_path_stretcher::Surface read_surface(const std::string& file, const std::string& units,
                                          const Options& options,
                                          std::optional<tool_path_stretcher::FileRecord>& record) {
  const double metres = scan_cell_common::metres_per(units);
  record = tool_path_stretcher::record_of(file, units);
  return tool_path_stretcher::load_surface(file, options.parameters.leaf, metres);
}

void adapt(Options& options, Run& run) {
  const Clock::time_point start = Clock::now();
  check_options(options);
  read_path(options, run);
  const auto reference = read_surface(options.reference, options.files.units_of_reference(),
                                      options, run.record.reference);
  const auto object =
      read_surface(options.object, options.files.units_of_object(), options, run.record.object);
  run.record.seconds_reading = seconds_since(start);
  const bool terminal = isatty(STDERR_FILENO) == 1;
  run.result = tool_path_stretcher::stretch(
      reference, object, run.path->path(), options.parameters,
      terminal ? tool_path_stretcher::Progress(show_progress) : nullptr);
}

StretchResult unusable(const std::string& message) {
  StretchResult result;
  result.verdict = {tool_path_stretcher::Reason::kUnusableInput, message, {}};
  return result;
}

void save_path(const Options& options, Run& run) {
  const Clock::time_point start = Clock::now();
  try {
    for (const std::string& note : run.path->save(options.output, run.result.path))
      std::cout << note << '\n';
    run.record.output = tool_path_stretcher::record_of(options.output, run.record.path->units);
  } catch (const scan_cell_common::Error& error) {
    run.result = unusable(error.what());
  }
  run.record.seconds_writing = seconds_since(start);
}

/// Writes the path before the report: a report must not accept a path that was not written.
void save(const Options& options, Run& run) {
  if (run.result.verdict.accepted()) save_path(options, run);
  try {
    tool_path_stretcher::save_report(options.report, run.result, run.record);
  } catch (const FileError&) {
    if (run.result.verdict.accepted()) remove_old(options.output);
    throw;
  }
}

/// Three digits are enough.
std::string three_digits(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

int tell(const Run& run) {
  const StretchResult& result = run.result;
  if (result.verdict.accepted()) {
    std::cout << "accepted: " << to_string(tool_path_stretcher::summary_of(result.quality))
              << "; scale " << result.similarity.scale << ", rms " << three_digits(1e3 * result.rms)
              << " mm; " << three_digits(total_seconds(result, run.record)) << " s (reading "
              << three_digits(run.record.seconds_reading) << ", adapting "
              << three_digits(result.seconds) << ", writing "
              << three_digits(run.record.seconds_writing) << ")\n";
    if (result.verdict.message != tool_path_stretcher::kAdapted)
      std::cout << result.verdict.message << '\n';
    return kAccepted;
  }
  std::cerr << "refused (" << to_string(result.verdict.reason) << "): " << result.verdict.message
            << '\n';
  const bool unusable_input = result.verdict.reason == tool_path_stretcher::Reason::kUnusableInput;
  return unusable_input ? kUnusable : kRefused;
}

/// @return the process's exit code
int run_and_report(Options& options) {
  remove_old_report(options);
  Run run;
  const Clock::time_point start = Clock::now();
  try {
    adapt(options, run);
  } catch (const scan_cell_common::Error& error) {
    run.record.seconds_reading = seconds_since(start);
    run.result = unusable(error.what());
  }
  save(options, run);
  return tell(run);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Adapts a tool path proven on a reference part to a scanned object.\n"
      "Exit code 0: accepted; 2: refused, the report says why; 1: unusable input.");
  Options options;
  // An error in the path's name goes into the report.
  Outputs outputs(Outputs::Clearing::kByTool);
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "stretch", app, argc, argv, [&] { return run_and_report(options); }, kUnusable, outputs);
}
