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

/// Where a ray first meets one of some triangles, from either side.
/// @param corners [m] three a triangle; those left over at the end are no triangle
std::optional<Eigen::Vector3d> first_hit(const std::vector<geometry_msgs::Point>& corners,
                                         const Ray& ray);

/// Places that a person picks on a reference, with undo and redo without end.
class PickSession : public QObject {
  Q_OBJECT

 public:
  /// The reference in view; the picks stay.
  /// @param reference corners of its triangles [m]
  void open(const visualization_msgs::MarkerConstPtr& reference);

  void close();  ///< no reference is in view, and nothing is picked

  bool pick(const Ray& ray);  ///< false where there is nothing of the reference
  void undo();
  void redo();
  void clear();  ///< and nothing can be undone

  bool is_open() const { return reference_ != nullptr && !reference_->points.empty(); }
  Eigen::AlignedBox3d box() const;  ///< [m] around the reference; empty: none is in view
  std::string frame() const { return is_open() ? reference_->header.frame_id : ""; }
  const std::vector<Eigen::Vector3d>& picks() const { return picks_; }  ///< [m]
  bool can_redo() const { return !undone_.empty(); }

 Q_SIGNALS:
  void changed();

 private:
  visualization_msgs::MarkerConstPtr reference_;
  std::vector<Eigen::Vector3d> picks_;
  std::vector<Eigen::Vector3d> undone_;  // the next one to redo last
};

/// The one that the seat and the tool of rviz share.
PickSession& shared_pick_session();

}  // namespace scan_cell_rviz
