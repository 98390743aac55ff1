// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

#include "edit/edit_session.h"
#include "pages/shift/stages_box.h"

namespace scan_cell_rviz {

/// Cleaning by hand: settings of the next edit, the edits so far, and what they leave.
class CleanPage : public QWidget {
  Q_OBJECT

 public:
  CleanPage(EditSession& session, QWidget* parent = nullptr);

  /// Sets the part type whose scan is in view; empty: none.
  /// @param cleaning its settings, in YAML; empty: defaults
  void set_recipe(const QString& recipe, const QString& cleaning);

  void show_end(const QString& message);  ///< of saving, or why it failed

 Q_SIGNALS:
  void toolWanted(QString name);  ///< name of an rviz tool, such as polygon; box, view
  void boxWanted();               ///< edit by the box in the view
  void saveWanted(QString recipe, QString edits);         ///< YAML
  void stagesSaveWanted(QString recipe, QString stages);  ///< YAML

 private:
  void lay_out();
  void connect_widgets();
  void show_view();
  static QString count_text(const EditedView& view);
  void take_settings();
  QDoubleSpinBox* length_box(const char* name, double metres, const QString& meaning);

  EditSession& session_;
  QString recipe_;
  cloud_preprocess::CleanParameters given_;  // by the recipe
  QStringList shown_edits_;
  QLabel* count_;
  QComboBox* what_;
  QDoubleSpinBox* depth_;
  QDoubleSpinBox* radius_;
  QDoubleSpinBox* gap_;
  QListWidget* edits_;
  QPushButton* undo_;
  QPushButton* redo_;
  QPushButton* drop_;
  QPushButton* show_;
  QPushButton* take_over_;
  QPushButton* save_;
  StagesBox* stages_;
  QLabel* end_;
};

}  // namespace scan_cell_rviz

Q_DECLARE_METATYPE(scan_cell_rviz::EditAct)
