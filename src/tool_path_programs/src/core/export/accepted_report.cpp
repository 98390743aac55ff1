// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/accepted_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/sha256.h"

namespace tool_path_programs {
namespace {

using Json = nlohmann::json;
using scan_cell_common::Refused;

void check_is_of(const Json& report, const std::string& report_file, const std::string& path) {
  if (report.at("verdict") != "accepted")
    throw Refused(report_file, "refused: " + report.at("message").get<std::string>(),
                  "only an accepted path becomes a program");
  const Json& output = report.at("files").at("output");
  if (output.is_null())
    throw Refused(report_file, "it does not name the accepted file",
                  "give the report that stretch wrote with the path");
  if (output.at("sha256") != scan_cell_common::sha256_of_file(path))
    throw Refused(path, "not the path that " + report_file + " accepted: its SHA-256 differs",
                  "give the path as stretch wrote it, or stretch again");
}

/// Empty: not in the report.
std::string hash_of(const Json& report, const std::string& group, const std::string& file) {
  const auto found = report.find(group);
  if (found == report.end() || !found->contains(file)) return "";
  const Json& record = found->at(file);
  if (record.is_null() || record.at("sha256").is_null()) return "";
  return record.at("sha256").get<std::string>();
}

/// Adds what a person changed by hand, up to kMost edits.
void add_edits(const Json& edits, std::vector<std::string>& comments) {
  constexpr std::size_t kMost = 20;  // more would swamp the program
  const auto done = edits.at("done").get<std::vector<std::string>>();
  for (std::size_t i = 0; i < std::min(done.size(), kMost); ++i)
    comments.push_back("edited by hand: " + done[i]);
  if (done.size() > kMost)
    comments.push_back(fmt::format("edited by hand: {} more, see the report", done.size() - kMost));
}

std::string file_comment(const std::string& what, const Json& file) {
  if (file.is_null()) return what + ": not from a file";
  return what + ": " + file.at("name").get<std::string>() + " sha256 " +
         file.at("sha256").get<std::string>().substr(0, 16);
}

}  // namespace

AcceptedReport accepted_report(const std::string& report_file, const std::string& path) {
  const std::string text = scan_cell_common::read_file(report_file);
  try {
    const Json report = Json::parse(text);
    check_is_of(report, report_file, path);
    AcceptedReport result;
    const Json& files = report.at("files");
    result.comments = {file_comment("reference", files.at("reference")),
                       file_comment("object", files.at("object")),
                       file_comment("path", files.at("output")),
                       "verdict: accepted, report sha256 " +
                           scan_cell_common::sha256_of(text, report_file).substr(0, 16)};
    if (report.contains("edits")) add_edits(report.at("edits"), result.comments);
    const Json& quality = report.at("quality");
    for (std::size_t i = 0; i < quality.size(); ++i)
      if (quality[i].at("in_air").get<bool>()) result.in_air.push_back(i);
    result.proven_path = hash_of(report, "files", "path");
    if (report.contains("edits") && !result.proven_path.empty())
      result.proven_path = scan_cell_common::sha256_of(
          result.proven_path + report.at("edits").at("sha256").get<std::string>(), report_file);
    result.scanner = hash_of(report, "calibration", "scanner");
    result.cell = hash_of(report, "calibration", "cell");
    if (report.contains("scanned")) result.scanned = report.at("scanned").get<double>();
    return result;
  } catch (const Json::exception& error) {
    throw scan_cell_common::UnusableInput(report_file, error.what(),
                                          "give a report that stretch wrote");
  }
}

}  // namespace tool_path_programs
