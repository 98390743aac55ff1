// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run_server.h"

#include "approval/approval.h"
#include "history/remember.h"
#include "recipe/recipe.h"
#include "run/again.h"
#include "run/prove.h"
#include "run/run_folder.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/load_parameters.h"

namespace part_recipes {
namespace {

using scan_cell_msgs::RunRecipeFeedback;
using scan_cell_msgs::RunRecipeGoal;
using scan_cell_msgs::RunRecipeResult;

unsigned char outcome_of(RunState state) {
  switch (state) {
    case RunState::kAccepted:
      return RunRecipeResult::ACCEPTED;
    case RunState::kRefused:
      return RunRecipeResult::REFUSED;
    case RunState::kUnusable:
      break;
  }
  return RunRecipeResult::UNUSABLE;
}

/// @throw scan_cell_common::InvalidParameter if it is none of the constants
Work work_of(const RunRecipeGoal& goal) {
  switch (goal.work) {
    case RunRecipeGoal::NO_WORK:
      return Work::kNone;
    case RunRecipeGoal::DRY_RUN:
      return Work::kDry;
    case RunRecipeGoal::WORK:
      return Work::kReal;
    default:
      throw scan_cell_common::InvalidParameter("work", std::to_string(goal.work),
                                               "give NO_WORK, DRY_RUN or WORK");
  }
}

RunRecipeResult result_of(const EndedRun& ended) {
  RunRecipeResult result;
  result.warning = ended.warning;
  result.outcome = outcome_of(ended.record.state);
  result.reason = ended.record.reason;
  result.message = ended.record.message;
  result.folder = ended.folder.string();
  result.worked = static_cast<unsigned char>(ended.worked);
  result.work_message = ended.work_message;
  return result;
}

}  // namespace

RunServer::RunServer(const ros::NodeHandle& private_node)
    : node_(private_node),
      parameters_(scan_cell_common::load_parameters<RecipeParameters>(private_node)),
      services_(node_, parameters_),
      design_(node_, parameters_),
      server_(
          node_, "run",
          [this](const scan_cell_msgs::RunRecipeGoalConstPtr& goal) { execute(goal); }, false) {
  server_.start();
}

RunRequest RunServer::request_of(const Goal& goal) {
  RunRequest request;
  request.runs = parameters_.runs;
  if (!goal.scan.empty()) request.scan = goal.scan;
  if (!goal.scan_units.empty()) request.scan_units = goal.scan_units;
  request.timeout = parameters_.timeout;
  request.note = goal.note;
  request.bag = goal.bag != 0;
  request.work = work_of(goal);
  // The server also asks for it when another goal came: that one waits.
  request.stop = [this] {
    return !ros::ok() || (server_.isPreemptRequested() && !server_.isNewGoalAvailable());
  };
  return request;
}

void RunServer::tell(const std::string& stage) {
  RunRecipeFeedback feedback;
  feedback.stage = stage;
  server_.publishFeedback(feedback);
}

RunServer::Result RunServer::run(const Goal& goal) {
  if (!goal.path_edits.empty()) return edit_old(goal);
  if (!goal.run.empty()) return work_old(goal);
  const StageBegins begins = [this](const std::string& stage) { tell(stage); };
  const Recipe recipe = load_recipe(find_recipe(parameters_.recipes, goal.recipe));
  const RunRequest request = request_of(goal);
  EndedRun ended =
      goal.prove != 0 ? prove(recipe, request, begins) : run_recipe(recipe, request, begins);
  remember(ended);
  if (goal.prove == 0) work(recipe, request, begins, ended);
  Result result = result_of(ended);
  result.proven = goal.prove;
  return result;
}

/// Works the part of an earlier run.
RunServer::Result RunServer::work_old(const Goal& goal) {
  check_name(goal.run);
  if (goal.work == Goal::NO_WORK)
    throw scan_cell_common::InvalidParameter(
        "work", "NO_WORK", "give DRY_RUN or WORK for an existing run, or path_edits");
  EndedRun ended;
  ended.folder = std::filesystem::path(parameters_.runs) / goal.run;
  ended.record = load_run(ended.folder);
  check_files(ended.folder, ended.record);
  if (ended.record.state != RunState::kAccepted)
    throw scan_cell_common::Refused("run " + goal.run, to_string(ended.record.state),
                                    "only an accepted path can be worked");
  check_not_refused(ended.folder);
  work(
      load_recipe(ended.folder / "inputs"), request_of(goal),
      [this](const std::string& stage) { tell(stage); }, ended);
  return result_of(ended);
}

/// Makes a new run from the files of an earlier one.
RunServer::Result RunServer::edit_old(const Goal& goal) {
  check_name(goal.run);
  if (goal.work != Goal::NO_WORK)
    throw scan_cell_common::InvalidParameter("work", std::to_string(goal.work),
                                             "look at the edited path before it is worked");
  const auto edits = tool_paths::parse_path_edits(goal.path_edits, "path_edits");
  EndedRun ended = run_edited(
      std::filesystem::path(parameters_.runs) / goal.run, edits, parameters_.runs, goal.note,
      [this](const std::string& stage) { tell(stage); }, request_of(goal).stop);
  remember(ended);
  return result_of(ended);
}

void RunServer::execute(const scan_cell_msgs::RunRecipeGoalConstPtr& goal) {
  Result result;
  try {
    result = run(*goal);
  } catch (const std::exception& error) {  // of a file system, too: no goal may end the node
    result.outcome = Result::NONE;
    result.message = error.what();
  }
  ROS_INFO("recipe '%s': %s", goal->recipe.c_str(), result.message.c_str());
  if (result.outcome == Result::ACCEPTED) {
    server_.setSucceeded(result, result.message);
  } else if (server_.isPreemptRequested() && !server_.isNewGoalAvailable()) {
    server_.setPreempted(result, result.message);
  } else {
    server_.setAborted(result, result.message);
  }
}

}  // namespace part_recipes
