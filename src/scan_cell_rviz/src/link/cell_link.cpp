// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/cell_link.h"

#include <fmt/format.h>
#include <scan_cell_msgs/ApproveRun.h>
#include <scan_cell_msgs/PreviewRun.h>

#include <QMetaType>
#include <utility>

#include "link/first_recipe.h"
#include "scan_cell/ros/service_call.h"
#include "signs/signs.h"

namespace scan_cell_rviz {

using scan_cell_msgs::RunRecipeGoal;
using scan_cell_msgs::RunRecipeResult;

namespace {

constexpr double kLook = 0.25;          // [s] between two checks; chosen
constexpr int kLooksAList = 4;          // without a list: every second; chosen
constexpr int kLooksAPresence = 4;      // every second; chosen
constexpr int kLooksACalibration = 40;  // every 10 s; chosen
constexpr double kCallTimeout = 5;      // [s] for an answer; chosen
constexpr double kPreviewTimeout = 20;  // [s] a tool is started, and it waits for the cell; chosen
constexpr double kTaken = 10;           // [s] for a goal to be accepted if nobody else has the cell
constexpr double kGone = 3;             // [s] without the server until its goal is given up
constexpr double kCameraSilent = 5;     // [s] diagnostics come every second

void register_types() {
  qRegisterMetaType<Device>("scan_cell_rviz::Device");
  qRegisterMetaType<Sign>("scan_cell_rviz::Sign");
  qRegisterMetaType<Busy>("scan_cell_rviz::Busy");
  qRegisterMetaType<Doing>("scan_cell_rviz::Doing");
  qRegisterMetaType<std::vector<scan_cell_msgs::RecipeState>>(
      "std::vector<scan_cell_msgs::RecipeState>");
  qRegisterMetaType<std::vector<scan_cell_msgs::RunSummary>>(
      "std::vector<scan_cell_msgs::RunSummary>");
  qRegisterMetaType<scan_cell_msgs::DescribeRunResponse>("scan_cell_msgs::DescribeRunResponse");
  qRegisterMetaType<RunRecipeResult>("scan_cell_msgs::RunRecipeResult");
  qRegisterMetaType<sensor_msgs::PointCloud2ConstPtr>("sensor_msgs::PointCloud2ConstPtr");
  qRegisterMetaType<scan_cell_msgs::WorkPreviewConstPtr>("scan_cell_msgs::WorkPreviewConstPtr");
  qRegisterMetaType<RobotLimits>("scan_cell_rviz::RobotLimits");
}

Doing doing_of(const RunRecipeGoal& goal) {
  if (goal.run.empty()) return Doing::kRun;
  if (!goal.path_edits.empty()) return Doing::kEdit;
  return goal.work == RunRecipeGoal::DRY_RUN ? Doing::kDryRun : Doing::kWork;
}

RunRecipeResult result_without_run(const std::string& message) {
  RunRecipeResult result;
  result.message = message;
  return result;
}

}  // namespace

CellLink::CellLink(const NodeNames& names) : names_(names), spinner_(1, &queue_) {
  register_types();
  node_.setCallbackQueue(&queue_);
  client_ = std::make_unique<Client>(node_, names_.recipes + "/run");
  robot_ = node_.subscribe<scan_cell_msgs::RobotStatus>(
      names_.robot + "/status", 10,
      [this](const auto& robot) { hear(Device::kRobot, sign_of(*robot)); });
  trigger_ = node_.subscribe<scan_cell_msgs::TriggerState>(
      names_.trigger + "/state", 10,
      [this](const auto& trigger) { hear(Device::kLaser, sign_of(*trigger)); });
  cell_ = node_.subscribe<scan_cell_msgs::CellState>(
      names_.cell + "/state", 10,
      [this](const auto& cell) { hear(Device::kCell, sign_of(*cell)); });
  diagnostics_ = node_.subscribe("/diagnostics", 10, &CellLink::on_diagnostics, this);
  actions_ = std::make_unique<CellActions>(node_, names_, [this] { tell_busy(); });
  raw_ = node_.subscribe<sensor_msgs::PointCloud2>(
      names_.recipes + "/raw", 1, [this](const auto& raw) { Q_EMIT rawCame(raw); });
  preview_ = node_.subscribe<scan_cell_msgs::WorkPreview>(
      names_.cell + "/work_preview", 10,
      [this](const auto& preview) { Q_EMIT previewed(preview); });
  feedback_.push_back(node_.subscribe<scan_cell_msgs::ScanActionFeedback>(
      names_.cell + "/scan/feedback", 10, [this](const auto& news) {
        const auto& scan = news->feedback;
        Q_EMIT progressed(tr("%1, %2 frames, %3 points")
                              .arg(QString::fromStdString(scan.step_name))
                              .arg(scan.frames)
                              .arg(scan.points),
                          scan.progress);
      }));
  feedback_.push_back(node_.subscribe<scan_cell_msgs::WorkActionFeedback>(
      names_.cell + "/work/feedback", 10, [this](const auto& news) {
        const auto& work = news->feedback;
        const QString doing =
            (is_dry_run() ? tr("dry run: %1") : "%1").arg(QString::fromStdString(work.doing));
        Q_EMIT progressed(tr("%1, %2 waypoints passed").arg(doing).arg(work.passed), work.progress);
      }));
  timer_ = node_.createWallTimer(ros::WallDuration(kLook), [this](const auto&) { look(); });
}

CellLink::~CellLink() {
  spinner_.stop();
  presence_worker_.reset();
  preview_worker_.reset();
  worker_.reset();  // while the receivers of its signals still exist
}

void CellLink::start() {
  spinner_.start();
}

Busy CellLink::busy() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ours_) return Busy::kOurs;
  return actions_->any() ? Busy::kOthers : Busy::kFree;
}

