// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/JogState.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QTimer>
#include <QWidget>
#include <array>
#include <vector>

#include "link/preparation/teach_link.h"
#include "widgets/hold_button.h"

namespace scan_cell_rviz {

/// Moves the robot while buttons are held, and records poses.
class TeachPage : public QWidget {
  Q_OBJECT

 public:
  explicit TeachPage(TeachLink& link, QWidget* parent = nullptr);

  void set_free(bool free);  ///< whether the robot may move

  QString file() const { return file_->text(); }  ///< of the poses
  void set_file(const QString& file) { file_->setText(file); }

 Q_SIGNALS:
  void fileChanged();

 private:
  static constexpr int kAxes = 6;

  QLayout* jog_box();
  QLayout* jog_buttons();
  QLayout* pose_box();
  void name_axes();
  void show_joints(const std::vector<double>& positions);
  void show_state(const scan_cell_msgs::JogState& state);
  void hold(HoldButton* button, int axis, int direction);
  void send();
  void let_go(const QString& why);
  void choose_file();
  void take_pose();

  TeachLink& link_;
  QComboBox* kind_;
  QDoubleSpinBox* speed_;
  std::array<QLabel*, kAxes> names_{};
  std::array<QLabel*, kAxes> values_{};
  std::vector<HoldButton*> buttons_;
  QLabel* said_;
  QLineEdit* file_;
  QPushButton* take_;
  QLabel* taken_;
  QTimer timer_;
  QElapsedTimer since_sent_;
  HoldButton* held_ = nullptr;
  scan_cell_msgs::Jog jog_;  // of the held button
};

}  // namespace scan_cell_rviz
