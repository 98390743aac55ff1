// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/RunSummary.h>

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace scan_cell_rviz {

/// The robot follows the path of an approved run: dry first, then with the tool on.
class WorkPage : public QWidget {
  Q_OBJECT

 public:
  explicit WorkPage(QWidget* parent = nullptr);

  void show_run(const scan_cell_msgs::RunSummary& run);
  void show_end(const QString& message);  ///< how the work ended
  void set_free(bool free);               ///< whether the robot may begin

 Q_SIGNALS:
  void workWanted(QString run, bool dry);

 private:
  void update_buttons();

  scan_cell_msgs::RunSummary run_;
  QLabel* part_;
  QLabel* end_;
  QPushButton* dry_;
  QPushButton* work_;
  bool free_ = false;
};

}  // namespace scan_cell_rviz
