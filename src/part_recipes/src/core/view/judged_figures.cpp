// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/judged_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "run/calls/recipe_reading.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/units.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using Limits = std::map<std::string, std::string>;  // by the figure's name
using Shares = std::map<std::string, double>;       // likewise
using tool_path_stretcher::StretchParameters;

constexpr double kPercent = 100;

std::string millimetres(double metres) {
  return fmt::format("{:.4g} mm", metres * scan_cell_common::kMillimetres);
}

/// The range of scales allowed by the parameters and by what is known of the size.
std::string scales_of(const StretchParameters& parameters) {
  const auto known = parameters.prior.scale.range();
  const double least = std::max(parameters.min_scale, known.least);
  const double most = std::min(parameters.max_scale, known.most);
  if (least > most) return "none: the known scale is outside min_scale to max_scale";
  if (least == most) return fmt::format("exactly {:.4g}", least);
  return fmt::format("{:.4g} to {:.4g}", least, most);
}

/// @param edges_are_known the reference is a mesh: for others, the error along the surface is no
/// reason to refuse
Limits limits_of(const StretchParameters& parameters, bool edges_are_known) {
  Limits limits = {
      {"scale", scales_of(parameters)},
      {"largest_displacement", fmt::format("at most {:.4g} % of the part's length",
                                           kPercent * parameters.max_displacement_ratio)},
      {"expected_error_orientation",
       fmt::format("at most {:.3g} deg",
                   parameters.max_orientation_error * scan_cell_common::kDegrees)},
      {"overlap", fmt::format("at least {:.4g} %", kPercent * parameters.min_overlap)},
      {"inlier_ratio", fmt::format("at least {:.4g} %", kPercent * parameters.min_inlier_ratio)}};
  const double known = parameters.prior.pose ? parameters.prior.pose->distance : 0;
  if (edges_are_known)
    limits["expected_error_tangential"] =
        "at most " + millimetres(std::max(parameters.max_position_error, known));
  return limits;
}

/// @param accepted shares of an accepted run: a reference that shows only a part of the object is
/// judged by what it reaches, not by its share of the whole
Limits limits_in(const fs::path& run, const Shares& accepted) {
  try {
    const Recipe recipe = load_recipe(run / "inputs");
    const std::string reference = (run / "inputs" / recipe.reference.file).string();
    const StretchParameters parameters = stretch_parameters_of(recipe);
    Limits limits = limits_of(parameters, scan_cell_common::is_mesh_file(reference));
    const auto explained = accepted.find("inlier_ratio");
    if (explained != accepted.end() && explained->second < parameters.min_inlier_ratio)
      limits.erase(explained->first);
    return limits;
  } catch (const scan_cell_common::Error&) {
    return {};  // the figures themselves are there
  }
}

/// The shares in the report, by name.
Shares shares_in(const fs::path& run) {
  Shares shares;
  const fs::path report = run / "report.json";
  if (!fs::exists(report)) return shares;
  const auto all =
      nlohmann::json::parse(scan_cell_common::read_file(report.string()), nullptr, false);
  for (const char* const name : {"inlier_ratio", "overlap"})
    if (all.is_object() && all.contains(name) && all[name].is_number())
      shares[name] = all[name].get<double>();
  return shares;
}

bool is_deviation(const std::string& name) {
  return name == "deviation_min" || name == "deviation_max" || name.rfind("place ", 0) == 0;
}

}  // namespace

std::vector<JudgedFigure> judged_figures(
    const fs::path& run, const RunRecord& record,
    const std::vector<std::pair<std::string, std::string>>& texts) {
  const Shares shares = shares_in(run);
  Limits limits = limits_in(run, record.state == RunState::kAccepted ? shares : Shares());
  std::vector<JudgedFigure> figures;
  for (const auto& [name, value] : texts)
    figures.push_back(
        {name, value,
         is_deviation(name) ? "good within " + millimetres(record.tolerance) : limits[name]});
  for (const auto& [name, share] : shares)
    figures.push_back({name, fmt::format("{:.2f} %", kPercent * share), limits[name]});
  return figures;
}

}  // namespace part_recipes
