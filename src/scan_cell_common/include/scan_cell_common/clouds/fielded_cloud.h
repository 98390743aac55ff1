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

/// [bytes] of a value; 0 of what is no type
std::size_t size_of(FieldType type);

/// What each point of a cloud has under one name.
struct CloudField {
  std::string name;                      //!< such as x or intensity
  FieldType type = FieldType::kFloat32;  //!< of its one value
  std::size_t offset = 0;                //!< [bytes] from the point's begin
};

/// [bytes] from a point's begin to the float32 fields of a vector, such as vp_x, vp_y, vp_z; empty
/// where they are not there.
/// @param prefix of x, y and z
std::vector<std::size_t> offsets_of(const std::vector<CloudField>& fields,
                                    const std::string& prefix);

/// Points with all that they carry, where they lie.
struct CloudView {
  std::vector<CloudField> fields;      //!< x, y and z among them
  std::size_t step = 0;                //!< [bytes] from point to point
  const std::uint8_t* data = nullptr;  //!< little endian
  std::size_t bytes = 0;               //!< of data; step a point

  std::size_t size() const { return step == 0 ? 0 : bytes / step; }  //!< points
};

/// Points with all that they carry, as they lie in a PointCloud2.
struct FieldedCloud {
  std::vector<CloudField> fields;   //!< x, y and z among them
  std::size_t step = 0;             //!< [bytes] from point to point
  std::vector<std::uint8_t> bytes;  //!< little endian, step a point

  std::size_t size() const { return step == 0 ? 0 : bytes.size() / step; }       //!< points
  CloudView view() const { return {fields, step, bytes.data(), bytes.size()}; }  //!< of these
};

/// Places alone, NaN included.
/// @throw UnusableInput if x, y or z is missing or no float32, a field lies outside of the point,
/// or the bytes are no whole points
Cloud places_of(const CloudView& cloud);

/// Points with what they carry from the points of another cloud.
/// @param places of the points that are wanted [m]
/// @param from [m] in its own frame
/// @param sources index in `from`, a point
/// @param motion from the frame of `from` to that of `places`: what a point carries as a place
/// (vp_x, vp_y, vp_z: where it was seen from) or a direction (normal_x, normal_y, normal_z) goes
/// with it, where it is float32
/// @throw UnusableInput as places_of()
FieldedCloud with_fields(const Cloud& places, const CloudView& from,
                         const std::vector<std::uint32_t>& sources,
                         const Eigen::Isometry3f& motion = Eigen::Isometry3f::Identity());

/// The bytes of a point.
using PointAt = std::function<const std::uint8_t*(std::size_t index)>;

/// Writes points that need not lie one behind the other as binary PLY or PCD, by the file's ending,
/// in blocks: that takes no second cloud. Whole or not at all.
/// @param metres_per_unit of the file; x, y and z, and vp_x, vp_y and vp_z, are metres in the cloud
/// @throw FileError if it cannot be written or the ending is neither
/// @throw UnusableInput if x, y or z is missing or no float32
void save_cloud(const std::string& path, const std::vector<CloudField>& fields, std::size_t points,
                const PointAt& at, double metres_per_unit = 1);

/// The same for a cloud in one piece.
/// @throw UnusableInput as places_of()
void save_cloud(const std::string& path, const CloudView& cloud, double metres_per_unit = 1);

/// As load_cloud_file(), with all that the points carry.
/// @param[out] carried of a PLY or PCD file, one a point: x, y and z, then each other field that
/// has one number of at most 32 bit, or a double; empty of other files. Places are in metres.
LoadedCloud load_cloud_file(const std::string& path, const CloudFormat& format,
                            FieldedCloud& carried);

}  // namespace scan_cell_common
