// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history_print.h"

#include <fmt/format.h>

#include <cstdio>

#include "approval/approval.h"
#include "history/figure_text.h"
#include "history/run_columns.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"

using part_recipes::HistoryRun;

namespace {

using scan_cell_common::kMillimetres;

/// The text without control characters that a terminal would obey.
std::string printable(const std::string& text) {
  std::string result = text;
  for (char& byte : result) {
    if (static_cast<unsigned char>(byte) < 0x20 || byte == 0x7f) byte = ' ';
  }
  return result;
}

std::string number(const std::optional<double>& value, double factor, int decimals) {
  return value ? fmt::format("{:.{}f}", *value * factor, decimals) : "-";
}

void print_line(const std::string& line) {
  std::fputs((line + "\n").c_str(), stdout);
}

void print_field(const std::string& name, const std::string& value) {
  if (!value.empty()) print_line(fmt::format("{:<28}{}", name, printable(value)));
}

constexpr const char* kRow = "{:<20} {:<9} {:<22} {:>9} {:>9} {:>12}  {:<24} {}";

}  // namespace

void print_list(const std::vector<HistoryRun>& runs) {
  print_line(fmt::format(kRow, "started (UTC)", "state", "reason", "scale", "rms [mm]",
                         "largest [mm]", "recipe", "id"));
  constexpr std::size_t kToSeconds = sizeof("2026-11-25T12:13:14") - 1;
  for (const HistoryRun& run : runs) {
    const auto& [record, figures] = std::tie(run.record, run.record.figures);
    print_line(fmt::format(kRow, record.started.substr(0, kToSeconds), to_string(record.state),
                           printable(record.reason), number(figures.scale, 1, 5),
                           number(figures.rms, kMillimetres, 4),
                           number(figures.largest_displacement, kMillimetres, 3),
                           printable(record.recipe_name), printable(record.id)));
  }
}

void print_run(const HistoryRun& run, const std::filesystem::path& runs) {
  using namespace part_recipes;
  print_field("state", to_string(run.record.state));
  for (const TextColumn& text : kTextColumns)
    print_field(text.name, run.record.*text.member);
  print_field("folder", (runs / run.record.id).string());
  print_field("tolerance", millimetres_of(run.record.tolerance) + " mm");
  for (const auto& [name, value] : texts_of(run.record.figures))
    print_field(printable(name), value);
  for (const Approval& said : approvals_of(runs / run.record.id))
    print_field(said.approved ? "approved" : "refused",
                fmt::format("by {} at {}{}", said.name, said.time,
                            said.note.empty() ? "" : ": " + said.note));
}

int print_rebuilt(const part_recipes::Rebuilt& rebuilt, const std::filesystem::path& runs) {
  for (const auto& [folder, fault] : rebuilt.broken)
    std::fprintf(stderr, "left out: %s\n", printable(fault).c_str());
  for (const std::string& id : rebuilt.gone)
    std::fprintf(stderr, "no longer there: %s\n", printable(id).c_str());
  if (!rebuilt.order_lost.empty())
    std::fprintf(stderr,
                 "the old database could not be read (%s): runs are now in the order of their "
                 "start\n",
                 printable(rebuilt.order_lost).c_str());
  print_line(
      fmt::format("{} runs in {}", rebuilt.runs, (runs / part_recipes::kHistoryFile).string()));
  return rebuilt.broken.empty() ? 0 : scan_cell_common::kRefused;
}

void warn_of_left_out(const part_recipes::History& history) {
  const auto left_out = history.left_out();
  if (left_out.empty()) return;
  std::fprintf(stderr,
               "warning: %zu runs in %s are not in the history, the first is %s; history rebuild "
               "adds them\n",
               left_out.size(), history.folder().c_str(), printable(left_out.front()).c_str());
}
