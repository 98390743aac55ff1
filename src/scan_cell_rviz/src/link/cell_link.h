// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <scan_cell_msgs/CellState.h>
#include <scan_cell_msgs/DescribeRun.h>
#include <scan_cell_msgs/EditRecipe.h>
#include <scan_cell_msgs/ListRecipes.h>
#include <scan_cell_msgs/ListRuns.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/RunRecipeAction.h>
#include <scan_cell_msgs/ScanAction.h>
#include <scan_cell_msgs/TriggerState.h>
#include <scan_cell_msgs/WorkAction.h>
#include <scan_cell_msgs/WorkPreview.h>
#include <sensor_msgs/PointCloud2.h>

#include <QObject>
#include <QString>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "link/cell_actions.h"
#include "link/node_names.h"
#include "link/worker.h"
#include "preview/joint_turn.h"
#include "scan_cell_common/ros/goal_client.h"
#include "signs/sign.h"

namespace scan_cell_rviz {

/// Who has the cell.
enum class Busy { kFree, kOurs, kOthers };

/// What a goal of this seat does.
enum class Doing { kRun, kDryRun, kWork, kEdit };

/// The seat's connection to the cell: it turns a person's actions into goals and calls, and answers
/// into signals. Nothing blocks: topics and actions have their own thread, calls another. Any node
/// may go away and come back.
class CellLink : public QObject {
  Q_OBJECT

 public:
  explicit CellLink(const NodeNames& names);
  ~CellLink() override;

  /// Starts sending signals: connect them before.
  void start();

  Busy busy() const;

  /// Answered by recipesListed or recipesMissed. It is also done whenever their node comes up.
  void list_recipes();

  /// Each is answered by a signal: runsListed, described, decided, or failed.
  void list_runs();
  void describe(const QString& run);
  void decide(const QString& run, bool approved, const QString& name, const QString& note);

  /// Saves edits by hand in a recipe. Answered by edited or failed.
  /// @param edits in YAML
  void edit(const QString& recipe, const QString& edits);

  /// Saves the settings of the cleaning stages in a recipe. Answered by edited or failed.
  /// @param stages in YAML
  void set_stages(const QString& recipe, const QString& stages);

  /// Scans and adapts a part. Ends with runEnded.
  void run(const QString& recipe, const QString& note);

  /// Asks what the robot would do to work the part of a run. Answered by previewed or failed.
  void preview(const QString& run, bool dry);

  /// Works the part of a run. Ends with runEnded.
  void work(const QString& run, bool dry);

  /// Makes a new run from a run and edits of its path. Ends with runEnded.
  /// @param edits in YAML
  void edit_path(const QString& run, const QString& edits, const QString& note);

  /// Cancels what is active, also another seat's goals. What run(), work() or edit_path() began
  /// ends with runEnded.
  void stop();

 Q_SIGNALS:
  void signChanged(scan_cell_rviz::Device device, scan_cell_rviz::Sign sign);
  void busyChanged(scan_cell_rviz::Busy busy);
  void recipesListed(std::vector<scan_cell_msgs::RecipeState> recipes);
  void recipesMissed(QString why);
  void runsListed(std::vector<scan_cell_msgs::RunSummary> runs);
  void described(scan_cell_msgs::DescribeRunResponse run);
  void decided(QString run);
  void edited(QString recipe);
  void rawCame(sensor_msgs::PointCloud2ConstPtr raw);           ///< of the described run
  void previewed(scan_cell_msgs::WorkPreviewConstPtr preview);  ///< also for another seat
  void limitsCame(scan_cell_rviz::RobotLimits limits);          ///< of the robot's joints
  void failed(QString message);
  void progressed(QString doing, double share);  ///< share below 0: unknown
  void runEnded(scan_cell_msgs::RunRecipeResult result, scan_cell_rviz::Doing was);

 private:
  using Client = scan_cell_common::GoalClient<scan_cell_msgs::RunRecipeAction>;
  /// A URDF, and the driver's parameters joint_lower and joint_upper.
  using RobotLimitsGiven = std::tuple<std::string, std::vector<double>, std::vector<double>>;

  QString words_of_no_recipe() const;
  void change(const QString& recipe, scan_cell_msgs::EditRecipeRequest request);
  void send(const scan_cell_msgs::RunRecipeGoal& goal);
  void end(const scan_cell_msgs::RunRecipeResult& result);
  bool is_dry_run() const;
  void tell_busy();
  void look();
  void look_at_run();
  void look_at_calibration();
  void look_at_robot();
  void show(Device device, const Sign& sign);
  void hear(Device device, const Sign& sign);
  void show_presence(Device device, const ros::Subscriber& subscriber);
  void look_for_nodes();
  bool is_missed(const ros::Subscriber& subscriber) const;
  void on_diagnostics(const diagnostic_msgs::DiagnosticArray& diagnostics);
  template <class Task>
  void ask(Worker& worker, Task task);

  const NodeNames names_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::unique_ptr<Client> client_;
  std::unique_ptr<CellActions> actions_;
  std::vector<ros::Subscriber> feedback_;
  ros::Subscriber robot_, trigger_, cell_, diagnostics_, raw_, preview_;
  ros::WallTimer timer_;

  mutable std::mutex mutex_;
  std::array<Sign, kDevices> signs_;
  std::array<std::optional<Sign>, kDevices> heard_;  // last state of each
  std::set<std::string> missed_;                     // topics without a publisher
  Busy told_ = Busy::kFree;
  bool ours_ = false;            // this seat has an active goal
  Doing doing_ = Doing::kRun;    // of this seat's goal
  int goal_ = 0;                 // counts goals, to recognize the late end of an old one
  ros::WallTime sent_, unseen_;  // unseen: when the server went away; zero: it is there
  ros::WallTime camera_seen_;

  int looks_ = 0;
  bool recipes_missed_ = false;      // and reported
  std::atomic<bool> listed_{false};  // the recipes of the present node are listed
  std::unique_ptr<Worker> worker_ = std::make_unique<Worker>();
  RobotLimitsGiven limits_given_;     // as last read; by worker_
  std::atomic<bool> looking_{false};  // for nodes
  std::unique_ptr<Worker> presence_worker_ = std::make_unique<Worker>();
  std::unique_ptr<Worker> preview_worker_ = std::make_unique<Worker>();  // does not delay others
  ros::AsyncSpinner spinner_;
};

}  // namespace scan_cell_rviz
