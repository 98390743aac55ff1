// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/CheckProgram.h>
#include <scan_cell_msgs/EditProgram.h>

#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "link/node_names.h"
#include "link/worker.h"

namespace scan_cell_rviz {

/// The scan programs of recipes, and what the cell finds about their passes. As in CellLink,
/// nothing blocks, and the nodes may go away and come back.
class PassLink : public QObject {
  Q_OBJECT

 public:
  explicit PassLink(const NodeNames& names);
  ~PassLink() override;

  /// Answered by programCame or failed.
  void load(const QString& recipe);

  /// Saves the passes in the recipe. Answered by programSaved or failed.
  void save(const QString& recipe, const std::string& frame,
            const std::vector<scan_cell_msgs::ScanPass>& passes);

  /// Asks the cell about each pass alone, from the robot's present pose. Answered by checked; if
  /// other passes come meanwhile, only they are answered.
  void check(const std::string& frame, const std::vector<scan_cell_msgs::ScanPass>& passes);

 Q_SIGNALS:
  void programCame(QString recipe, scan_cell_msgs::EditProgramResponse program);
  void programSaved(QString recipe);
  void checked(std::vector<scan_cell_msgs::CheckProgramResponse> passes);  ///< one per pass
  void failed(QString message);

 private:
  template <class End>
  void edit(const scan_cell_msgs::EditProgramRequest& request, const End& end);

  const NodeNames names_;
  std::atomic<int> latest_{0};  // of the checks
  std::unique_ptr<Worker> worker_ = std::make_unique<Worker>();
};

}  // namespace scan_cell_rviz
