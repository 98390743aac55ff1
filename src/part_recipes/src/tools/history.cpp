// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/history.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>

#include "approval/approval.h"
#include "clock/utc_time.h"
#include "history/chart/run_chart.h"
#include "history/export/aqdef.h"
#include "history/export/history_csv.h"
#include "history_draw.h"
#include "history_print.h"
#include "history_replay.h"
#include "recipe/recipe.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/outputs.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

namespace fs = std::filesystem;

using part_recipes::History;
using part_recipes::HistoryRun;
using scan_cell_common::Outputs;

struct Options {
  std::string runs = "runs";
  std::string folder;  // of a run to be added
  std::string id;
  std::string name;  // of who approves
  std::string note;
  std::string output;
  bool csv = false;
  part_recipes::HistoryFilter filter;
};

void add_runs(CLI::App& app, Options& options) {
  app.add_option("--runs", options.runs, "folder of the runs")
      ->envname("SCAN_CELL_RUNS")
      ->capture_default_str();
}

CLI::App* add_filtered(CLI::App& app, Options& options, const std::string& name,
                       const std::string& description) {
  CLI::App* const command = app.add_subcommand(name, description);
  add_runs(*command, options);
  add_query(*command, options.filter);
  return command;
}

std::vector<HistoryRun> runs_asked_for(const Options& options) {
  const History history(options.runs);
  auto runs = history.query(options.filter);
  warn_of_left_out(history);
  return runs;
}

