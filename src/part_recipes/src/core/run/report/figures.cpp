// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/report/figures.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

using Json = nlohmann::ordered_json;

/// @param use gets the contents of the file
template <class Use>
void read(const std::filesystem::path& file, const Use& use) {
  const std::string text = scan_cell_common::read_file(file.string());
  try {
    use(Json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw scan_cell_common::UnusableInput(file.string(), error.what(), "see the log of its stage");
  }
}

std::optional<double> number(const Json& all, const char* key) {
  const auto found = all.find(key);
  if (found == all.end() || found->is_null()) return std::nullopt;
  return found->get<double>();
}

void take_figures(const Json& report, RunRecord& record) {
  record.reason = report.at("reason").get<std::string>();
  record.message = report.at("message").get<std::string>();
  RunFigures& figures = record.figures;
  figures.scale = number(report, "scale");
  figures.rms = number(report, "rms");
  figures.largest_displacement = number(report, "largest_displacement");
  figures.expected_error_normal = number(report, "largest_expected_error_normal");
  figures.expected_error_tangential = number(report, "largest_expected_error_tangential");
  figures.expected_error_orientation = number(report, "largest_expected_error_orientation");
}

/// Adds what the report needs from the scan.
void add_scan(Json& report, const Json& scan) {
  for (const char* key : {"scanned", "calibration", "passes"}) {
    if (scan.contains(key)) report[key] = scan.at(key);
  }
}

void save(const Json& all, const std::filesystem::path& report) {
  constexpr int kIndent = 2;
  scan_cell_common::save_text(report.string(), all.dump(kIndent) + "\n");
}

}  // namespace

void settle_report(const std::filesystem::path& report,
                   const std::optional<std::filesystem::path>& scan, RunRecord& record) {
  read(report, [&](Json all) {
    take_figures(all, record);
    all.erase("seconds");
    all.erase("seconds_of");
    if (scan) read(*scan, [&all](const Json& told) { add_scan(all, told); });
    save(all, report);
  });
}

void tell_cleaned_away(const std::filesystem::path& report, const std::vector<std::size_t>& taken,
                       RunRecord& record) {
  if (taken.empty()) return;
  read(report, [&](Json all) {
    record.message += fmt::format(
        "; at {} of the {} waypoints the raw scan has points that the clean cloud does not have, "
        "of the part or of what is beneath it: look at the cleaning (page 2 of the seat) before "
        "you scan again",
        taken.size(), all.at("waypoints_concerned").size());
    all["message"] = record.message;
    all["cleaned_away"] = taken;
    save(all, report);
  });
}

void read_figures(const std::filesystem::path& report, RunRecord& record) {
  read(report, [&record](const Json& all) { take_figures(all, record); });
}

void read_deviations(const std::filesystem::path& summary, RunRecord& record) {
  read(summary, [&record](const Json& all) {
    record.figures.deviation_rms = number(all, "rms");
    record.figures.deviation_min = number(all, "min");
    record.figures.deviation_max = number(all, "max");
    for (const Json& place : all.at("places"))
      record.figures.places[place.at("name").get<std::string>()] = number(place, "deviation");
  });
}

void read_scan(const std::filesystem::path& scan, RunRecord& record) {
  read(scan, [&record](const Json& all) {
    for (const auto& [name, file] : all.at("calibration").items()) {
      if (!file.at("sha256").is_null())
        record.calibration[name] = file.at("sha256").get<std::string>();
    }
  });
}

ScannedWith read_scanned_with(const std::filesystem::path& scan) {
  ScannedWith with;
  read(scan, [&with](const Json& all) {
    const Json& scanner = all.at("calibration").at("scanner");
    with.scanner = scanner.at("name").get<std::string>();
    if (!scanner.at("sha256").is_null()) with.sha256 = scanner.at("sha256").get<std::string>();
    const auto region = all.find("camera_region");
    if (region == all.end() || region->is_null()) return;
    for (const auto& [side, pixels] : region->items()) {
      with.region.push_back("--region-" + side);
      with.region.push_back(std::to_string(pixels.get<unsigned>()));
    }
  });
  return with;
}

}  // namespace part_recipes
