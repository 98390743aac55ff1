// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/Marker.h>

#include <Eigen/Geometry>
#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "edit/picking.h"

namespace scan_cell_rviz {

/// Where a ray first meets a triangle, from either side.
/// @param corners [m] three per triangle; left-over ones at the end are ignored
std::optional<Eigen::Vector3d> first_hit(const std::vector<geometry_msgs::Point>& corners,
                                         const Ray& ray);

/// Places picked by a person on a reference, with unlimited undo and redo.
class PickSession : public QObject {
  Q_OBJECT

 public:
  /// Shows another reference; the picks stay.
  /// @param reference corners of its triangles [m]
  void open(const visualization_msgs::MarkerConstPtr& reference);

  void close();  ///< removes the reference and the picks

  bool pick(const Ray& ray);  ///< false: the ray does not meet the reference
  void undo();
  void redo();
  void clear();  ///< cannot be undone

  bool is_open() const { return reference_ != nullptr && !reference_->points.empty(); }
  Eigen::AlignedBox3d box() const;  ///< [m] around the reference; empty: no reference
  std::string frame() const { return is_open() ? reference_->header.frame_id : ""; }
  const std::vector<Eigen::Vector3d>& picks() const { return picks_; }  ///< [m]
  bool can_redo() const { return !undone_.empty(); }

 Q_SIGNALS:
  void changed();

 private:
  visualization_msgs::MarkerConstPtr reference_;
  std::vector<Eigen::Vector3d> picks_;
  std::vector<Eigen::Vector3d> undone_;  // the last is redone first
};

/// The session that the seat and rviz's tool share.
PickSession& shared_pick_session();

}  // namespace scan_cell_rviz
