// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/RecipeState.h>

#include <QComboBox>
#include <vector>

namespace scan_cell_rviz {

/// Lists the recipes anew; the one that was chosen stays so if it is still there, else none is.
/// @return whether another one, or none, is chosen now
inline bool list_recipes(const std::vector<scan_cell_msgs::RecipeState>& recipes, QComboBox& box) {
  const QString before = box.currentText();
  box.clear();
  for (const scan_cell_msgs::RecipeState& recipe : recipes)
    box.addItem(QString::fromStdString(recipe.name));
  box.setCurrentIndex(box.findText(before));  // -1: none is chosen
  return box.currentText() != before;
}

/// @return whether nothing was chosen before, and this is now
inline bool choose_in_empty(QComboBox& box, const QString& recipe) {
  const int row = box.findText(recipe);
  if (!box.currentText().isEmpty() || row < 0) return false;
  box.setCurrentIndex(row);
  return true;
}

}  // namespace scan_cell_rviz
