// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace c4g_driver {

/// A solid on the robot or in its cell.
struct CellShape {
  /// What it is.
  enum class Kind {
    kSphere,     //!< size: radius
    kBox,        //!< size: edges along x, y, z; around its pose
    kCapsule,    //!< size: radius, and length of the centre line, which is along z around its pose
    kHalfSpace,  //!< size: direction out of the solid, of length 1, through its pose
  };
  std::string name;                                //!< each its own
  std::string frame;                               //!< base_link: it stands in the cell; a link of
                                                   //!< the arm, flange, tool_tip: it moves along
  Kind kind = Kind::kSphere;                       //!< what it is
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  //!< [m] see the kind
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< in its frame [m]
};

/// A link of the arm as a capsule from the origin of its joint to that of the next, or to the
/// flange.
struct LinkCapsule {
  std::string link;   //!< as in the URDF
  double radius = 0;  //!< [m]
};

/// What must not run into each other: what moves with the robot, and what stands in the cell.
struct CellShapes {
  double clearance = 0;            //!< [m] to keep; corners of boxes keep up to 1.7 times as much
  std::vector<CellShape> shapes;   //!< of the robot, its tool and the cell
  std::vector<LinkCapsule> links;  //!< of the arm; none: those do not count
  std::set<std::pair<std::string, std::string>> may_touch;  //!< names, in alphabetical order
};

/// @throw scan_cell_common::FileError if the file cannot be read
/// @throw scan_cell_common::UnusableInput naming the entry that makes no sense
CellShapes read_cell_shapes(const std::string& path);

/// The same for text that was read already.
/// @param name of the text, in errors
CellShapes parse_cell_shapes(const std::string& text, const std::string& name);

}  // namespace c4g_driver
