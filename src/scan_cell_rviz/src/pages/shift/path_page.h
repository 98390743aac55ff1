// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/DescribeRunResponse.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableView>
#include <QWidget>
#include <array>
#include <map>
#include <vector>

#include "path/path_table.h"

namespace scan_cell_rviz {

/// Edits the adapted path of the run in view by hand: a table of its waypoints, edits of those
/// chosen there or in the view, and a list of the edits. It is saved as a new run.
class PathPage : public QWidget {
  Q_OBJECT

 public:
  PathPage(PathSession& session, QWidget* parent = nullptr);

  void show_run(const scan_cell_msgs::DescribeRunResponse& run);
  void set_free(bool free);               ///< whether a new run may be made
  void show_end(const QString& message);  ///< of saving, or why it failed

 Q_SIGNALS:
  void saveWanted(QString run, QString edits, QString note);      ///< YAML
  void toolWanted(QString name);                                  ///< name of an rviz tool
  void placeChosen(double x, double y, double z, QString frame);  ///< [m]

 private:
  void lay_out();
  QLayout* move_row();
  QLayout* turn_row();
  QLayout* value_row();
  QDoubleSpinBox* number_box(const char* name, double range, int decimals, const QString& unit,
                             const QString& meaning);
  tool_paths::EditFrame frame() const;
  void move();
  void turn();
  void set_value();
  void take_selection();
  void show_selection();
  void show_session();
  void update_buttons();

  PathSession& session_;
  QString run_;
  std::map<QString, std::vector<tool_paths::PathEdit>> kept_;  // of other runs
  bool free_ = false;
  bool showing_ = false;  // the table is being updated from the session
  QLabel* count_;
  PathTable* table_;
  QTableView* waypoints_;
  QComboBox* frame_;
  std::array<QDoubleSpinBox*, 3> by_;
  QPushButton* move_;
  QComboBox* axis_;
  QDoubleSpinBox* angle_;
  QPushButton* turn_;
  QComboBox* name_;
  QDoubleSpinBox* value_;
  QPushButton* set_;
  QPushButton* add_;
  QPushButton* delete_;
  QListWidget* edits_;
  QPushButton* undo_;
  QPushButton* redo_;
  QPushButton* drop_;
  QLineEdit* note_;
  QPushButton* save_;
  QLabel* end_;
};

}  // namespace scan_cell_rviz
