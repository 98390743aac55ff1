// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/place_check.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "clock/utc_time.h"
#include "record/record_names.h"
#include "run/calls/stage_calls.h"
#include "run/calls/tool_call.h"
#include "run/run_folder.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_path_stretcher/reported_verdict.h"
#include "tool_path_stretcher/surface.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using tool_path_stretcher::ReportedVerdict;

/// A dotted folder for the tools, beside the run. It is removed with this object.
class CheckFolder {
 public:
  CheckFolder(const Recipe& recipe, const fs::path& run)
      : path_(run.parent_path() / ("." + run.filename().string() + ".check")) {
    fs::remove_all(path_);  // of a check that was killed
    for (const std::string& name : recipe.files()) {
      fs::create_directories((inputs() / name).parent_path());
      fs::copy_file(run / "inputs" / name, inputs() / name);
    }
  }
  ~CheckFolder() {
    std::error_code failure;
    fs::remove_all(path_, failure);
  }
  CheckFolder(const CheckFolder&) = delete;
  CheckFolder& operator=(const CheckFolder&) = delete;

  fs::path inputs() const { return path_ / "inputs"; }
  fs::path report() const { return path_ / "report.json"; }
  fs::path log() const { return path_ / "tool.log"; }

 private:
  fs::path path_;
};

/// The farthest distance that any corner of a box around the points moves.
double farthest(const tool_path_stretcher::Similarity& similarity,
                const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
    box.extend(point);
  double farthest = 0;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    farthest = std::max(farthest, (similarity * corner - corner).norm());
  }
  return farthest;
}

PlaceCheck judge(const ReportedVerdict& verdict, const fs::path& object, double tolerance) {
  using scan_cell_common::kMillimetres;
  PlaceCheck found;
  if (!verdict.accepted || verdict.similarities.empty()) {
    found.message = "the part was not found again as it was scanned (" + verdict.reason +
                    "): " + verdict.message;
    return found;
  }
  const auto points = tool_path_stretcher::to_points(scan_cell_common::load_cloud(object.string()));
  found.moved = farthest(verdict.similarities.front(), points);
  found.changed = 0;
  for (const double displacement : verdict.displacements)
    found.changed = std::max(*found.changed, displacement);
  found.lies_there = *found.moved + *found.changed <= tolerance;
  found.message = fmt::format(
      "since it was scanned the part moved by up to {:.2f} mm, and its path by up to "
      "{:.2f} mm more; {:.2f} mm are allowed{}",
      kMillimetres * *found.moved, kMillimetres * *found.changed, kMillimetres * tolerance,
      found.lies_there ? "" : ": run the part again");
  return found;
}

void save(const PlaceCheck& found, double tolerance, const std::string& file) {
  nlohmann::ordered_json all;
  all["time"] = utc_now();
  all["lies_there"] = found.lies_there;
  all["moved"] = found.moved ? nlohmann::ordered_json(*found.moved) : nullptr;
  all["changed"] = found.changed ? nlohmann::ordered_json(*found.changed) : nullptr;
  all["tolerance"] = tolerance;
  all["message"] = found.message;
  constexpr int kIndent = 2;
  scan_cell_common::save_text(file, all.dump(kIndent) + "\n");
}

/// The stages of a check.
class Check {
 public:
  Check(const Recipe& recipe, const fs::path& run, const RunRequest& request,
        const StageBegins& begins)
      : recipe_(recipe), run_(run), request_(request), begins_(begins), folder_(recipe, run) {
    recipe_.program = recipe.check.value().program;
  }

  PlaceCheck run(const std::optional<fs::path>& scan) {
    if (scan)
      fs::copy_file(*scan, folder_.inputs() / "scan.ply");
    else if (call(scan_call(recipe_, load_run(run_).calibration, false, request_.timeout)) != 0)
      return failed("scan");
    if (call(clean_call(recipe_, "scan.ply", "m")) != 0) return failed("clean");
    const int code = call(recheck_call(recipe_, run_));
    if (code != 0 && code != scan_cell_common::kRefused) return failed("stretch");
    return judge(tool_path_stretcher::load_report(folder_.report().string()), run_ / "object.ply",
                 recipe_.check->tolerance);
  }

 private:
  int call(const ToolCall& call) {
    if (begins_) begins_("check_" + call.stage);
    return run_tool(call, folder_.inputs(), folder_.log(), request_.stop).exit_code;
  }

  PlaceCheck failed(const std::string& stage) const {
    return {false,
            {},
            {},
            "it is not known whether the part lies where it was scanned: " + stage +
                " failed: " + last_line(folder_.log())};
  }

  Recipe recipe_;  // with the program of its check
  const fs::path run_;
  const RunRequest& request_;
  const StageBegins& begins_;
  const CheckFolder folder_;
};

}  // namespace

PlaceCheck check_place(const Recipe& recipe, const fs::path& run, const RunRequest& request,
                       const StageBegins& begins, const std::optional<fs::path>& scan) {
  try {
    const PlaceCheck found =
        Check(recipe, fs::absolute(run).lexically_normal(), request, begins).run(scan);
    save(found, recipe.check->tolerance, free_name(run.string() + ".check") + ".json");
    return found;
  } catch (const fs::filesystem_error& error) {
    throw scan_cell_common::FileError(error.path1().string(), error.code().message(),
                                      "was the run made by this recipe? run the part again");
  }
}

}  // namespace part_recipes
