// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/CheckProgramResponse.h>
#include <scan_cell_msgs/EditProgramResponse.h>
#include <scan_cell_msgs/RecipeState.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <vector>

#include "passes/pass_session.h"

namespace scan_cell_rviz {

/// The scan program of a recipe: its passes, their poses, and whether the robot can scan them. The
/// poses of the chosen pass are dragged in the view.
class PassesPage : public QWidget {
  Q_OBJECT

 public:
  explicit PassesPage(PassSession& session, QWidget* parent = nullptr);

  /// Chooses the recipe if none is chosen.
  void suggest(const QString& recipe);
  void show_recipes(const std::vector<scan_cell_msgs::RecipeState>& recipes);
  void show_program(const QString& recipe, const scan_cell_msgs::EditProgramResponse& program);
  void show_checked(const std::vector<scan_cell_msgs::CheckProgramResponse>& answers);
  void show_end(const QString& message);
  /// The cell cannot check passes while the robot moves: it is asked afterwards.
  void set_free(bool free);

 Q_SIGNALS:
  void programWanted(QString recipe);
  void checkWanted();                                             ///< of the session's passes
  void saveWanted(QString recipe);                                ///< of the session's passes
  void placeChosen(double x, double y, double z, QString frame);  ///< [m]
  void toolWanted(QString name);                                  ///< name of an rviz tool

 private:
  void lay_out();
  void fill();
  void check();
  void show_reach();
  void show_selection();
  void take_selection();
  void update_buttons();

  PassSession& session_;
  QComboBox* recipe_;
  QTableWidget* poses_;
  QPushButton* view_;
  QPushButton* undo_;
  QPushButton* redo_;
  QPushButton* check_;
  QPushButton* save_;
  QLabel* reach_;
  QLabel* end_;
  std::vector<PassPose> rows_;  // of the table
  bool showing_ = false;        // the table is being updated from the session
  bool free_ = true;
  bool to_be_checked_ = false;  // once the cell is free
};

}  // namespace scan_cell_rviz