/// Runs a task in a worker; an exception becomes failed().
template <class Task>
void CellLink::ask(Worker& worker, Task task) {
  worker.add(task, [this](const QString& message) { Q_EMIT failed(message); });
}

void CellLink::list_recipes() {
  worker_->add([this] {
    try {
      const auto answer =
          scan_cell::ask<scan_cell_msgs::ListRecipes>(names_.recipes + "/list", {}, kCallTimeout);
      listed_ = true;
      Q_EMIT recipesListed(answer.recipes);
      if (answer.recipes.empty()) Q_EMIT recipesMissed(words_of_no_recipe());
    } catch (const std::exception& error) {
      Q_EMIT recipesMissed(QString::fromStdString(error.what()));
    }
  });
}

/// What a person can do if there is no recipe.
QString CellLink::words_of_no_recipe() const {
  std::string folder;
  ros::param::get(names_.recipes + "/recipes", folder);
  return tr("There is no recipe in %1 yet. This command makes that of the demo's part; then press "
            "Refresh. Step 4 of the README says what it needs.")
             .arg(QString::fromStdString(folder)) +
         "\n\n" + QString::fromStdString(first_recipe_command(folder));
}

void CellLink::list_runs() {
  ask(*worker_, [this] {
    scan_cell_msgs::ListRuns::Request request;
    request.limit = 50;
    Q_EMIT runsListed(
        scan_cell::call<scan_cell_msgs::ListRuns>(names_.recipes + "/runs", request, kCallTimeout)
            .runs);
  });
}

void CellLink::describe(const QString& run) {
  ask(*worker_, [this, run] {
    scan_cell_msgs::DescribeRun::Request request;
    request.run = run.toStdString();
    Q_EMIT described(scan_cell::call<scan_cell_msgs::DescribeRun>(names_.recipes + "/describe",
                                                                  request, kCallTimeout));
  });
}

void CellLink::decide(const QString& run, bool approved, const QString& name, const QString& note) {
  ask(*worker_, [=] {
    scan_cell_msgs::ApproveRun::Request request;
    request.run = run.toStdString();
    request.approved = static_cast<unsigned char>(approved);
    request.name = name.toStdString();
    request.note = note.toStdString();
    scan_cell::call<scan_cell_msgs::ApproveRun>(names_.recipes + "/approve", request, kCallTimeout);
    Q_EMIT decided(run);
  });
}

void CellLink::edit(const QString& recipe, const QString& edits) {
  scan_cell_msgs::EditRecipeRequest request;
  request.what = scan_cell_msgs::EditRecipeRequest::EDITS;
  request.edits = edits.toStdString();
  change(recipe, request);
}

void CellLink::set_stages(const QString& recipe, const QString& stages) {
  scan_cell_msgs::EditRecipeRequest request;
  request.what = scan_cell_msgs::EditRecipeRequest::STAGES;
  request.stages = stages.toStdString();
  change(recipe, request);
}

void CellLink::change(const QString& recipe, scan_cell_msgs::EditRecipeRequest request) {
  request.recipe = recipe.toStdString();
  ask(*worker_, [this, recipe, request] {
    scan_cell::call<scan_cell_msgs::EditRecipe>(names_.recipes + "/edit", request, kCallTimeout);
    Q_EMIT edited(recipe);
  });
}

void CellLink::preview(const QString& run, bool dry) {
  ask(*preview_worker_, [=] {
    scan_cell_msgs::PreviewRun::Request request;
    request.run = run.toStdString();
    request.dry_run = static_cast<unsigned char>(dry);
    scan_cell::call<scan_cell_msgs::PreviewRun>(names_.recipes + "/preview", request,
                                                kPreviewTimeout);
  });
}

