// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cloud_preprocess/clean.h"
#include "input_check.h"
#include "load_finder.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/outputs.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"

using cloud_preprocess::CleanParameters;
using cloud_preprocess::Cloud;
using cloud_preprocess::StageReport;
using cloud_preprocess::TracedCloud;
using scan_cell_common::InvalidParameter;

namespace {

struct Options {
  std::string input, output;
  std::string edits;         // file; empty: only those of the settings
  std::string objects;       // file name for all objects; empty: keep only one
  std::string units;         // of both; empty: not given
  std::string output_units;  // of the output, if different
  scan_cell_common::CloudFormat format;
};

/// Sets "floor.margin=0.003" in the tree, as if it stood in the file.
void set(YAML::Node& root, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const std::size_t dot = setting.find('.');
  if (equals == std::string::npos || dot > equals) {
    throw InvalidParameter("--set", fmt::format("'{}'", setting), "give STAGE.PARAMETER=VALUE");
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
      throw InvalidParameter("--grid", fmt::format("'{}'", leaf), "give X,Y,Z in mm, or off");
    }
    root["grid"]["leaf"].push_back(millimetres * 1e-3);
  }
}

void set_up(YAML::Node& root, const std::string& up) {
  root["floor"]["any_direction"] = up == "auto";
  if (up == "auto") return;
  YAML::Node numbers(YAML::NodeType::Sequence);
  for (const std::string& word : CLI::detail::split(up, ',')) {
    const auto number = scan_cell_common::parse_number(word);
    if (!number) throw InvalidParameter("--up", fmt::format("'{}'", up), "give X,Y,Z, or auto");
    numbers.push_back(*number);
  }
  root["floor"]["up"] = numbers;
}

void add_limits(CLI::App& app, YAML::Node& root) {
  for (const std::string limit : {"x-min", "x-max", "y-min", "y-max", "z-min", "z-max"}) {
    const std::string stage = limit[0] == 'z' ? "floor" : "outliers";
    std::string name = limit;
    std::replace(name.begin(), name.end(), '-', '_');
    app.add_option_function<double>(
        "--" + limit, [&root, stage, name](double value) { root[stage][name] = value; },
        "limit set by hand in the stage " + stage + " [m, whatever the files' unit]");
  }
}

/// Adds the options for the object to keep.
void add_isolation(CLI::App& app, YAML::Node& root) {
  app.add_option_function<std::string>(
      "--reference",
      [&root](const std::string& file) {
        root["isolate"]["select"] = "reference";
        root["isolate"]["reference"] = file;
      },
      "keep what this cloud or mesh explains: PLY, PCD, STL, OBJ");
  app.add_option_function<std::string>(
         "--reference-units",
         [&root](const std::string& units) { root["isolate"]["reference_units"] = units; },
         "unit of the reference; without it that of --units")
      ->check(CLI::IsMember(scan_cell_common::length_units()));
  app.add_option_function<std::string>(
         "--isolate",
         [&root](const std::string& word) {
           root["isolate"]["select"] = word == "off" ? "all" : word;
         },
         "the object to keep")
      ->check(CLI::IsMember({"off", "largest", "nearest", "index", "reference"}));
}

