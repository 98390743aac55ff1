// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "tool_path_stretcher/similarity.h"

namespace drawn {

using tool_path_stretcher::Points;

/// A grid of points on z = 0, 100 x 60 mm about the origin.
/// @param step [m]
Points plane(double step = 0.001);

/// The part of a sphere about the origin within 50 degrees of +z, with evenly spread points.
/// @param radius [m]
Points cap(double radius, std::size_t count);

/// Triangles of a sphere about the origin as ASCII STL in metres.
/// @param inside_out wound the wrong way round
void save_sphere(const std::string& file, double radius, bool inside_out = false);

/// Triangles of a cube about the origin as ASCII STL in metres.
/// @param side [m]
void save_cube(const std::string& file, double side);

/// A square about the origin on z = 0 as ASCII STL in metres.
/// @param cells along each side, of two triangles
void save_sheet(const std::string& file, double side, int cells, bool downwards);

/// A pose: turned, shifted, and larger by 8 %.
tool_path_stretcher::Similarity moved();

/// A report as stretch writes it, with this pose.
/// @param known false: it did not come to a pose
void save_report(const std::string& file, const tool_path_stretcher::Similarity& similarity,
                 bool known = true);

/// A folder for one test, removed with this object.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  std::string save(const std::string& name, const Points& points) const;     //!< @return its path
  std::string save(const std::string& name, const std::string& text) const;  //!< the same

 private:
  std::string path_;
};

}  // namespace drawn
