// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
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

/// [bytes] of a value; 0 for an invalid type
std::size_t size_of(FieldType type);

/// One named field of the points of a cloud.
struct CloudField {
  std::string name;                      //!< such as x or intensity
  FieldType type = FieldType::kFloat32;  //!< of its single value
  std::size_t offset = 0;                //!< [bytes] from the start of the point
};

/// Offsets [bytes] from the start of a point to the float32 fields of a vector, such as vp_x, vp_y,
/// vp_z; empty if it has none.
/// @param prefix of x, y and z
std::vector<std::size_t> offsets_of(const std::vector<CloudField>& fields,
                                    const std::string& prefix);

/// A view of points with all their fields.
struct CloudView {
  std::vector<CloudField> fields;      //!< including x, y and z
  std::size_t step = 0;                //!< [bytes] from point to point
  const std::uint8_t* data = nullptr;  //!< little endian
  std::size_t bytes = 0;               //!< of data; `step` per point

  std::size_t size() const { return step == 0 ? 0 : bytes / step; }  //!< points
};

/// Points with all their fields, laid out as in a PointCloud2.
struct FieldedCloud {
  std::vector<CloudField> fields;   //!< including x, y and z
  std::size_t step = 0;             //!< [bytes] from point to point
  std::vector<std::uint8_t> bytes;  //!< little endian, `step` per point

  std::size_t size() const { return step == 0 ? 0 : bytes.size() / step; }       //!< points
  CloudView view() const { return {fields, step, bytes.data(), bytes.size()}; }  //!< of this cloud
};

/// Only the positions of the points, NaN included.
/// @throw UnusableInput if x, y or z is missing or not float32, a field lies outside the point, or
/// the bytes are not a whole number of points
Cloud places_of(const CloudView& cloud);

/// Points with the fields of points of another cloud.
/// @param places positions of the points [m]
/// @param from [m] in its own frame
/// @param sources index in `from` of each point
/// @param motion from the frame of `from` to that of `places`. It is applied to the float32 fields
/// that are a place (vp_x, vp_y, vp_z: where the point was seen from) or a direction (normal_x,
/// normal_y, normal_z)
/// @throw UnusableInput as places_of()
FieldedCloud with_fields(const Cloud& places, const CloudView& from,
                         const std::vector<std::uint32_t>& sources,
                         const Eigen::Isometry3f& motion = Eigen::Isometry3f::Identity());

/// The bytes of a point.
using PointAt = std::function<const std::uint8_t*(std::size_t index)>;

/// Writes points, which need not be contiguous, as binary PLY or PCD, by the file's extension.
/// Writes in blocks, without a second cloud in memory. Whole or not at all.
/// @param metres_per_unit of the file; x, y and z, and vp_x, vp_y and vp_z, are metres in the cloud
/// @throw FileError if it cannot be written or the extension is neither
/// @throw UnusableInput if x, y or z is missing or not float32
void save_cloud(const std::string& path, const std::vector<CloudField>& fields, std::size_t points,
                const PointAt& at, double metres_per_unit = 1);

/// The same for a contiguous cloud.
/// @throw UnusableInput as places_of()
void save_cloud(const std::string& path, const CloudView& cloud, double metres_per_unit = 1);

/// As load_cloud_file(), with all fields of the points.
/// @param[out] carried of a PLY or PCD file: for each point x, y and z, then each other field that
/// has a single number of at most 32 bits, or a double; empty for other files. Positions are in
/// metres.
LoadedCloud load_cloud_file(const std::string& path, const CloudFormat& format,
                            FieldedCloud& carried);

}  // namespace scan_cell_common
