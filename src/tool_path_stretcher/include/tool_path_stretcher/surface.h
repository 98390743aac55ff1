// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "tool_path_stretcher/similarity.h"

namespace pcl {
struct PointXYZ;
struct PolygonMesh;
template <class Point>
class PointCloud;
}  // namespace pcl

namespace tool_path_stretcher {

class KdTree;

/// Where a surface ends or has a sharp edge: it shows a position along the surface that a smooth
/// surface itself does not.
struct Rim {
  Points points;              //!< [m]
  Points outward;             //!< unit length, in the surface and away from it
  std::vector<bool> open;     //!< whether the surface ends there, rather than bends sharply
  std::vector<bool> horizon;  //!< whether only what can be seen of it ends there: no place on it
  std::shared_ptr<const KdTree> tree;  //!< of the points
};

/// Which of a surface's samples.
enum class Density { kFewest, kFew, kSome, kMany };

/// Points spread evenly over a surface, whatever its own density, without loose ones far from all
/// others.
struct Samples {
  std::vector<std::size_t> fewest;  //!< at most 300
  std::vector<std::size_t> few;     //!< at most 1000
  std::vector<std::size_t> some;    //!< at most 3000
  std::vector<std::size_t> many;    //!< at most 6000
  std::vector<std::size_t> most;    //!< at most 20,000
  std::vector<std::size_t> patch;   //!< of each of `most`: number of the patch that it lies in

  /// Indices of the points, from fewest to many.
  const std::vector<std::size_t>& of(Density density) const;
};

/// A surface known by points on it, with the normal at each.
struct Surface {
  Points points;          //!< [m]
  Points normals;         //!< unit length
  bool oriented = false;  //!< all normals point out of the part (meshes); otherwise signs are free
  bool closed = false;    //!< a mesh that shows the part from all sides: no scan sees all of it
  /// Unit length, towards the viewers: from where a scan saw it; empty: not known.
  Points seen_from;
  /// [m] of each point: how far sampling and grid leave open where the surface is there. Its
  /// neighbours lie so far off its plane: nothing on a face, much beside an edge, half a spacing at
  /// most.
  std::vector<double> blur;
  double spacing = 0;  //!< [m] typical distance of neighbouring points
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  //!< [m] of the points
  double size = 0;                     //!< [m] root mean square distance from the centroid
  std::shared_ptr<const KdTree> tree;  //!< of the points
  Samples samples;                     //!< of the points
  Rim rim;                             //!< its ends and sharp edges
  /// The rim, and the edges where the surface goes on around a corner: each place twice, as each of
  /// the two faces ends there. A scan from another side may see only one of them.
  Rim edges;
  Points others;                        //!< [m] of the same scan, taken for other things
  std::shared_ptr<const KdTree> whole;  //!< of all points of the surface that this is a part of;
                                        //!< none: it is no part
  Points whole_normals;                 //!< unit length, at those
};

/// A surface from a cloud: its points are reduced on the grid, or a coarser one that leaves at most
/// 50,000; normals come from the neighbours.
/// @param name of the cloud in errors
/// @param seen_from as directions_seen_from() gives it
/// @throw scan_cell_common::UnusableInput if the cloud is empty, has points that are not finite, or
/// all its points lie on one line
Surface surface_from_cloud(const Points& cloud, const Eigen::Vector3d& leaf,
                           const std::string& name, const Points& seen_from = {});

/// A surface from a triangle mesh: sampled evenly over its area, with the triangles' normals, which
/// point out of a closed one whatever its winding. The
/// samples are as dense as a grid with that leaf would leave them.
/// @throw scan_cell_common::UnusableInput if the mesh has no area or vertices that are not finite
Surface surface_from_mesh(const pcl::PolygonMesh& mesh, const Eigen::Vector3d& leaf,
                          const std::string& name);

/// A surface from a file that scan_cell_common::load_mesh() or load_cloud() reads.
/// @param leaf [m]
/// @param metres_per_unit of the file's lengths
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
Surface load_surface(const std::string& path, const Eigen::Vector3d& leaf,
                     double metres_per_unit = 1);

/// The positions [m] of a cloud.
Points to_points(const pcl::PointCloud<pcl::PointXYZ>& cloud);

/// The cloud of positions [m].
pcl::PointCloud<pcl::PointXYZ> to_cloud(const Points& points);

}  // namespace tool_path_stretcher
