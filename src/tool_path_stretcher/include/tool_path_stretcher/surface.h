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

/// Where a surface ends or has a sharp edge. It shows the position along the surface, which a
/// smooth surface does not.
struct Rim {
  Points points;           //!< [m]
  Points outward;          //!< unit length, tangential to the surface, pointing away from it
  std::vector<bool> open;  //!< whether the surface ends there (otherwise it bends sharply)
  std::vector<bool>
      horizon;  //!< whether only the visible part ends there: not a fixed place on the part
  std::shared_ptr<const KdTree> tree;  //!< of the points
};

/// Selects one set of a surface's samples.
enum class Density { kFewest, kFew, kSome, kMany };

/// Points spread evenly over a surface, whatever its own density. Isolated points far from all
/// others are left out.
struct Samples {
  std::vector<std::size_t> fewest;  //!< at most 300
  std::vector<std::size_t> few;     //!< at most 1000
  std::vector<std::size_t> some;    //!< at most 3000
  std::vector<std::size_t> many;    //!< at most 6000
  std::vector<std::size_t> most;    //!< at most 20,000
  std::vector<std::size_t> patch;   //!< patch number of each point of `most`

  /// Indices of the points at this density.
  const std::vector<std::size_t>& of(Density density) const;
};

/// A surface given by points with normals.
struct Surface {
  Points points;          //!< [m]
  Points normals;         //!< unit length
  bool oriented = false;  //!< all normals point out of the part (meshes); false: any sign
  bool closed = false;    //!< a mesh that shows the part from all sides: no scan sees all of it
  /// Unit vectors towards the viewers of the scan; empty: unknown.
  Points seen_from;
  /// [m] of each point: uncertainty of the surface there due to sampling and grid. This is the
  /// distance of its neighbours from its plane: zero on a face, large beside an edge, at most half
  /// a spacing.
  std::vector<double> blur;
  double spacing = 0;  //!< [m] typical distance between neighbouring points
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  //!< [m] of the points
  double size = 0;                     //!< [m] root mean square distance from the centroid
  std::shared_ptr<const KdTree> tree;  //!< of the points
  Samples samples;                     //!< of the points
  Rim rim;                             //!< its ends and sharp edges
  /// The rim, and the edges where the surface continues around a corner. Such an edge is stored
  /// twice, once as the end of each face, since a scan from another side may see only one of them.
  Rim edges;
  Points others;  //!< [m] points of the same scan that belong to other things
  std::shared_ptr<const KdTree>
      whole;  //!< of all points of the surface that this one was taken from; none: it is complete
  Points whole_normals;  //!< unit length, at the points of `whole`
};

/// Makes a surface from a cloud. Reduces its points on the grid, or on a coarser one that leaves at
/// most 50,000, and estimates normals from the neighbours.
/// @param name of the cloud in errors
/// @param seen_from as returned by directions_seen_from()
/// @throw scan_cell_common::UnusableInput if the cloud is empty, has points that are not finite, or
/// lies on one line
Surface surface_from_cloud(const Points& cloud, const Eigen::Vector3d& leaf,
                           const std::string& name, const Points& seen_from = {});

/// Makes a surface from a triangle mesh, sampled evenly over its area, with the triangles' normals.
/// Those of a closed mesh point outwards whatever its winding. The samples are as dense as a grid
/// with that leaf would leave them.
/// @throw scan_cell_common::UnusableInput if the mesh has no area or vertices that are not finite
Surface surface_from_mesh(const pcl::PolygonMesh& mesh, const Eigen::Vector3d& leaf,
                          const std::string& name);

/// Makes a surface from a file that scan_cell_common::load_mesh() or load_cloud() can read.
/// @param leaf [m]
/// @param metres_per_unit of the file's lengths
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
Surface load_surface(const std::string& path, const Eigen::Vector3d& leaf,
                     double metres_per_unit = 1);

/// The points [m] of a cloud.
Points to_points(const pcl::PointCloud<pcl::PointXYZ>& cloud);

/// A cloud of points [m].
pcl::PointCloud<pcl::PointXYZ> to_cloud(const Points& points);

}  // namespace tool_path_stretcher
