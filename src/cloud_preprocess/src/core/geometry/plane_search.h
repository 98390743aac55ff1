// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

struct Plane {
  Eigen::Vector3d point;   //!< [m] mean of its points
  Eigen::Vector3d normal;  //!< of length 1

  /// [m] height above the plane
  double height(const Eigen::Vector3d& of) const { return normal.dot(of - point); }
  double height(const pcl::PointXYZ& of) const {
    return height(of.getVector3fMap().cast<double>());
  }
};

/// Points of a cloud with the surface's normals, whose signs are arbitrary.
struct OrientedPoints {
  Eigen::Matrix3Xd points;   //!< [m] one per column
  Eigen::Matrix3Xd normals;  //!< of length 1
  double spacing = 0;        //!< [m] median distance to the nearest neighbour

  std::size_t size() const { return static_cast<std::size_t>(points.cols()); }
  OrientedPoints only(const std::vector<Eigen::Index>& indices) const;
};

/// At most 20,000 points of a cloud, chosen at random with a fixed seed.
OrientedPoints sample_with_normals(const Cloud& cloud);

/// Specifies the planes to look for.
struct PlaneSearch {
  double distance = 0;                              //!< [m] greatest distance of its points
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  //!< of length 1
  double tilt = 0;  //!< [rad] greatest angle of its normal from the axis; above pi/2: any
};

struct FoundPlane {
  Plane plane;                        //!< with its normal on the axis' side
  std::vector<Eigen::Index> inliers;  //!< ascending
};

/// The plane with the most points whose normals agree with its own, by RANSAC (Fischler and Bolles
/// 1981) with a fixed seed and a least-squares fit to its inliers.
std::optional<FoundPlane> largest_plane(const OrientedPoints& points, const PlaneSearch& search);

}  // namespace cloud_preprocess
