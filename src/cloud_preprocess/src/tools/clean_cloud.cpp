// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "cloud_preprocess/clean.h"
#include "scan_cell_common/tool_main.h"
#include "scan_cell_common/yaml_file.h"

using cloud_preprocess::CleanParameters;
using cloud_preprocess::Cloud;
using cloud_preprocess::StageReport;
using scan_cell_common::InvalidParameter;

namespace {

/// "floor.margin=0.003" into the tree, as if it stood in the file.
void set(YAML::Node& root, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const std::size_t dot = setting.find('.');
  if (equals == std::string::npos || dot > equals) {
    throw InvalidParameter("--set", "'" + setting + "'", "give STAGE.PARAMETER=VALUE");
  }
  const std::string name = setting.substr(dot + 1, equals - dot - 1);
  root[setting.substr(0, dot)][name] = YAML::Load(setting.substr(equals + 1));
}

void set_grid(YAML::Node& root, const std::string& leaf) {
  root["grid"] = YAML::Node(false);
  if (leaf == "off") return;
  root["grid"] = YAML::Node(YAML::NodeType::Map);
  for (const std::string& side : CLI::detail::split(leaf, ',')) {
    double millimetres = 0;
    if (!CLI::detail::lexical_cast(side, millimetres)) {
      throw InvalidParameter("--grid", "'" + leaf + "'", "give X,Y,Z in mm, or off");
    }
    root["grid"]["leaf"].push_back(millimetres * 1e-3);
  }
}

/// Options are carried out in the order they are added in: the file first.
void add_settings(CLI::App& app, YAML::Node& root) {
  using Words = std::vector<std::string>;
  app.add_option_function<std::string>(
      "--config", [&root](const std::string& path) { root = scan_cell_common::load_yaml(path); },
      "YAML file with the parameters of the stages; the options below override it");
  for (const std::string stage : {"floor", "outliers"}) {
    app.add_option_function<std::string>(
           "--" + stage,
           [&root, stage](const std::string& word) { root[stage]["automatic"] = word == "auto"; },
           "auto: find and remove; off: only cut by the limits")
        ->check(CLI::IsMember({"auto", "off"}));
  }
  for (const std::string limit : {"x-min", "x-max", "y-min", "y-max", "z-min", "z-max"}) {
    const std::string stage = limit[0] == 'z' ? "floor" : "outliers";
    std::string name = limit;
    std::replace(name.begin(), name.end(), '-', '_');
    app.add_option_function<double>(
        "--" + limit, [&root, stage, name](double value) { root[stage][name] = value; },
        "limit by hand in the stage " + stage + " [m]");
  }
  app.add_option_function<std::string>(
         "--isolate",
         [&root](const std::string& word) {
           root["isolate"]["select"] = word == "off" ? "all" : word;
         },
         "the object to keep")
      ->check(CLI::IsMember({"off", "largest", "nearest", "index"}));
  app.add_option_function<std::string>(
      "--grid", [&root](const std::string& leaf) { set_grid(root, leaf); },
      "X,Y,Z: size of a cell [mm]; off: keep every point");
  app.add_option_function<Words>(
         "--set",
         [&root](const Words& settings) {
           for (const std::string& setting : settings)
             set(root, setting);
         },
         "STAGE.PARAMETER=VALUE: any other parameter; may be repeated")
      ->take_all();
}

void print(const std::vector<StageReport>& reports) {
  for (const StageReport& report : reports) {
    std::printf("%-9s %8zu -> %8zu points: %s\n", report.stage.c_str(), report.points_in,
                report.points_out, report.message.c_str());
  }
}

void run(const std::string& input, const std::string& output, const CleanParameters& parameters) {
  std::vector<StageReport> reports;
  try {
    const Cloud cloud =
        cloud_preprocess::clean(scan_cell_common::load_cloud(input), parameters, reports);
    scan_cell_common::save_cloud(output, cloud);
  } catch (const scan_cell_common::Error&) {
    print(reports);
    throw;
  }
  print(reports);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Cleans a scanned cloud: floor, outliers, isolation of one object, grid reduction.");
  std::string input, output;
  YAML::Node root(YAML::NodeType::Map);
  app.add_option("--input", input, "cloud to clean (.ply, .pcd) [m]")->required();
  app.add_option("--output", output, "clean cloud (.ply, .pcd); only written if all went well")
      ->required();
  add_settings(app, root);
  return scan_cell_common::tool_main("clean_cloud", app, argc, argv, [&] {
    run(input, output, cloud_preprocess::read_clean_parameters({root, "settings"}));
    return 0;
  });
}
