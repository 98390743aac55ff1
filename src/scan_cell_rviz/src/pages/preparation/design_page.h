// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/DesignPathRequest.h>
#include <scan_cell_msgs/DesignPathResponse.h>
#include <scan_cell_msgs/RecipeState.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>
#include <string>
#include <vector>

#include "design/pick_session.h"
#include "widgets/parameter_form.h"

namespace scan_cell_rviz {

/// Makes a path on the reference of a recipe: through places picked in the view, along its edge, or
/// as a raster. It is saved as a new recipe.
class DesignPage : public QWidget {
  Q_OBJECT

 public:
  explicit DesignPage(PickSession& session, QWidget* parent = nullptr);

  std::string recipe() const { return recipe_->currentText().toStdString(); }  ///< the chosen one
  /// Chooses the recipe if none is chosen.
  void suggest(const QString& recipe);
  void show_recipes(const std::vector<scan_cell_msgs::RecipeState>& recipes);
  void show_answer(const scan_cell_msgs::DesignPathRequest& request,
                   const scan_cell_msgs::DesignPathResponse& answer);
  void show_end(const QString& message);  ///< why there is no answer

 Q_SIGNALS:
  void designWanted(scan_cell_msgs::DesignPathRequest request);
  void recipeMade();              ///< from a path
  void toolWanted(QString name);  ///< name of an rviz tool

 private:
  void lay_out();
  void choose_recipe();
  void choose();
  void follow_picks();
  void ask(bool make, const QString& save_as = {});
  unsigned char way() const;
  void update_buttons();

  PickSession& session_;
  QComboBox* recipe_;
  QComboBox* way_;
  QLabel* count_;
  QPushButton* pick_;
  QPushButton* view_;
  QPushButton* undo_;
  QPushButton* redo_;
  QPushButton* clear_;
  ParameterForm* form_;
  QPushButton* make_;
  QLineEdit* name_;
  QPushButton* save_;
  QLabel* end_;
  QString chosen_;       // recipe
  bool saving_ = false;  // waiting for the answer
};

}  // namespace scan_cell_rviz
