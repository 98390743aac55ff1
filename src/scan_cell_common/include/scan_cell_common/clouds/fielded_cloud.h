// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scan_cell_common/clouds/cloud_files.h"

namespace scan_cell_common {

/// Values as in sensor_msgs/PointField.
enum class FieldType : std::uint8_t {
  kInt8 = 1,
  kUint8 = 2,
  kInt16 = 3,
  kUint16 = 4,
  kInt32 = 5,
  kUint32 = 6,
  kFloat32 = 7,
  kFloat64 = 8,
};

/// [bytes] of a value; 0 of what is no type
std::size_t size_of(FieldType type);

/// What each point of a cloud has under one name.
struct CloudField {
  std::string name;                      //!< such as x or intensity
  FieldType type = FieldType::kFloat32;  //!< of its one value
  std::size_t offset = 0;                //!< [bytes] from the point's begin
};

/// Points with all that they carry, as they lie in a PointCloud2.
struct FieldedCloud {
  std::vector<CloudField> fields;   //!< x, y and z among them
  std::size_t step = 0;             //!< [bytes] from point to point
  std::vector<std::uint8_t> bytes;  //!< little endian, step a point

  std::size_t size() const { return step == 0 ? 0 : bytes.size() / step; }  //!< points
};

/// Places alone, NaN included.
/// @throw UnusableInput if x, y or z is missing or no float32, a field lies outside of the point,
/// or the bytes are no whole points
Cloud places_of(const FieldedCloud& cloud);

/// Points with what they carry from the points of another cloud.
/// @param places of the points that are wanted [m]
/// @param sources index in `from`, a point
FieldedCloud with_fields(const Cloud& places, const FieldedCloud& from,
                         const std::vector<std::uint32_t>& sources);

/// Writes all fields as binary PLY or PCD, by the file's ending. Whole or not at all.
/// @param metres_per_unit of the file; x, y and z are metres in the cloud
/// @throw FileError if it cannot be written or the ending is neither
/// @throw UnusableInput as places_of()
void save_cloud(const std::string& path, const FieldedCloud& cloud, double metres_per_unit = 1);

}  // namespace scan_cell_common
