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

/// The adapted path of the run in view, edited by hand: its waypoints in a table, what is done to
/// those that are chosen there or in the view, and what was done. Saved, it is a run of its own.
class PathPage : public QWidget {
  Q_OBJECT

 public:
  PathPage(PathSession& session, QWidget* parent = nullptr);

  void show_run(const scan_cell_msgs::DescribeRunResponse& run);
  void set_free(bool free);               ///< whether an edited path can be made to a run
  void show_end(const QString& message);  ///< of what was saved, or why not

 Q_SIGNALS:
  void saveWanted(QString run, QString edits, QString note);      ///< YAML
  void toolWanted(QString name);                                  ///< of rviz
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
  std::map<QString, std::vector<tool_paths::PathEdit>> kept_;  // of other runs, until it is closed
  bool free_ = false;
  bool showing_ = false;  // the table follows the session, not the person
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
