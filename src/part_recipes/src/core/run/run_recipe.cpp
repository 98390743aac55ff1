// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_recipe.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

#include "clock/utc_time.h"
#include "recipe/places_file.h"
#include "recipe/proof.h"
#include "run/figures.h"
#include "run/run_folder.h"
#include "run/tool_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/tools/tool_main.h"
#include "scan_cell_common/tools/version.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::kRefused;
using scan_cell_common::Refused;

std::string host_name() {
  std::array<char, 256> name{};  // HOST_NAME_MAX is 64
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// One run, from its inputs to the sealed folder. All tools work in the folder inputs, so that the
/// names in reports and logs hold wherever the run is copied to.
class Run {
 public:
  Run(const Recipe& recipe, const RunRequest& request, const StageBegins& begins)
      : recipe_(recipe), request_(request), begins_(begins), folder_(request.runs, recipe.name) {}

  EndedRun run() {
    describe();
    gather();
    record_.state = work();
    record_.ended = utc_now();
    folder_.write(record_);
    draw();
    end_if_stopped();
    EndedRun ended;
    ended.folder = folder_.seal();
    ended.record = std::move(record_);
    ended.warning = std::move(warning_);
    return ended;
  }

 private:
  fs::path inputs() const { return folder_.path() / "inputs"; }

  void describe() {
    record_.recipe_name = recipe_.name;
    record_.recipe_folder = fs::absolute(recipe_.folder).lexically_normal().string();
    const Hashes hashes = hashes_of(recipe_);
    record_.recipe_sha256 = hash_over(hashes);
    record_.started = utc_now();
    record_.host = host_name();
    record_.version = scan_cell_common::suite_version();
    record_.tolerance = recipe_.tolerance;
    record_.scan_units = request_.scan ? request_.scan_units : "m";
    record_.again_of = request_.again_of;
    record_.note = request_.note;
  }

  void gather() {
    for (const std::string& name : recipe_.files())
      folder_.add(recipe_.folder / name, "inputs/" + name);
    save_places((inputs() / kPlacesFile).string(), recipe_.places);
    if (request_.scan) folder_.add(*request_.scan, scan_name());
    if (request_.scan_record) folder_.add(*request_.scan_record, "scan.json");
  }

  /// A given cloud keeps its format.
  std::string scan_name() const {
    return "inputs/scan" + (request_.scan ? request_.scan->extension().string() : ".ply");
  }

  /// All stages up to the first that ends the run.
  RunState work() {
    if (!request_.prove) check_proof(recipe_, {});  // before anything moves
    if (!scan()) return RunState::kUnusable;
    if (!clean()) return RunState::kUnusable;
    const RunState state = stretch();
    if (record_.figures.scale) measure();
    if (state == RunState::kAccepted && !write_programs()) return RunState::kRefused;
    return state;
  }

  void warn(const std::string& warning) {
    if (!warning.empty()) warning_ += (warning_.empty() ? "" : "; ") + warning;
  }

  void end_if_stopped() const {
    if (request_.stop && request_.stop())
      throw Refused("run " + folder_.id(), "stopped", "run again");
  }

  /// @return the tool's exit code
  int call(const ToolCall& call) {
    if (begins_) begins_(call.stage);
    end_if_stopped();
    record_.stages.push_back(run_tool(call, inputs(), log_of(call.stage), request_.stop));
    end_if_stopped();
    return record_.stages.back().exit_code;
  }

  fs::path log_of(const std::string& stage) const {
    return folder_.path() / "stages" / (stage + ".log");
  }

  /// The run ends with what the stage said.
  bool failed(const std::string& stage) {
    record_.reason = stage + "_failed";
    record_.message = last_line(log_of(stage));
    return false;
  }

  bool scan() {
    if (!request_.scan) {
      if (recipe_.program.empty())
        throw Refused(recipe_.name, "no scan program", "name one in recipe.yaml, or give a scan");
      const int code =
          call({"scan",
                "scan_cell",
                {"scan", "--program", recipe_.program, "--output", "scan.ply", "--report",
                 "../scan.json", "--timeout", fmt::format("{}", request_.timeout)}});
      if (code != 0) return failed("scan");
    }
    if (fs::exists(folder_.path() / "scan.json")) read_scan(folder_.path() / "scan.json", record_);
    if (!request_.prove) warn(check_proof(recipe_, record_.calibration));
    return true;
  }

  bool clean() {
    ToolCall cleaning{
        "clean",
        "cloud_preprocess",
        {"clean_cloud", "--input", fs::path(scan_name()).filename().string(), "--output",
         "../object.ply", "--units", record_.scan_units, "--output-units", "m"}};
    if (!recipe_.cleaning.empty())
      cleaning.command.insert(cleaning.command.end(), {"--config", recipe_.cleaning});
    return call(cleaning) == 0 || failed("clean");
  }

  RunState stretch() {
    ToolCall adapting{"stretch",
                      "tool_path_stretcher",
                      {"stretch", "--reference", recipe_.reference.file, "--reference-units",
                       recipe_.reference.units, "--object", "../object.ply", "--object-units", "m",
                       "--path", recipe_.path.file, "--path-units", recipe_.path.units, "--output",
                       adapted(), "--report", "../report.json"}};
    add_options(adapting, recipe_.path.options);
    add_options(adapting, recipe_.stretch);
    const int code = call(adapting);
    const fs::path report = folder_.path() / "report.json";
    if (!fs::exists(report)) {
      failed("stretch");
      return RunState::kUnusable;
    }
    take_times_out(report);
    if (fs::exists(folder_.path() / "scan.json"))
      complete_report(report, folder_.path() / "scan.json");
    read_report(report, record_);
    if (code == 0) return RunState::kAccepted;
    return code == kRefused ? RunState::kRefused : RunState::kUnusable;
  }

  /// In the path's own form.
  std::string adapted() const {
    return "../adapted_path" + fs::path(recipe_.path.file).extension().string();
  }

  void measure() {
    const int code =
        call({"deviations",
              "part_recipes",
              {"deviations", "--reference", recipe_.reference.file, "--reference-units",
               recipe_.reference.units, "--object", "../object.ply", "--report", "../report.json",
               "--tolerance", fmt::format("{}", recipe_.tolerance), "--places", kPlacesFile,
               "--output", "../deviation.ply", "--summary", "../deviation.json"}});
    if (code == 0) {
      read_deviations(folder_.path() / "deviation.json", record_);
    } else {
      warn("no deviations: " + last_line(log_of("deviations")));
    }
  }

  bool write_programs() {
    for (const RobotProgram& program : recipe_.programs) {
      const fs::path file = fs::path("..") / "programs" / program.file;
      fs::create_directories(inputs() / file.parent_path());
      ToolCall exporting{"export_" + fs::path(program.file).filename().string(),
                         "tool_path_programs",
                         {"export_path", "--path", adapted(), "--units", recipe_.path.units,
                          "--report", "../report.json", "--output", file.string()}};
      add_options(exporting, recipe_.path.options);
      add_options(exporting, program.options);
      if (call(exporting) != 0) return failed(exporting.stage);
    }
    return true;
  }

  /// A run without its page is a run.
  void draw() {
    if (begins_) begins_("report");
    const fs::path log = folder_.path() / "stages" / "report.log";
    try {
      const auto page =
          run_tool({"report", "part_recipes", {"report_page.py", folder_.path().string()}},
                   inputs(), log, request_.stop);
      if (page.exit_code != 0) warn("no page: " + last_line(log));
    } catch (const scan_cell_common::FileError& error) {
      warn(std::string("no page: ") + error.what());
    }
    fs::remove(log);  // it comes after run.json, which has the hash of every other file
  }

  const Recipe& recipe_;
  const RunRequest& request_;
  const StageBegins& begins_;
  RunFolder folder_;
  RunRecord record_;
  std::string warning_;
};

}  // namespace

EndedRun run_recipe(const Recipe& recipe, const RunRequest& request, const StageBegins& begins) {
  return Run(recipe, request, begins).run();
}

}  // namespace part_recipes
