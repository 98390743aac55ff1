// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "cloud_preprocess/stage.h"

namespace scan_cell_common {
class YamlEntry;
}  // namespace scan_cell_common

namespace cloud_preprocess {

/// A box, including its faces.
struct BoxShape {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< of its middle [m]
  Eigen::Vector3d size = Eigen::Vector3d::Ones();          //!< along its own axes [m]
};

/// Everything on the side of a plane to which its normal points, including the plane.
struct HalfSpace {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    //!< of the plane [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  //!< of length 1
};

/// Everything behind a polygon drawn in a picture, between two depths.
struct PrismShape {
  std::vector<Eigen::Vector3d> corners;                //!< [m] at least 3, in order
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  //!< direction to the viewer, unit length
  double nearest = 0;   //!< depth [m] from the first corner, against `towards`
  double farthest = 0;  //!< the same
};

/// Everything within a distance of the places that a brush went over.
struct BrushShape {
  std::vector<Eigen::Vector3d> places;  //!< [m]
  double radius = 0;                    //!< [m]
};

/// Everything that can be reached from the point nearest to a place by steps of at most a gap.
struct ClusterShape {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  //!< [m]
  double gap = 0;                                   //!< [m]
};

/// One edit by hand: deletes what lies in a shape, or keeps only that.
struct CloudEdit {
  bool keep = false;  //!< false: delete
  /// The shape that the edit applies to.
  std::variant<BoxShape, HalfSpace, PrismShape, BrushShape, ClusterShape> shape;
};

/// "box", "plane", "polygon", "brush" or "cluster", as in files and reports.
const char* name_of(const CloudEdit& edit);

/// Edits by hand, one after the other, in the frame of the input cloud.
class CloudEdits final : public Stage {
 public:
  explicit CloudEdits(std::vector<CloudEdit> edits);  //!< in order of execution

  std::string name() const override { return "edits"; }  //!< name of the stage

 private:
  std::string apply(TracedCloud& cloud) const override;

  std::vector<CloudEdit> edits_;
};

/// Reads a list of edits (docs/cloud_preprocess.md).
/// @throw scan_cell_common::UnusableInput naming line and entry of anything missing, unknown or
/// senseless
std::vector<CloudEdit> read_edits(const scan_cell_common::YamlEntry& list);

/// Reads the list `edits` of a YAML file.
/// @throw scan_cell_common::FileError, UnusableInput as read_edits()
std::vector<CloudEdit> load_edits(const std::string& path);

/// Text that read_edits() reads back to the last digit, with the key `edits`.
std::string to_yaml(const std::vector<CloudEdit>& edits);

}  // namespace cloud_preprocess
