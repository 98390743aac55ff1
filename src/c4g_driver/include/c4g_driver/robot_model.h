// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <kdl/chain.hpp>
#include <kdl/frames.hpp>
#include <kdl/jntarray.hpp>
#include <string>
#include <vector>

#include "c4g_driver/robot_state.h"

namespace c4g_driver {

/// A six-axis arm as its URDF describes it: the chain from base to flange, with the ranges and
/// speeds of its joints. Thread-safe.
class RobotModel {
 public:
  /// Rows: translation [m/rad], then rotation [rad/rad]; columns: joints.
  using Jacobian = Eigen::Matrix<double, 6, 6>;

  /// @param urdf the text of the URDF
  /// @param base, flange names of the links between which the six moving joints lie
  /// @throw scan_cell_common::InvalidParameter if the text is not a URDF, has no such chain, or a
  /// joint lacks its range or speed
  RobotModel(const std::string& urdf, const std::string& base, const std::string& flange);

  /// Pose of the flange in the base.
  /// @param joints [rad]
  Eigen::Isometry3d flange_at(const Joints& joints) const;

  /// Derivative of the flange's position [m] and rotation [rad] with respect to the joints [rad],
  /// along the axes of the base.
  Jacobian jacobian_at(const Joints& joints) const;

  /// Names of the links in the URDF, in order from the base's first child to the flange.
  const std::vector<std::string>& link_names() const { return link_names_; }

  /// Poses of these links in the base. @param joints [rad]
  std::vector<Eigen::Isometry3d> links_at(const Joints& joints) const;

  /// Origin [m] of the next moving joint in the frame of a link, or of the flange if there is none.
  /// @param link index of link_names()
  Eigen::Vector3d next_origin(std::size_t link) const;

  const Joints& lower() const { return lower_; }  //!< [rad]; -infinity for a continuous joint
  const Joints& upper() const { return upper_; }  //!< [rad]
  const Joints& speed() const { return speed_; }  //!< [rad/s]
  const std::array<std::string, 6>& joint_names() const { return names_; }  //!< as in the URDF
  const KDL::Chain& chain() const { return chain_; }  //!< from the base frame to the flange

 private:
  KDL::Chain chain_;
  std::vector<std::string> link_names_;
  std::vector<bool> moving_;  // whether a link turns against the one before
  std::array<std::string, 6> names_;
  Joints lower_;
  Joints upper_;
  Joints speed_;
};

/// Small motion from one pose to the other: translation [m], then rotation vector [rad], along the
/// axes of the frame in which both are given.
Eigen::Matrix<double, 6, 1> twist(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);

KDL::JntArray to_kdl(const Joints& joints);        //!< [rad]
KDL::Frame to_kdl(const Eigen::Isometry3d& pose);  //!< [m]

}  // namespace c4g_driver
