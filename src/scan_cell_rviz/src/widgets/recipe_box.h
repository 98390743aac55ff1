// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/RecipeState.h>

#include <QComboBox>
#include <vector>

namespace scan_cell_rviz {

/// Updates the list of recipes. The chosen one stays chosen if it is still listed, else none is.
/// @return whether the choice has changed
inline bool list_recipes(const std::vector<scan_cell_msgs::RecipeState>& recipes, QComboBox& box) {
  const QString before = box.currentText();
  box.clear();
  for (const scan_cell_msgs::RecipeState& recipe : recipes)
    box.addItem(QString::fromStdString(recipe.name));
  box.setCurrentIndex(box.findText(before));  // -1: none
  return box.currentText() != before;
}

/// @return whether nothing was chosen before, and the recipe is now
inline bool choose_in_empty(QComboBox& box, const QString& recipe) {
  const int row = box.findText(recipe);
  if (!box.currentText().isEmpty() || row < 0) return false;
  box.setCurrentIndex(row);
  return true;
}

}  // namespace scan_cell_rviz
