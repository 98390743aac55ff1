// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_recipe.h"

#include <unistd.h>

#include <array>

#include "clock/utc_time.h"
#include "recipe/places_file.h"
#include "recipe/proof.h"
#include "run/calls/stage_calls.h"
#include "run/report/cleaned_away.h"
#include "run/report/figures.h"
#include "run/run_folder.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/sha256.h"
#include "scan_cell_common/tools/tool_main.h"
#include "scan_cell_common/tools/version.h"
#include "tool_path_stretcher/verdict.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

const std::string kScannerInput = std::string("inputs/") + kScannerModel;

using scan_cell_common::kRefused;
using scan_cell_common::Refused;

std::string host_name() {
  std::array<char, 256> name{};  // HOST_NAME_MAX is 64
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// One run, from its inputs to the sealed folder.
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
    ended_.folder = folder_.seal();
    return std::move(ended_);
  }

 private:
  fs::path inputs() const { return folder_.path() / "inputs"; }

  void describe() {
    record_.recipe_name = recipe_.name;
    record_.recipe_folder = request_.recipe_folder.empty()
                                ? fs::absolute(recipe_.folder).lexically_normal().string()
                                : request_.recipe_folder;
    hashes_ = hashes_of(recipe_);
    record_.recipe_sha256 = hash_over(hashes_);
    record_.started = utc_now();
    record_.host = host_name();
    record_.version = scan_cell_common::suite_version();
    record_.tolerance = recipe_.tolerance;
    record_.scan_units = request_.scan ? request_.scan_units : "m";
    record_.again_of = request_.again_of;
    record_.path_edits = request_.path_edits.size();
    record_.note = request_.note;
  }

  void gather() {
    for (const std::string& name : recipe_.files())
      folder_.add(recipe_.folder / name, "inputs/" + name);
    save_places((inputs() / kPlacesFile).string(), recipe_.places);
    if (request_.scan) folder_.add(*request_.scan, "inputs/" + scan_name());
    if (!request_.path_edits.empty())
      scan_cell_common::save_text((inputs() / kPathEdits).string(), to_yaml(request_.path_edits));
    if (request_.scan_record) folder_.add(*request_.scan_record, "scan.json");
    if (request_.scan_bag) folder_.add(*request_.scan_bag, "scan.bag");
    if (request_.scanner) folder_.add(*request_.scanner, kScannerInput);
  }

  /// Name of the scan in inputs; a given cloud keeps its format.
  std::string scan_name() const {
    return "scan" + (request_.scan ? request_.scan->extension().string() : ".ply");
  }

  /// All stages up to the first that ends the run.
  RunState work() {
    if (!request_.prove) {  // before anything moves
      proof_ = load_proof(recipe_);
      check_unchanged(recipe_, *proof_, hashes_);
    }
    if (!scan()) return RunState::kUnusable;
    if (!clean()) return RunState::kUnusable;
    const RunState state = stretch();
    if (record_.figures.scale) {
      look();
      measure();
    }
    if (state == RunState::kAccepted && !write_programs()) return RunState::kRefused;
    return state;
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

  /// Ends the run with what the stage said.
  bool failed(const std::string& stage) {
    record_.reason = stage + "_failed";
    record_.message = last_line(log_of(stage));
    return false;
  }

  /// The cell's record of the scan; none: the cloud was given without it.
  std::optional<fs::path> scan_record() const {
    const fs::path file = folder_.path() / "scan.json";
    return fs::exists(file) ? std::optional(file) : std::nullopt;
  }

  bool scan() {
    bool scanned = true;
    if (!request_.scan) {
      if (recipe_.program.empty())
        throw Refused(recipe_.name, "no scan program", "name one in recipe.yaml, or give a scan");
      const Hashes calibration = proof_ ? proof_->calibration : Hashes();
      scanned = call(scan_call(recipe_, calibration, request_.bag, request_.timeout)) == 0;
    }
    if (const auto told = scan_record()) read_scan(*told, record_);
    if (proof_) ended_.warn(check_calibration(recipe_, *proof_, record_.calibration));
    return scanned || failed("scan");
  }

  bool clean() {
    return call(clean_call(recipe_, scan_name(), record_.scan_units)) == 0 || failed("clean");
  }

  /// Folder for the results of stretch, seen from inputs.
  std::string results() const {
    return request_.path_edits.empty() ? ".." : std::string("../") + kUnedited;
  }

  RunState stretch() {
    if (request_.path_edits.empty()) return stretch_into(folder_.path());
    const fs::path unedited = folder_.path() / kUnedited;
    fs::create_directory(unedited);
    const RunState state = stretch_into(unedited);
    if (state == RunState::kAccepted && call(edit_call(recipe_)) != 0) {
      failed("edit");
      return RunState::kRefused;
    }
    if (state == RunState::kAccepted) read_figures(folder_.path() / "report.json", record_);
    // A refusal is the run's
    if (state != RunState::kAccepted && fs::exists(unedited / "report.json"))
      fs::copy_file(unedited / "report.json", folder_.path() / "report.json");
    return state;
  }

  /// @param folder where the results go
  RunState stretch_into(const fs::path& folder) {
    const int code = call(stretch_call(recipe_, results()));
    const fs::path report = folder / "report.json";
    if (!fs::exists(report)) {
      failed("stretch");
      return RunState::kUnusable;
    }
    settle_report(report, scan_record(), record_);
    if (record_.reason == to_string(tool_path_stretcher::Reason::kPathNotScanned))
      look_at_cleaning(report);
    if (code == 0) return RunState::kAccepted;
    return code == kRefused ? RunState::kRefused : RunState::kUnusable;
  }

  /// Looks for waypoints where the cleaning took the points. A run without this is still a run.
  void look_at_cleaning(const fs::path& report) {
    try {
      const auto taken =
          waypoints_cleaned_away(recipe_, {inputs(), inputs() / scan_name(), record_.scan_units,
                                           folder_.path() / "object.ply", report});
      tell_cleaned_away(report, taken, record_);
    } catch (const scan_cell_common::Error& error) {
      ended_.warn(std::string("not known whether the cleaning removed it: ") + error.what());
    }
  }

  /// Finds which waypoints the scan could see, and what hindered the others. A run without it is
  /// still a run.
  void look() {
    const auto told = scan_record();
    if (!told || recipe_.program.empty()) return;  // a cloud from elsewhere
    if (is_robot_program(recipe_.path)) return;    // seen_waypoints reads none
    const ScannedWith with = read_scanned_with(*told);
    if (!keep_scanner_model(with)) {
      ended_.warn("not known what the scan could see: scanner model " + with.scanner +
                  " is missing, or no longer as it was at the scan");
      return;
    }
    const int code = call(sight_call(recipe_, with.region, results() + "/report.json"));
    if (code != 0 && code != kRefused)
      ended_.warn("not known what the scan could see: " + last_line(log_of("sight")));
  }

  /// Keeps the scanner model among the inputs, if it is as it was at the scan.
  bool keep_scanner_model(const ScannedWith& with) const {
    if (fs::exists(folder_.path() / kScannerInput)) return true;
    try {
      if (with.sha256.empty() || scan_cell_common::sha256_of_file(with.scanner) != with.sha256)
        return false;
      folder_.add(with.scanner, kScannerInput);
      return true;
    } catch (const scan_cell_common::FileError&) {
      return false;
    }
  }

  void measure() {
    if (call(deviations_call(recipe_)) == 0) {
      read_deviations(folder_.path() / "deviation.json", record_);
    } else {
      ended_.warn("no deviations: " + last_line(log_of("deviations")));
    }
  }

  bool write_programs() {
    for (const RobotProgram& program : recipe_.programs) {
      fs::create_directories((inputs() / program_file(program)).parent_path());
      const ToolCall exporting = export_call(recipe_, program);
      if (call(exporting) != 0) return failed(exporting.stage);
    }
    return true;
  }

  /// A run without its page is still a run.
  void draw() {
    if (begins_) begins_("report");
    const fs::path log = folder_.path() / "stages" / "report.log";
    try {
      const auto page =
          run_tool({"report", "part_recipes", {"report_page.py", folder_.path().string()}},
                   inputs(), log, request_.stop);
      if (page.exit_code != 0) ended_.warn("no page: " + last_line(log));
    } catch (const scan_cell_common::FileError& error) {
      ended_.warn(std::string("no page: ") + error.what());
    }
    fs::remove(log);  // it comes after run.json, which has the hash of every other file
  }

  const Recipe& recipe_;
  const RunRequest& request_;
  const StageBegins& begins_;
  RunFolder folder_;
  EndedRun ended_;
  RunRecord& record_ = ended_.record;
  Hashes hashes_;               // of the recipe as it was taken
  std::optional<Proof> proof_;  // none: the run need not go by one
};

}  // namespace

EndedRun run_recipe(const Recipe& recipe, const RunRequest& request, const StageBegins& begins) {
  return Run(recipe, request, begins).run();
}

}  // namespace part_recipes
