// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe_services.h"

#include <fmt/format.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>

#include "approval/approval.h"
#include "clock/utc_time.h"
#include "history/figure_text.h"
#include "history/history.h"
#include "recipe/proof.h"
#include "recipe/recipe.h"
#include "recipe/recipe_edits.h"
#include "record/work_records.h"
#include "run/recipe_picture.h"
#include "run/run_recipe.h"
#include "scan_cell/ros/scan_goal.h"
#include "scan_cell_common/errors/errors.h"
#include "service_answer.h"
#include "tool_path_stretcher/ros/conversions.h"
#include "view/judged_figures.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_msgs::RecipeState;
using scan_cell_msgs::RunSummary;

RecipeState state_of(const fs::path& recipes, const std::string& name) {
  RecipeState state;
  state.name = name;
  try {
    const Recipe recipe = load_recipe(find_recipe(recipes, name));
    const fs::path picture = recipe.folder / kPictureFile;
    if (fs::exists(picture)) state.picture = fs::absolute(picture).string();
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

unsigned char state_of(RunState state) {
  if (state == RunState::kUnusable) return RunSummary::UNUSABLE;
  return state == RunState::kAccepted ? RunSummary::ACCEPTED : RunSummary::REFUSED;
}

RunSummary summary_of(const fs::path& folder, const RunRecord& record) {
  RunSummary summary;
  summary.id = record.id;
  summary.recipe = record.recipe_name;
  summary.started = record.started;
  summary.state = state_of(record.state);
  summary.reason = record.reason;
  summary.message = record.message;
  const std::vector<Approval> said = approvals_of(folder);
  if (said.empty()) return summary;
  summary.decision = said.back().approved ? RunSummary::APPROVED_BY : RunSummary::REFUSED_BY;
  summary.decided_by = said.back().name;
  summary.decision_note = said.back().note;
  return summary;
}

/// The cleaning settings; empty also if the recipe no longer exists: its run can still be shown.
std::string cleaning_settings(const fs::path& recipes, const std::string& name) {
  try {
    return cleaning_of(load_recipe(find_recipe(recipes, name)));
  } catch (const scan_cell_common::Error&) {
    return "";
  }
}

}  // namespace

RecipeServices::RecipeServices(ros::NodeHandle node, const RecipeParameters& parameters)
    : parameters_(parameters),
      display_(node),
      list_(node.advertiseService("list", &RecipeServices::list, this)),
      edit_(node.advertiseService("edit", &RecipeServices::edit, this)),
      program_(node.advertiseService("program", &RecipeServices::program, this)),
      runs_(node.advertiseService("runs", &RecipeServices::runs, this)),
      describe_(node.advertiseService("describe", &RecipeServices::describe, this)),
      approve_(node.advertiseService("approve", &RecipeServices::approve, this)) {
  node.setCallbackQueue(&preview_queue_);
  preview_ = node.advertiseService("preview", &RecipeServices::preview, this);
  preview_spinner_.start();
}

fs::path RecipeServices::folder_of(const std::string& run) const {
  check_name(run);
  return fs::absolute(parameters_.runs) / run;
}

bool RecipeServices::list(scan_cell_msgs::ListRecipes::Request&,
                          scan_cell_msgs::ListRecipes::Response& response) {
  try {
    for (const std::string& name : recipe_names_so_far(parameters_.recipes))
      response.recipes.push_back(state_of(parameters_.recipes, name));
    return true;
  } catch (const scan_cell_common::Error& error) {
    ROS_ERROR_THROTTLE(10, "%s", error.what());  // seats ask again and again
    return false;
  }
}

bool RecipeServices::edit(scan_cell_msgs::EditRecipe::Request& request,
                          scan_cell_msgs::EditRecipe::Response& response) {
  using Request = scan_cell_msgs::EditRecipe::Request;
  return answer(response, [&] {
    const Recipe recipe = load_recipe(find_recipe(parameters_.recipes, request.recipe));
    if (request.what == Request::EDITS) return set_edits(recipe, request.edits);
    if (request.what == Request::STAGES) return set_stages(recipe, request.stages);
    throw scan_cell_common::InvalidParameter("what", fmt::format("{}", request.what),
                                             "give EDITS or STAGES");
  });
}

bool RecipeServices::program(scan_cell_msgs::EditProgram::Request& request,
                             scan_cell_msgs::EditProgram::Response& response) {
  return answer(response, [&] {
    const Recipe recipe = load_recipe(find_recipe(parameters_.recipes, request.recipe));
    if (request.set != 0) {
      scan_cell::ScanProgram program{request.frame, {}};
      for (std::size_t i = 0; i < request.passes.size(); ++i)
        program.passes.push_back(
            scan_cell::pass_from(request.passes[i], fmt::format("pass {}", i + 1)));
      set_program(recipe, program);
    }
    if (recipe.program.empty()) return;
    const auto goal = scan_cell::scan_goal(
        scan_cell::load_scan_program((recipe.folder / recipe.program).string()), "");
    response.frame = goal.frame;
    response.passes = goal.passes;
  });
}

bool RecipeServices::runs(scan_cell_msgs::ListRuns::Request& request,
                          scan_cell_msgs::ListRuns::Response& response) {
  return answer(response, [&] {
    HistoryFilter filter;
    if (request.limit > 0) filter.limit = request.limit;
    if (!request.recipe.empty()) filter.recipe = request.recipe;
    for (const HistoryRun& run : History(parameters_.runs).query(filter))
      response.runs.push_back(summary_of(folder_of(run.record.id), run.record));
    std::reverse(response.runs.begin(), response.runs.end());
  });
}

bool RecipeServices::describe(scan_cell_msgs::DescribeRun::Request& request,
                              scan_cell_msgs::DescribeRun::Response& response) {
  return answer(response, [&] {
    const fs::path folder = folder_of(request.run);
    const RunRecord record = load_run(folder);
    response.run = summary_of(folder, record);
    response.folder = folder.string();
    response.recipe = fs::path(record.recipe_folder).filename().string();
    response.cleaning = cleaning_settings(parameters_.recipes, response.recipe);
    if (fs::exists(folder / kReportPage)) response.report = (folder / kReportPage).string();
    for (const JudgedFigure& figure : judged_figures(folder, record, texts_of(record.figures))) {
      response.figure_names.push_back(figure.name);
      response.figure_values.push_back(figure.value);
      response.figure_limits.push_back(figure.limit);
    }
    const RunView view = view_of(folder);
    response.frame = view.frame;
    response.waypoints_concerned = view.concerned;
    std_msgs::Header header;
    header.frame_id = view.frame;
    response.path = tool_path_stretcher::to_message(view.adapted, header);
    response.expected_errors = view.expected;
    for (const Eigen::Vector3d& position : view.positions)
      response.waypoint_positions.push_back(tf2::toMsg(position));
    response.dry_runs = static_cast<std::uint32_t>(work_records(folder, true).size());
    const std::vector<WorkRecord> works = work_records(folder, false);
    response.works = static_cast<std::uint32_t>(works.size());
    if (!works.empty()) {
      response.last_finished = static_cast<unsigned char>(works.back().finished);
      response.last_passed = static_cast<std::uint32_t>(works.back().passed);
    }
    display_.show(folder, view);
  });
}

bool RecipeServices::preview(scan_cell_msgs::PreviewRun::Request& request,
                             scan_cell_msgs::PreviewRun::Response& response) {
  return answer(response, [&] {
    const fs::path folder = folder_of(request.run);
    preview_work(load_recipe(folder / "inputs"), folder, request.dry_run != 0, parameters_.timeout,
                 [] { return !ros::ok(); });
  });
}

bool RecipeServices::approve(scan_cell_msgs::ApproveRun::Request& request,
                             scan_cell_msgs::ApproveRun::Response& response) {
  return answer(response, [&] {
    add_approval(folder_of(request.run),
                 {request.approved != 0, request.name, request.note, utc_now()});
  });
}

}  // namespace part_recipes