void CellLink::run(const QString& recipe, const QString& note) {
  RunRecipeGoal goal;
  goal.recipe = recipe.toStdString();
  goal.note = note.toStdString();
  send(goal);
}

void CellLink::work(const QString& run, bool dry) {
  RunRecipeGoal goal;
  goal.run = run.toStdString();
  goal.work = dry ? RunRecipeGoal::DRY_RUN : RunRecipeGoal::WORK;
  send(goal);
}

void CellLink::edit_path(const QString& run, const QString& edits, const QString& note) {
  RunRecipeGoal goal;
  goal.run = run.toStdString();
  goal.path_edits = edits.toStdString();
  goal.note = note.toStdString();
  send(goal);
}

void CellLink::send(const RunRecipeGoal& goal) {
  if (busy() != Busy::kFree) {
    Q_EMIT failed(tr("The cell is busy: wait until it is free."));
    return;
  }
  if (!client_->is_connected()) {
    Q_EMIT failed(tr("%1 is not running: start the cell with recipes:=FOLDER.")
                      .arg(QString::fromStdString(names_.recipes)));
    return;
  }
  int number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ours_ = true;
    doing_ = doing_of(goal);
    sent_ = ros::WallTime::now();
    number = ++goal_;
  }
  tell_busy();
  const auto is_ours = [this, number] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ours_ && number == goal_;
  };
  client_->send(
      goal,
      [this, is_ours](const auto& end) {
        if (!is_ours()) return;
        this->end(end.result ? *end.result
                             : result_without_run("the node was started again while it worked: " +
                                                  names_.recipes));
      },
      [this](const auto& news) { Q_EMIT progressed(QString::fromStdString(news.stage), -1); });
}

void CellLink::stop() {
  client_->cancel_all();
  actions_->stop(busy() == Busy::kOurs);
}

void CellLink::end(const RunRecipeResult& result) {
  Doing was = Doing::kRun;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!ours_) return;
    ours_ = false;
    was = doing_;
  }
  actions_->forget();  // of this goal; other goals are published again
  tell_busy();
  Q_EMIT runEnded(result, was);
}

/// Whether this seat's goal is a dry run.
bool CellLink::is_dry_run() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ours_ && doing_ == Doing::kDryRun;
}

void CellLink::tell_busy() {
  const Busy now = busy();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::exchange(told_, now) == now) return;
  }
  Q_EMIT busyChanged(now);
}

void CellLink::look() {
  if (looks_ % kLooksAPresence == 0) look_for_nodes();
  show_presence(Device::kRobot, robot_);
  show_presence(Device::kLaser, trigger_);
  show_presence(Device::kCell, cell_);
  if ((ros::WallTime::now() - camera_seen_).toSec() > kCameraSilent)
    show(Device::kCamera, {Level::kGone, names_.camera + " reports nothing on /diagnostics"});
  if (is_missed(cell_)) actions_->forget_cell();
  actions_->look();
  if (is_missed(actions_->of_recipes())) {
    actions_->forget_recipes();
    listed_ = false;
    if (!std::exchange(recipes_missed_, true))
      Q_EMIT recipesMissed(tr("%1 is not running: start the cell with recipes:=FOLDER. The folder "
                              "need not be there: this command makes it, with the recipe of the "
                              "demo's part. Step 4 of the README says what it needs.")
                               .arg(QString::fromStdString(names_.recipes)) +
                           "\n\n" + QString::fromStdString(first_recipe_command({})));
  } else {
    recipes_missed_ = false;
    if (!listed_ && looks_ % kLooksAList == 0) list_recipes();
  }
  if (looks_++ % kLooksACalibration == 0) {
    worker_->add([this] { look_at_calibration(); });
    ask(*worker_, [this] { look_at_robot(); });
  }
  look_at_run();
}

/// Gives up a goal whose server is gone or does not accept it. The cell itself ends what the goal's
/// tool began there.
void CellLink::look_at_run() {
  const ros::WallTime now = ros::WallTime::now();
  const bool connected = client_->is_connected();
  double gone = 0, waiting = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (connected) unseen_ = ros::WallTime();
    if (!connected && unseen_.isZero()) unseen_ = now;
    if (!ours_) return;
    gone = connected ? 0 : (now - unseen_).toSec();
    waiting = (now - sent_).toSec();
  }
  if (gone > kGone) {
    end(result_without_run(names_.recipes + " is gone: look at its log and start it again"));
  } else if (connected && !client_->is_taken() && waiting > kTaken) {
    client_->cancel();
    end(result_without_run(
        fmt::format("{} did not accept it within {:g} s", names_.recipes, kTaken)));
  }
}

}  // namespace scan_cell_rviz
