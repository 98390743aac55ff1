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
/// speeds of its joints. Safe for use from several threads at once.
class RobotModel {
 public:
  /// Rows: translation [m/rad], rotation; columns: joints.
  using Jacobian = Eigen::Matrix<double, 6, 6>;

  /// @param urdf the text of the URDF
  /// @param base, flange links between which the six moving joints lie
  /// @throw scan_cell_common::InvalidParameter if it is no URDF, has no such chain, or a joint
  /// lacks its range or speed
  RobotModel(const std::string& urdf, const std::string& base, const std::string& flange);

  /// Flange in the base.
  /// @param joints [rad]
  Eigen::Isometry3d flange_at(const Joints& joints) const;

  /// Velocity of the flange's origin [m] and its rotation [rad] by those of the joints [rad], in
  /// the base's directions.
  Jacobian jacobian_at(const Joints& joints) const;

  /// Links after each other from the base's first child to the flange, as the URDF calls them.
  const std::vector<std::string>& link_names() const { return link_names_; }

  /// Each of them in the base. @param joints [rad]
  std::vector<Eigen::Isometry3d> links_at(const Joints& joints) const;

  /// Where the next joint that moves has its origin, or the flange if there is none [m], in a link.
  /// @param link index of link_names()
  Eigen::Vector3d next_origin(std::size_t link) const;

  const Joints& lower() const { return lower_; }  //!< [rad]; -infinity for a joint without ends
  const Joints& upper() const { return upper_; }  //!< [rad]
  const Joints& speed() const { return speed_; }  //!< [rad/s]
  const std::array<std::string, 6>& joint_names() const { return names_; }  //!< as in the URDF
  const KDL::Chain& chain() const { return chain_; }  //!< from the base frame to the flange

 private:
  KDL::Chain chain_;
  std::vector<std::string> link_names_;
  std::vector<bool> moving_;  // a link turns against the one before
  std::array<std::string, 6> names_;
  Joints lower_;
  Joints upper_;
  Joints speed_;
};

/// Small motion from one pose to the other: translation [m], then rotation vector [rad], in the
/// directions of the frame both are given in.
Eigen::Matrix<double, 6, 1> twist(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);

KDL::JntArray to_kdl(const Joints& joints);        //!< [rad]
KDL::Frame to_kdl(const Eigen::Isometry3d& pose);  //!< [m]

}  // namespace c4g_driver
