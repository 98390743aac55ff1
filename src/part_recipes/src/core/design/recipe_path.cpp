// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "design/recipe_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "recipe/new_recipe.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_paths/tool_path_files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::InvalidParameter;

constexpr const char* kWaypointZ = "waypoint_z";
constexpr const char* kPathFile = "path.csv";
constexpr const char* kPicksFile = "picks.csv";
constexpr const char* kLog = "path.log";

std::string command_of(PathWay way) {
  if (way == PathWay::kEdge) return "from-edge";
  return way == PathWay::kSlices ? "from-slices" : "from-picks";
}

PathOption option_of(PathWay way, const std::string& name) {
  const std::vector<PathOption> options = options_of(way);
  const auto found = std::find_if(options.begin(), options.end(),
                                  [&](const PathOption& each) { return each.name == name; });
  if (found != options.end()) return *found;
  throw InvalidParameter(name, "unknown", "see docs/making_a_path.md");
}

/// Only what the option takes may get into the tool's command line.
std::vector<std::string> checked_words(const PathOption& option, const std::string& value) {
  std::istringstream stream(value);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    const bool is_known =
        std::find(option.words.begin(), option.words.end(), word) != option.words.end();
    if (!is_known && !scan_cell_common::parse_number(word))
      throw InvalidParameter(option.name, "'" + word + "'",
                             option.words.empty() ? "give numbers" : "give " + option.range);
    words.push_back(word);
  }
  if (words.empty())
    throw InvalidParameter(option.name, "nothing", "give a value, or leave it out");
  return words;
}

/// Each number of a list is a word of its own.
void add_words(ToolCall& call, PathWay way, const ToolOptions& options) {
  for (const auto& [name, value] : options) {
    const std::vector<std::string> words = checked_words(option_of(way, name), value);
    add_options(call, {{name, words.front()}});
    call.command.insert(call.command.end(), words.begin() + 1, words.end());
  }
}

/// The options, with this side if they name one.
ToolOptions with_side(ToolOptions options, const std::string& waypoint_z) {
  const auto side = options.find(kWaypointZ);
  if (side != options.end()) side->second = waypoint_z;
  return options;
}

/// Saves the picks in the unit of the reference, as the tool needs them.
void save_picks(const fs::path& file, const tool_paths::Points& picks, double metres_per_unit) {
  std::string text = "x,y,z\n";
  for (const Eigen::Vector3d& pick : picks) {
    const Eigen::Vector3d at = pick / metres_per_unit;
    text += fmt::format("{},{},{}\n", at.x(), at.y(), at.z());
  }
  scan_cell_common::save_text(file.string(), text);
}

/// Refuses with what the tool said, THING: VALUE; CURE, after the tool's name.
[[noreturn]] void refuse(const fs::path& log, int exit_code) {
  using scan_cell_common::Refused;
  using scan_cell_common::UnusableInput;
  const std::string said = last_line(log);
  const std::string tool = "path: ";
  const std::string text = said.rfind(tool, 0) == 0 ? said.substr(tool.size()) : said;
  const std::size_t thing = text.find(": "), cure = text.rfind("; ");
  if (thing == std::string::npos || cure == std::string::npos || cure < thing)
    throw UnusableInput("path", fmt::format("{} (exit code {})", text, exit_code),
                        "try it by hand: rosrun part_recipes path");
  const std::string parts[] = {text.substr(0, thing), text.substr(thing + 2, cure - thing - 2),
                               text.substr(cure + 2)};
  if (exit_code == scan_cell_common::kRefused) throw Refused(parts[0], parts[1], parts[2]);
  throw UnusableInput(parts[0], parts[1], parts[2]);
}

/// Everything that the tool printed except its last line, which counts the waypoints.
std::vector<std::string> notes_in(const fs::path& log) {
  std::istringstream lines(scan_cell_common::read_file(log.string()));
  std::vector<std::string> notes;
  for (std::string line; std::getline(lines, line);)
    notes.push_back(line);
  if (!notes.empty()) notes.pop_back();
  return notes;
}

}  // namespace

RecipePath::RecipePath(const Recipe& recipe, PathWay way, const ToolOptions& options,
                       const tool_paths::Points& picks, const Stop& stop)
    : recipe_(recipe), folder_("recipe_path") {
  const std::string reference = fs::absolute(recipe.folder / recipe.reference.file).string();
  ToolCall call{"path",
                "part_recipes",
                {"path", command_of(way), "--reference", reference, "--reference-units",
                 recipe.reference.units, "--output", kPathFile}};
  if (way == PathWay::kPicks) {
    save_picks(folder_.path() / kPicksFile, picks,
               scan_cell_common::metres_per(recipe.reference.units));
    call.command.insert(call.command.end(), {"--picks", kPicksFile});
  }
  add_words(call, way, options);
  const auto side = options.find(kWaypointZ);
  waypoint_z_ = side != options.end() ? side->second : option_of(way, kWaypointZ).value;
  const fs::path log = folder_.path() / kLog;
  const StageRecord record = run_tool(call, folder_.path(), log, stop);
  if (record.exit_code != 0) refuse(log, record.exit_code);
  path_ = tool_paths::load_tool_path(folder_.file(kPathFile));
  notes_ = notes_in(log);
}

Recipe RecipePath::save_as(const fs::path& recipes, const std::string& name) const {
  const auto in_folder = [this](const std::string& file) {
    return file.empty() ? file : (recipe_.folder / file).string();
  };
  NewRecipe made;
  made.name = name;
  made.program = in_folder(recipe_.program);
  made.cleaning = in_folder(recipe_.cleaning);
  made.reference = recipe_.reference;
  made.reference.file = in_folder(recipe_.reference.file);
  made.path.file = folder_.file(kPathFile);
  made.tolerance = recipe_.tolerance;
  made.stretch = recipe_.stretch;
  made.places = recipe_.places;
  made.programs = recipe_.programs;
  for (RobotProgram& program : made.programs)
    program.options = with_side(program.options, waypoint_z_);
  made.work = with_side(recipe_.work, waypoint_z_);
  if (recipe_.check) {
    made.check_program = in_folder(recipe_.check->program);
    made.check_tolerance = recipe_.check->tolerance;
  }
  made.calibration = load_proof(recipe_).calibration;
  return make_recipe(recipes, made);
}

}  // namespace part_recipes