int list(const Options& options) {
  const auto runs = runs_asked_for(options);
  if (!options.csv) {
    print_list(runs);
    return 0;
  }
  const std::string text = part_recipes::to_csv(runs);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

int show(const Options& options) {
  print_run(History(options.runs).find(options.id), options.runs);
  return 0;
}

int approve(const Options& options, bool approved) {
  const std::string& id = options.id;
  part_recipes::check_name(id);
  part_recipes::add_approval(fs::path(options.runs) / id,
                             {approved, options.name, options.note, part_recipes::utc_now()});
  std::printf("%s %s by %s\n", id.c_str(), approved ? "approved" : "refused", options.name.c_str());
  return 0;
}

int rebuild(const Options& options) {
  return print_rebuilt(History(options.runs).rebuild(), options.runs);
}

int add(const Options& options, bool is_runs_given) {
  const fs::path folder = fs::absolute(options.folder).lexically_normal();
  const fs::path plain = folder.filename().empty() ? folder.parent_path() : folder;
  const History history(is_runs_given ? fs::path(options.runs) : plain.parent_path());
  const bool added = history.add(plain);
  std::printf("%s %s\n", plain.filename().c_str(), added ? "added" : "is already in the history");
  return 0;
}

int save_csv(const Options& options) {
  scan_cell_common::remove_old(options.output);
  scan_cell_common::save_text(options.output, part_recipes::to_csv(runs_asked_for(options)));
  return 0;
}

int save_aqdef(const Options& options) {
  scan_cell_common::check_output(options.output, {".dfq"}, "write AQDEF as .dfq");
  scan_cell_common::remove_old(options.output);
  scan_cell_common::save_text(options.output, part_recipes::to_aqdef(runs_asked_for(options)));
  return 0;
}

std::string chart_data(const Options& options) {
  const auto runs = runs_asked_for(options);
  if (runs.empty())
    throw scan_cell_common::UnusableInput("recipe '" + *options.filter.recipe + "'",
                                          "no such runs in " + options.runs,
                                          "history list shows what there is");
  return to_json(part_recipes::run_charts(*options.filter.recipe, runs));
}

int print_chart_data(const Options& options) {
  const std::string data = chart_data(options);
  if (!options.output.empty()) {
    scan_cell_common::save_text(options.output, data);
  } else {
    std::fwrite(data.data(), 1, data.size(), stdout);
  }
  return 0;
}

int draw(const Options& options) {
  scan_cell_common::check_output(options.output, {".html", ".png"}, "draw as .html or .png");
  draw_chart(chart_data(options), options.output);
  return 0;
}

using Command = std::pair<CLI::App*, std::function<int(const Options&)>>;

Command add_approving(CLI::App& app, Options& options, bool approved) {
  CLI::App* const command = app.add_subcommand(
      approved ? "approve" : "refuse", approved ? "records that a person approves an accepted run"
                                                : "records that a person refuses a run");
  add_runs(*command, options);
  command->add_option("id", options.id)->required();
  command->add_option("--name", options.name, "name of that person")->required();
  command->add_option("--note", options.note, "why");
  return {command, [approved](const Options& given) { return approve(given, approved); }};
}

/// Commands that look up or change single runs.
std::vector<Command> add_keeping(CLI::App& app, Options& options) {
  CLI::App* const show_one = app.add_subcommand("show", "prints what the history has of a run");
  add_runs(*show_one, options);
  show_one->add_option("id", options.id)->required();
  CLI::App* const anew = app.add_subcommand(
      "rebuild", "rebuilds the history from the folders of the runs; exit code 2: a run is broken");
  add_runs(*anew, options);
  CLI::App* const add_one = app.add_subcommand("add", "adds a run that is not in the history");
  add_one->add_option("folder", options.folder, "folder of the run")->required();
  CLI::Option* const runs =
      add_one->add_option("--runs", options.runs, "folder of the runs (default: that of the run)");
  return {{show_one, show},
          {anew, rebuild},
          {add_one, [runs](const Options& given) { return add(given, runs->count() > 0); }},
          add_approving(app, options, true),
          add_approving(app, options, false)};
}

/// Commands that list, write or draw many runs.
std::vector<Command> add_listing(CLI::App& app, Options& options, Outputs& outputs) {
  const char* const kRecipe = "name of the recipe";
  const auto command = [&](const char* name, const char* description) {
    return add_filtered(app, options, name, description);
  };
  CLI::App* const listed = command("list", "lists runs");
  listed->add_flag("--csv", options.csv, "as CSV");
  CLI::App* const table = command("csv", "writes runs as CSV");
  table->add_option("output", options.output, "CSV")->required();
  CLI::App* const aqdef = command("aqdef", "writes runs for statistics programs (Q-DAS AQDEF)");
  aqdef->add_option("output", options.output, ".dfq")->required();
  for (CLI::App* const app_of : {listed, table, aqdef})
    app_of->add_option("--recipe", options.filter.recipe, kRecipe);
  CLI::App* const chart = command("chart", "draws control charts of a recipe's runs");
  outputs.add(*chart, "--output", options.output, ".html or .png")->required();
  CLI::App* const data = command("chart-data", "the figures of these charts as JSON");
  outputs.add(*data, "--output", options.output, "JSON (default: to the standard output)");
  for (CLI::App* const app_of : {chart, data})
    app_of->add_option("--recipe", options.filter.recipe, kRecipe)->required();
  return {{listed, list},
          {table, save_csv},
          {aqdef, save_aqdef},
          {chart, draw},
          {data, print_chart_data}};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "The history of runs: lists them, draws control charts, writes CSV and AQDEF, runs them "
      "again");
  app.require_subcommand(1);
  Options options;
  Outputs outputs;
  std::vector<Command> commands = add_listing(app, options, outputs);
  for (Command& command : add_keeping(app, options))
    commands.push_back(std::move(command));
  ReplayOptions again;
  commands.emplace_back(add_replay(app, again), [&again](const Options&) { return replay(again); });
  const auto run = [&] {
    for (const auto& [command, work] : commands) {
      if (command->parsed()) return work(options);
    }
    return scan_cell_common::kUnusable;
  };
  return scan_cell_common::tool_main("history", app, argc, argv, run, scan_cell_common::kRefused,
                                     outputs);
}
