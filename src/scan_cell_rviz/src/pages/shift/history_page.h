// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/RunSummary.h>

#include <QTableWidget>
#include <QWidget>
#include <vector>

namespace scan_cell_rviz {

/// The last runs; opens the chosen one.
class HistoryPage : public QWidget {
  Q_OBJECT

 public:
  explicit HistoryPage(QWidget* parent = nullptr);

  void show_runs(const std::vector<scan_cell_msgs::RunSummary>& runs);

 Q_SIGNALS:
  void refreshWanted();
  void runChosen(QString run);

 private:
  QTableWidget* runs_;
};

}  // namespace scan_cell_rviz
