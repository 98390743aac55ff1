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

/// One line per parameter of a tool, in mm and degrees, with the description from the tool's table.
class ParameterForm : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterForm(QWidget* parent = nullptr);

  /// What a person entered stays if the parameter is still there.
  void show_parameters(const std::vector<scan_cell_msgs::ToolParameter>& parameters);

  /// Values that differ from the defaults, by name, in the tool's units. Text that is not a number
  /// goes to the tool unchanged: the tool reports the error.
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
