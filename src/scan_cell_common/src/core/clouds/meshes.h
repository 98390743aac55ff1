// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_common/clouds/cloud_files.h"

namespace scan_cell_common {

pcl::PolygonMesh mesh_of(Cloud& vertices, std::vector<pcl::Vertices> polygons);

/// @param first number of the first vertex in the file, for the error
/// @throw FileError if a corner is not a vertex
void check_corners(const std::vector<pcl::Vertices>& polygons, std::size_t vertices,
                   const std::string& source, int first);

}  // namespace scan_cell_common
