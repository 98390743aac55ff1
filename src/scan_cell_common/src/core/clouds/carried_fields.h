// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "files/scalars.h"
#include "scan_cell_common/clouds/fielded_cloud.h"

namespace scan_cell_common {

/// parse_ply() with all fields of the points. @param carried null: not wanted
Cloud parse_ply(std::string_view bytes, const std::string& source, FieldedCloud* carried);
Cloud parse_pcd(std::string_view bytes, const std::string& source, FieldedCloud* carried);

/// Whether a coordinate is the number that drop_invalid() looks for; for 0, only z counts.
bool holds_invalid(const pcl::PointXYZ& point, double invalid);

/// Adds a field after the others. Returns false if there is already one of that name.
bool add_field(FieldedCloud& cloud, const std::string& name, Scalar type);

/// Adds x, y and z, before all others.
void add_coordinates(FieldedCloud& cloud);

/// Appends a number from its bytes.
/// @param bytes of the number, in the file's order
void append_scalar(const char* bytes, Scalar type, bool big_endian, FieldedCloud& cloud);

/// Appends the number of that type that is nearest to a value; 0 for NaN in a whole number.
void append_scalar(double value, Scalar type, FieldedCloud& cloud);

/// Appends x, y and z.
void append_place(const pcl::PointXYZ& point, FieldedCloud& cloud);

}  // namespace scan_cell_common
