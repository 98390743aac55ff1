// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/DescribeRun.h>
#include <scan_cell_msgs/WorkPreview.h>

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "preview/joint_turn.h"

namespace scan_cell_rviz {

/// The robot follows the path of an approved run: first a preview, then a dry run, then with the
/// tool on.
class WorkPage : public QWidget {
  Q_OBJECT

 public:
  explicit WorkPage(QWidget* parent = nullptr);

  void show_run(const scan_cell_msgs::DescribeRunResponse& run);
  void show_end(const QString& message);  ///< how the work ended
  void set_free(bool free);               ///< whether the robot may begin
  /// Shows a preview of the run in view; others are not shown.
  void show_preview(const scan_cell_msgs::WorkPreviewConstPtr& preview);
  void set_limits(const scan_cell_rviz::RobotLimits& limits);  ///< of the robot's joints
  void give_up_preview();                                      ///< the requested one will not come

 Q_SIGNALS:
  void workWanted(QString run, bool dry);
  void previewWanted(QString run, bool dry);
  void poseChosen(int pose);                                      ///< of the preview
  void placeChosen(double x, double y, double z, QString frame);  ///< [m] of a fault

 private:
  static QString words_of_works(const scan_cell_msgs::DescribeRunResponse& run);
  bool may_work_again();
  QLayout* preview_box();
  void ask_for_preview(bool dry);
  void forget_preview();
  void show_pose(int pose);
  void show_turn();
  void show_fault(int row);
  void update_buttons();

  scan_cell_msgs::RunSummary run_;
  unsigned works_ = 0;  // how often its path was run with the tool on
  QLabel* part_;
  QLabel* end_;
  QPushButton* preview_;
  QPushButton* preview_dry_;
  QSlider* pose_;
  QLabel* at_pose_;
  QLabel* turn_;
  QListWidget* faults_;
  QPushButton* dry_;
  QPushButton* work_;
  scan_cell_msgs::WorkPreviewConstPtr came_;   // the last one, of any run
  scan_cell_msgs::WorkPreviewConstPtr shown_;  // of the run in view
  RobotLimits limits_;
  bool asked_ = false;  // a preview is requested and has neither come nor failed
  bool free_ = false;
};

}  // namespace scan_cell_rviz
