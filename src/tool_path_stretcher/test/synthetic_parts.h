// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>

#include <functional>
#include <random>
#include <string>

#include "tool_path_stretcher/similarity.h"
#include "tool_path_stretcher/tool_path.h"

/// Parts in closed form, with exact truth, for tests and benchmarks. No product code reads this.
namespace synthetic {

using tool_path_stretcher::Points;
using tool_path_stretcher::Similarity;
using tool_path_stretcher::ToolPath;

/// A part as a height over x, y inside an outline [m].
struct Part {
  double width;                                            //!< [m] along x
  double depth;                                            //!< [m] along y
  std::function<bool(double x, double y)> inside;          //!< centred on the origin
  std::function<double(double x, double y)> height;        //!< [m]
  std::function<Eigen::Vector3d(double a)> path_position;  //!< a: 0 .. 1 along the path

  Eigen::Vector3d normal(double x, double y) const;
};

/// A photo frame of 200 x 150 x 20 mm with a moulding of 25 mm and the path along its crest. It has
/// a 180 degree symmetry except for one small rosette of the given height.
Part photo_frame(double rosette = 0.003);

/// A doubly curved panel of 300 x 200 mm without symmetry. The path is a raster line over it.
Part curved_panel();

/// A flat box lid of 180 x 120 x 30 mm.
Part box_lid();

/// Displacement of the surface [m] before the similarity.
using Deformation = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

Deformation no_deformation();

/// Bends about y by `rise` in the middle of `width`; changes only z, like the height of a sagging
/// plate.
Deformation bend(double rise, double width);

struct Scan {
  std::size_t points = 20000;
  double noise = 0.0001;                            //!< [m] of each coordinate
  Eigen::Vector3d view = Eigen::Vector3d::UnitZ();  //!< surfaces facing away are not seen
  double min_facing = -1;                           //!< cosine of normal and view; -1: all
  bool uneven = false;                              //!< four times denser at one end
  std::function<bool(const Eigen::Vector3d&)> is_hole =
      {};                    //!< not scanned, on the undeformed part
  std::size_t outliers = 0;  //!< additional points, anywhere around
  unsigned seed = 1;
};

/// Points on the deformed part, moved by the similarity.
Points scan(const Part& part, const Similarity& similarity, const Deformation& deformation,
            const Scan& how);

/// Random points of a mesh by area, moved; independent of the product's own sampling.
Points scan_mesh(const pcl::PolygonMesh& mesh, const Similarity& similarity, const Scan& how);

/// `count` waypoints in two segments on the part, z along the normal, with process values.
ToolPath path_on(const Part& part, std::size_t count);

/// The true path: the path of the undeformed part, deformed and moved.
ToolPath truth(const ToolPath& path, const Similarity& similarity, const Deformation& deformation);

Similarity similarity(double scale, const Eigen::Matrix3d& rotation,
                      const Eigen::Vector3d& translation);

Eigen::Matrix3d random_rotation(unsigned seed);

struct PathError {
  double rms = 0;          //!< [m]
  double max = 0;          //!< [m]
  double orientation = 0;  //!< [rad] RMS
};

PathError error_of(const ToolPath& path, const ToolPath& truth);

}  // namespace synthetic
