// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "work/work_permit.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace scan_cell {
namespace {

using Json = nlohmann::ordered_json;
using scan_cell_common::Refused;

/// @throw Refused unless both are known and equal
void check_same(const std::string& what, const std::string& then, const std::string& now) {
  if (then.empty())
    throw Refused("report", "it does not say which " + what + " the part was scanned with",
                  "adapt the path in the running cell");
  if (now.empty())
    throw Refused(what, "the running cell's file cannot be read on this machine",
                  "start this node where the file is");
  if (then != now)
    throw Refused(what, "not the one that the part was scanned with", "scan and adapt again");
}

void check_age(const std::optional<double>& scanned, double max_age, double now) {
  if (!std::isfinite(max_age)) return;
  if (!scanned)
    throw Refused("report", "it does not say when the part was scanned",
                  "adapt the path in the running cell");
  if (now - *scanned > max_age)
    throw Refused("scan", fmt::format("{:.0f} s old; the limit is {:g} s", now - *scanned, max_age),
                  "scan and adapt again, or raise max_age");
  constexpr double kClocks = 1;  // [s] by which two machines' clocks may differ
  if (*scanned > now + kClocks)
    throw Refused("scan", fmt::format("made {:.0f} s in the future", *scanned - now),
                  "set the clocks of the machines, then scan and adapt again");
}

struct DryRunRecord {
  std::string proven_path;
  std::string cell;
  double time;
};

std::vector<DryRunRecord> read(const std::string& file) {
  std::vector<DryRunRecord> records;
  if (!std::filesystem::exists(file)) return records;
  try {
    const Json all = Json::parse(scan_cell_common::read_file(file));
    for (const Json& run : all.at("dry_runs"))
      records.push_back({run.at("proven_path").get<std::string>(),
                         run.at("cell").get<std::string>(), run.at("time").get<double>()});
  } catch (const Json::exception& error) {
    throw scan_cell_common::UnusableInput(file, error.what(),
                                          "remove it; then dry runs are needed again");
  }
  return records;
}

}  // namespace

bool DryRuns::has(const std::string& proven_path, const std::string& cell) const {
  for (const DryRunRecord& run : read(file_))
    if (run.proven_path == proven_path && run.cell == cell) return true;
  return false;
}

void DryRuns::add(const std::string& proven_path, const std::string& cell, double time) const {
  if (has(proven_path, cell)) return;
  std::vector<DryRunRecord> records = read(file_);
  records.push_back({proven_path, cell, time});
  Json all;
  all["dry_runs"] = Json::array();
  for (const DryRunRecord& run : records)
    all["dry_runs"].push_back(
        {{"proven_path", run.proven_path}, {"cell", run.cell}, {"time", run.time}});
  scan_cell_common::save_text(file_, all.dump(2) + "\n");
}

void check_permit(const tool_path_programs::AcceptedReport& report, const CalibrationNow& cell,
                  const WorkRules& rules, const DryRuns& dry_runs, bool dry, double now) {
  check_same("scanner model", report.scanner, cell.scanner);
  check_same("cell file", report.cell, cell.cell);
  check_age(report.scanned, rules.max_age, now);
  if (dry || !rules.dry_run_first) return;
  if (report.proven_path.empty() || !dry_runs.has(report.proven_path, report.cell))
    throw Refused("work", "no dry run of this path has been finished in this cell yet",
                  "run it dry once: lifted, slow, with the tool off");
}

}  // namespace scan_cell
