// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/ToolParameter.h>

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QWidget>
#include <map>
#include <string>
#include <vector>

namespace scan_cell_rviz {

/// A line for each parameter of a tool, in mm and degrees, with what the tool's table says of it.
class ParameterForm : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterForm(QWidget* parent = nullptr);

  /// What a person gave before stays where the parameter is still there.
  void show_parameters(const std::vector<scan_cell_msgs::ToolParameter>& parameters);

  /// Values that differ from the defaults, by name, as the tool takes them. What is no number goes
  /// to the tool as it is: it says what is wrong with it.
  std::map<std::string, std::string> given() const;

 private:
  struct Line {
    scan_cell_msgs::ToolParameter parameter;
    QLineEdit* edit = nullptr;    // of numbers and words
    QComboBox* choice = nullptr;  // of a choice
  };

  void add(const scan_cell_msgs::ToolParameter& parameter, const QString& text);

  QFormLayout* form_;
  std::vector<Line> lines_;
};

}  // namespace scan_cell_rviz
