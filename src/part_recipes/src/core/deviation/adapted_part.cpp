// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/adapted_part.h"

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "tool_path_stretcher/reported_verdict.h"

namespace part_recipes {
namespace {

using scan_cell_common::UnusableInput;
using tool_path_stretcher::FileRecord;

void check_same(const std::string& file, const std::optional<FileRecord>& reported,
                const std::string& role) {
  if (file.empty() || !reported) return;
  if (tool_path_stretcher::record_of(file, reported->units).sha256 == reported->sha256) return;
  throw UnusableInput(file, "not the " + role + " of the report, which was " + reported->name,
                      "give the files of the run that wrote the report");
}

}  // namespace

AdaptedPart load_adapted_part(const AdaptedFiles& files) {
  const auto verdict = tool_path_stretcher::load_report(files.report);
  check_same(files.reference, verdict.reference, "reference");
  check_same(files.object, verdict.object, "object");
  std::string units = files.reference_units;
  if (verdict.reference) {
    if (!units.empty() && units != verdict.reference->units)
      throw UnusableInput("--reference-units",
                          units + ", but the report says " + verdict.reference->units,
                          "give those of the run");
    units = verdict.reference->units;
  }
  AdaptedPart part;
  if (!units.empty()) part.metres_per_unit = scan_cell_common::metres_per(units);
  if (!verdict.similarities.empty()) part.similarity = verdict.similarities.front();
  return part;
}

}  // namespace part_recipes
