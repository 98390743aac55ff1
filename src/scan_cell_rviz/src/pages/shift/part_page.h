// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/RecipeState.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <vector>

namespace scan_cell_rviz {

/// Chooses the part on the table: the recipes with their pictures, and the button that scans it.
class PartPage : public QWidget {
  Q_OBJECT

 public:
  explicit PartPage(QWidget* parent = nullptr);

  /// The chosen recipe stays chosen if it is still listed.
  void show_recipes(const std::vector<scan_cell_msgs::RecipeState>& recipes);
  void show_missed(const QString& why);  ///< the recipes could not be listed
  void set_free(bool free);              ///< whether a scan may begin
  QString chosen() const;                ///< recipe; empty: none

 Q_SIGNALS:
  void refreshWanted();
  void runWanted(QString recipe, QString note);

 private:
  void update_button();

  QListWidget* recipes_;
  QLabel* missed_;
  QLineEdit* note_;
  QPushButton* run_;
  bool free_ = false;
};

}  // namespace scan_cell_rviz
