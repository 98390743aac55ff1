// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edit/edit_session.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "widgets/log_slider.h"

namespace scan_cell_rviz {

/// The automatic cleaning stages: their numeric parameters and switches, and what each stage would
/// remove. Other parameters stay as in the recipe.
class StagesBox : public QGroupBox {
  Q_OBJECT

 public:
  explicit StagesBox(QWidget* parent = nullptr);

  void set_parameters(const cloud_preprocess::CleanParameters& parameters);  ///< from the recipe
  /// @return none: the box is switched off
  std::optional<cloud_preprocess::CleanParameters> parameters() const;

  void show_stages(const std::vector<StageView>& stages);
  void set_savable(bool savable) { save_->setEnabled(savable); }

 Q_SIGNALS:
  void changed();
  void saveWanted();

 private:
  /// The widgets of one parameter: a slider or a box.
  struct Row {
    double factor = 1;  // from the parameter's unit to the displayed one
    LogSlider* slider = nullptr;
    QCheckBox* box = nullptr;
    bool touched = false;  // false: the parameter stays as it is, to the last digit
  };

  void add_row(const scan_cell_common::Parameter& parameter,
               const scan_cell_common::ParameterValue& value);
  void touch(const std::string& name);

  cloud_preprocess::CleanParameters given_;
  std::map<std::string, Row> rows_;            // by the parameter's name
  std::map<std::string, QFormLayout*> forms_;  // by stage
  std::map<std::string, QLabel*> words_;       // by stage
  QWidget* inside_;
  QPushButton* save_;
};

}  // namespace scan_cell_rviz
