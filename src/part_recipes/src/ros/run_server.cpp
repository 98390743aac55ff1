// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run_server.h"

#include <map>

#include "history/remember.h"
#include "recipe/proof.h"
#include "run/prove.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/load_parameters.h"

namespace part_recipes {
namespace {

using scan_cell_msgs::RecipeState;
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

RecipeState state_of(const std::filesystem::path& recipes, const std::string& name) {
  RecipeState state;
  state.name = name;
  try {
    const Recipe recipe = load_recipe(find_recipe(recipes, name));
    const Proof proof = load_proof(recipe);
    state.time = proof.time;
    check_unchanged(recipe, proof, hashes_of(recipe));
    state.state = proof.proven ? RecipeState::PROVEN : RecipeState::MADE;
  } catch (const scan_cell_common::Error& error) {
    state.state = RecipeState::OUT_OF_DATE;
    state.message = error.what();
  }
  return state;
}

}  // namespace

RunServer::RunServer(const ros::NodeHandle& private_node)
    : node_(private_node),
      parameters_(scan_cell_common::load_parameters<RecipeParameters>(private_node)),
      list_(node_.advertiseService("list", &RunServer::list, this)),
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
  // The server asks for it, too, where another goal came: that one waits.
  request.stop = [this] {
    return !ros::ok() || (server_.isPreemptRequested() && !server_.isNewGoalAvailable());
  };
  return request;
}

RunServer::Result RunServer::run(const Goal& goal) {
  const StageBegins begins = [this](const std::string& stage) {
    RunRecipeFeedback feedback;
    feedback.stage = stage;
    server_.publishFeedback(feedback);
  };
  const Recipe recipe = load_recipe(find_recipe(parameters_.recipes, goal.recipe));
  const RunRequest request = request_of(goal);
  EndedRun ended =
      goal.prove != 0 ? prove(recipe, request, begins) : run_recipe(recipe, request, begins);
  remember(ended);
  if (goal.prove == 0) work(recipe, request, begins, ended);
  Result result;
  result.warning = ended.warning;
  result.outcome = outcome_of(ended.record.state);
  result.reason = ended.record.reason;
  result.message = ended.record.message;
  result.folder = ended.folder.string();
  result.worked = static_cast<unsigned char>(ended.worked);
  result.work_message = ended.work_message;
  result.proven = goal.prove;
  return result;
}

void RunServer::execute(const scan_cell_msgs::RunRecipeGoalConstPtr& goal) {
  Result result;
  try {
    result = run(*goal);
  } catch (const scan_cell_common::Error& error) {
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

bool RunServer::list(scan_cell_msgs::ListRecipes::Request&,
                     scan_cell_msgs::ListRecipes::Response& response) {
  try {
    for (const std::string& name : recipe_names(parameters_.recipes))
      response.recipes.push_back(state_of(parameters_.recipes, name));
    return true;
  } catch (const scan_cell_common::Error& error) {
    ROS_ERROR("%s", error.what());
    return false;
  }
}

}  // namespace part_recipes
