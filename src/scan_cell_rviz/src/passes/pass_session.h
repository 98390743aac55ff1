// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/ScanPass.h>

#include <Eigen/Geometry>
#include <QObject>
#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace scan_cell_rviz {

/// Whether the robot can scan a pass.
enum class Reach { kUnknown, kReachable, kNot };

/// What the cell finds about a pass.
struct PassReach {
  Reach reach = Reach::kUnknown;
  QString why;  ///< why not, or why unknown
};

/// Identifies a pose of a pass by indices.
struct PassPose {
  std::size_t pass = 0;
  std::size_t pose = 0;
};

/// "start", "via" and "end", or the number of a pose of a polyline.
QString pose_name(const scan_cell_msgs::ScanPass& pass, std::size_t pose);

/// The passes of a scan program, dragged by a person, with unlimited undo and redo.
class PassSession : public QObject {
  Q_OBJECT

 public:
  using Passes = std::vector<scan_cell_msgs::ScanPass>;

  /// Opens another program.
  void open(const std::string& frame, const Passes& passes);

  void move(const PassPose& at, const Eigen::Isometry3d& pose);  ///< [m]
  void undo();
  void redo();
  void select(const std::optional<PassPose>& at);

  /// Sets what the cell finds about the present passes, one each.
  void show_reach(const std::vector<PassReach>& reach);

  const Passes& passes() const { return passes_; }
  const std::string& frame() const { return frame_; }  ///< of the poses
  const std::vector<PassReach>& reach() const { return reach_; }
  const std::optional<PassPose>& selected() const { return selected_; }
  bool can_undo() const { return !before_.empty(); }
  bool can_redo() const { return !undone_.empty(); }

 Q_SIGNALS:
  void changed();  ///< of the passes
  void selectionChanged();
  void reachChanged();

 private:
  void show(const Passes& passes);

  std::string frame_;
  Passes passes_;
  std::vector<Passes> before_;  // before each change
  std::vector<Passes> undone_;  // the last is redone first
  std::vector<PassReach> reach_;
  std::optional<PassPose> selected_;
};

/// The session that the seat and rviz's displays share.
PassSession& shared_pass_session();

}  // namespace scan_cell_rviz