/// Options are applied in the order they are added: the file first.
void add_settings(CLI::App& app, YAML::Node& root) {
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
  app.add_option_function<std::string>(
      "--up", [&root](const std::string& up) { set_up(root, up); },
      "X,Y,Z: direction away from the floor; auto: a table in any direction");
  add_limits(app, root);
  add_isolation(app, root);
  app.add_option_function<std::string>(
      "--grid", [&root](const std::string& leaf) { set_grid(root, leaf); },
      "X,Y,Z: size of a cell [mm]; off: keep every point");
  app.add_option_function<std::vector<std::string>>(
         "--set",
         [&root](const std::vector<std::string>& settings) {
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

void print(const scan_cell_common::LoadedCloud& input, const CleanParameters& parameters) {
  const cloud_preprocess::CloudSize size = cloud_preprocess::measure(input.cloud, parameters);
  std::printf("%-9s %8zu             points: %s\n", "input", input.cloud.size(),
              cloud_preprocess::text_of(size).c_str());
  for (const std::string& note : input.notes)
    std::printf("%-9s %s\n", "", note.c_str());
}

/// The name of an object's file: part.ply, part_0.ply, part_1.ply, ...
std::string numbered(const std::filesystem::path& file, std::size_t number) {
  const std::string name =
      fmt::format("{}_{}{}", file.stem().string(), number, file.extension().string());
  return (file.parent_path() / name).string();
}

/// Removes what an earlier run left.
void remove_objects(const std::string& file) {
  for (std::size_t i = 0; std::filesystem::exists(numbered(file, i)); ++i)
    scan_cell_common::remove_old(numbered(file, i));
}

/// @param carried other fields of the input
void save(const std::string& path, const TracedCloud& cloud,
          const scan_cell_common::FieldedCloud& carried, double metres_per_unit) {
  if (carried.fields.empty()) {
    scan_cell_common::save_cloud(path, cloud.cloud(), metres_per_unit);
    return;
  }
  const auto fielded =
      scan_cell_common::with_fields(cloud.cloud(), carried.view(), cloud.sources());
  scan_cell_common::save_cloud(path, fielded.view(), metres_per_unit);
}

void clean_and_save(const Options& options, Cloud cloud,
                    const scan_cell_common::FieldedCloud& carried,
                    const CleanParameters& parameters, double metres_per_unit,
                    std::vector<StageReport>& reports) {
  TracedCloud part(std::move(cloud));
  std::vector<TracedCloud> objects;
  if (options.objects.empty()) {
    cloud_preprocess::clean(part, parameters, reports);
  } else {
    cloud_preprocess::clean(part, parameters, reports, objects);
  }
  save(options.output, part, carried, metres_per_unit);
  for (std::size_t i = 0; i < objects.size(); ++i)
    save(numbered(options.objects, i), objects[i], carried, metres_per_unit);
  if (!objects.empty())
    std::printf("%-9s %8zu files from %s on\n", "objects", objects.size(),
                numbered(options.objects, 0).c_str());
}

/// The parameters, with everything they need.
CleanParameters prepared(YAML::Node& root, const Options& options) {
  YAML::Node isolate = root["isolate"];
  if (!options.units.empty() && isolate && isolate["reference"] && !isolate["reference_units"])
    isolate["reference_units"] = options.units;
  CleanParameters parameters = cloud_preprocess::read_clean_parameters({root, "settings"});
  if (!options.edits.empty()) {
    const auto edits = cloud_preprocess::load_edits(options.edits);
    parameters.edits.insert(parameters.edits.end(), edits.begin(), edits.end());
  }
  auto& isolation = parameters.isolate;
  if (!isolation.reference.empty() && isolation.select != cloud_preprocess::Selection::kReference) {
    throw InvalidParameter("isolate.reference", fmt::format("'{}'", isolation.reference),
                           "leave it out, or give --isolate reference");
  }
  isolation.finder = cloud_preprocess::load_finder(isolation);
  return parameters;
}

void run(Options& options, const CleanParameters& parameters) {
  scan_cell_common::check_cloud_output(options.output);
  if (!options.objects.empty()) {
    scan_cell_common::check_cloud_output(options.objects);
    remove_objects(options.objects);
  }
  const std::string units = options.units.empty() ? "m" : options.units;
  options.format.metres_per_unit = scan_cell_common::metres_per(units);
  const double output_unit =
      scan_cell_common::metres_per(options.output_units.empty() ? units : options.output_units);
  scan_cell_common::FieldedCloud carried;
  scan_cell_common::LoadedCloud input =
      scan_cell_common::load_cloud_file(options.input, options.format, carried);
  print(input, parameters);
  cloud_preprocess::check_input(input.cloud, parameters, options.units, options.input);
  std::vector<StageReport> reports;
  try {
    clean_and_save(options, std::move(input.cloud), carried, parameters, output_unit, reports);
  } catch (const scan_cell_common::Error&) {
    print(reports);
    throw;
  }
  print(reports);
}

void add_files(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  app.add_option("--objects", options.objects,
                 "part.ply: also every object that was found, along isolate/axis, as part_0.ply, "
                 "part_1.ply, ...");
  app.add_option("--edits", options.edits,
                 "YAML file with what was deleted and kept by hand, done before all stages");
  const CLI::IsMember is_unit(scan_cell_common::length_units());
  app.add_option("--input", options.input, "cloud to clean (.ply, .pcd, .xyz, .csv, .txt, .asc)")
      ->required();
  outputs
      .add(app, "--output", options.output,
           "clean cloud (.ply, .pcd); only written if all went well")
      ->required();
  app.add_option("--units", options.units,
                 "unit of both files; without it metres, and the size is checked")
      ->check(is_unit);
  app.add_option("--output-units", options.output_units, "unit of the output, if different")
      ->check(is_unit);
  app.add_option("--invalid", options.format.invalid,
                 "number that means \"nothing measured\": points with it are dropped; may be "
                 "repeated [unit of the file]")
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--column-step", options.format.column_step,
                 "the input is depth profiles, one per line: distance between columns [unit of the "
                 "file]");
  app.add_option("--profile-step", options.format.profile_step,
                 "depth profiles: distance between lines [unit of the file]");
}

}  // namespace

int main(int argc, char** argv) {
  scan_cell_common::Outputs outputs;
  CLI::App app(
      "Cleans a scanned cloud: edits by hand, floor, outliers, isolation of one object, grid "
      "reduction.");
  Options options;
  YAML::Node root(YAML::NodeType::Map);
  app.add_flag_callback(
      "--parameters",
      [] {
        std::fputs(scan_cell_common::parameter_rows<CleanParameters>().c_str(), stdout);
        throw CLI::Success();
      },
      "print the parameters of the stages as a table");
  add_files(app, options, outputs);
  add_settings(app, root);
  return scan_cell_common::tool_main(
      "clean_cloud", app, argc, argv,
      [&] {
        run(options, prepared(root, options));
        return 0;
      },
      scan_cell_common::kUnusable, outputs);
}
