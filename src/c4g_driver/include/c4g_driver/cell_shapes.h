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
    kBox,        //!< size: edges along x, y, z; centred on its pose
    kCapsule,    //!< size: radius, length of the centre line (along z, centred on its pose)
    kHalfSpace,  //!< size: unit vector out of the solid; the surface passes through its pose
  };
  std::string name;   //!< unique
  std::string frame;  //!< base_link: fixed in the cell; a link of the arm, flange or tool_tip:
                      //!< moves with it
  Kind kind = Kind::kSphere;                               //!< what it is
  Eigen::Vector3d size = Eigen::Vector3d::Zero();          //!< [m] meaning depends on the kind
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< in its frame [m]
};

/// A link of the arm as a capsule from the origin of its joint to the origin of the next joint, or
/// to the flange.
struct LinkCapsule {
  std::string link;   //!< as in the URDF
  double radius = 0;  //!< [m]
};

/// Bodies that must not collide: those that move with the robot, and those fixed in the cell.
struct CellShapes {
  double clearance = 0;            //!< [m] to keep; corners of boxes keep up to 1.7 times as much
  std::vector<CellShape> shapes;   //!< of the robot, its tool and the cell
  std::vector<LinkCapsule> links;  //!< of the arm; empty: links are ignored
  std::set<std::pair<std::string, std::string>> may_touch;  //!< pairs of names, each sorted
};

/// @throw scan_cell_common::FileError if the file cannot be read
/// @throw scan_cell_common::UnusableInput naming the invalid entry
CellShapes read_cell_shapes(const std::string& path);

/// The same for text already in memory.
/// @param name of the text, for error messages
CellShapes parse_cell_shapes(const std::string& text, const std::string& name);

}  // namespace c4g_driver
