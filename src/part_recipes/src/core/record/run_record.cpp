// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

using Json = nlohmann::ordered_json;
using scan_cell_common::UnusableInput;

constexpr int kFormat = 1;
const std::map<std::string, RunState> kStates = {{"accepted", RunState::kAccepted},
                                                 {"refused", RunState::kRefused},
                                                 {"unusable", RunState::kUnusable}};

Json number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::optional<double> number_in(const Json& all, const std::string& key) {
  if (!all.contains(key) || all.at(key).is_null()) return std::nullopt;
  return all.at(key).get<double>();
}

/// The figures and their names.
template <class Figures>
auto named(Figures& figures) {
  return std::vector<std::pair<const char*, decltype(&figures.scale)>>{
      {"scale", &figures.scale},
      {"rms", &figures.rms},
      {"largest_displacement", &figures.largest_displacement},
      {"expected_error_normal", &figures.expected_error_normal},
      {"expected_error_tangential", &figures.expected_error_tangential},
      {"expected_error_orientation", &figures.expected_error_orientation},
      {"deviation_rms", &figures.deviation_rms},
      {"deviation_min", &figures.deviation_min},
      {"deviation_max", &figures.deviation_max}};
}

Json json_of(const RunFigures& figures) {
  Json all = Json::object();
  for (const auto& [name, value] : named(figures))
    all[name] = number(*value);
  all["places"] = Json::object();
  for (const auto& [name, value] : figures.places)
    all["places"][name] = number(value);
  return all;
}

RunFigures figures_in(const Json& all) {
  RunFigures figures;
  for (const auto& [name, value] : named(figures))
    *value = number_in(all, name);
  if (!all.contains("places")) return figures;
  for (const auto& [name, value] : all.at("places").items())
    figures.places[name] = value.is_null() ? std::nullopt : std::optional(value.get<double>());
  return figures;
}

Json json_of(const std::vector<StageRecord>& stages) {
  Json all = Json::array();
  for (const StageRecord& stage : stages) {
    all.push_back({{"name", stage.name},
                   {"command", stage.command},
                   {"exit_code", stage.exit_code},
                   {"seconds", stage.seconds}});
  }
  return all;
}

std::vector<StageRecord> stages_in(const Json& all) {
  std::vector<StageRecord> stages;
  for (const Json& stage : all) {
    stages.push_back({stage.at("name"), stage.at("command").get<std::vector<std::string>>(),
                      stage.at("exit_code"), stage.at("seconds")});
  }
  return stages;
}

RunRecord record_in(const Json& all) {
  if (const int format = all.at("format"); format != kFormat)
    throw std::runtime_error(fmt::format("format {}, this version reads {}", format, kFormat));
  RunRecord record;
  record.id = all.at("id");
  record.recipe_name = all.at("recipe").at("name");
  record.recipe_folder = all.at("recipe").at("folder");
  record.recipe_sha256 = all.at("recipe").at("sha256");
  record.started = all.at("started");
  record.ended = all.at("ended");
  record.host = all.at("host");
  record.version = all.at("version");
  record.state = kStates.at(all.at("outcome").at("state"));
  record.reason = all.at("outcome").at("reason");
  record.message = all.at("outcome").at("message");
  record.stages = stages_in(all.at("stages"));
  record.tolerance = all.at("tolerance");
  record.scan_units = all.at("scan_units");
  record.figures = figures_in(all.at("figures"));
  record.calibration = all.at("calibration").get<std::map<std::string, std::string>>();
  for (const auto& [name, file] : all.at("files").items())
    record.files[name] = {file.at("sha256"), file.at("bytes")};
  if (!all.at("again_of").is_null()) record.again_of = all.at("again_of");
  record.path_edits = all.value("path_edits", std::size_t{0});
  record.note = all.at("note");
  return record;
}

}  // namespace

std::string to_string(RunState state) {
  for (const auto& [word, value] : kStates) {
    if (value == state) return word;
  }
  return "unusable";
}

std::string to_json(const RunRecord& record) {
  Json all = {{"format", kFormat},
              {"id", record.id},
              {"recipe",
               {{"name", record.recipe_name},
                {"folder", record.recipe_folder},
                {"sha256", record.recipe_sha256}}},
              {"started", record.started},
              {"ended", record.ended},
              {"host", record.host},
              {"version", record.version},
              {"outcome",
               {{"state", to_string(record.state)},
                {"reason", record.reason},
                {"message", record.message}}},
              {"stages", json_of(record.stages)},
              {"tolerance", record.tolerance},
              {"scan_units", record.scan_units},
              {"figures", json_of(record.figures)},
              {"calibration", record.calibration},
              {"files", Json::object()}};
  for (const auto& [name, file] : record.files)
    all["files"][name] = {{"sha256", file.sha256}, {"bytes", file.bytes}};
  all["again_of"] = record.again_of.empty() ? Json(nullptr) : Json(record.again_of);
  if (record.path_edits > 0) all["path_edits"] = record.path_edits;
  all["note"] = record.note;
  constexpr int kIndent = 2;
  // What tools print may hold broken UTF-8.
  return all.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

RunRecord load_run(const std::filesystem::path& folder) {
  const std::string file = (folder / kRunFile).string();
  const std::string text = scan_cell_common::read_file(file);
  try {
    return record_in(Json::parse(text));
  } catch (const std::exception& error) {
    throw UnusableInput(file, error.what(), "restore it from a copy, or do not use this run");
  }
}

}  // namespace part_recipes
