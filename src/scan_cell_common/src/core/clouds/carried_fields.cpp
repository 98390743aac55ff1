// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/carried_fields.h"

#include <algorithm>
#include <cmath>

namespace scan_cell_common {
namespace {

template <class Number>
void append(Number number, FieldedCloud& cloud) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&number);
  cloud.bytes.insert(cloud.bytes.end(), bytes, bytes + sizeof number);
}

template <class Whole>
void append_whole(double value, FieldedCloud& cloud) {
  constexpr auto kLeast = static_cast<double>(std::numeric_limits<Whole>::min());
  constexpr auto kMost = static_cast<double>(std::numeric_limits<Whole>::max());
  append(static_cast<Whole>(std::isnan(value) ? 0 : std::clamp(std::round(value), kLeast, kMost)),
         cloud);
}

}  // namespace

bool add_field(FieldedCloud& cloud, const std::string& name, Scalar type) {
  for (const CloudField& field : cloud.fields)
    if (field.name == name) return false;
  // Both count the types in the same order; a PointField begins with 1.
  const auto field_type = static_cast<FieldType>(static_cast<int>(type) + 1);
  cloud.fields.push_back({name, field_type, cloud.step});
  cloud.step += size_of(type);
  return true;
}

void add_coordinates(FieldedCloud& cloud) {
  for (const char* const name : {"x", "y", "z"})
    add_field(cloud, name, Scalar::kFloat);
}

void append_scalar(const char* bytes, Scalar type, bool big_endian, FieldedCloud& cloud) {
  const std::size_t size = size_of(type);
  for (std::size_t i = 0; i < size; ++i)
    cloud.bytes.push_back(static_cast<std::uint8_t>(bytes[big_endian ? size - 1 - i : i]));
}

void append_scalar(double value, Scalar type, FieldedCloud& cloud) {
  switch (type) {
    case Scalar::kInt8:
      return append_whole<std::int8_t>(value, cloud);
    case Scalar::kUint8:
      return append_whole<std::uint8_t>(value, cloud);
    case Scalar::kInt16:
      return append_whole<std::int16_t>(value, cloud);
    case Scalar::kUint16:
      return append_whole<std::uint16_t>(value, cloud);
    case Scalar::kInt32:
      return append_whole<std::int32_t>(value, cloud);
    case Scalar::kUint32:
      return append_whole<std::uint32_t>(value, cloud);
    case Scalar::kFloat:
      return append(to_float(value), cloud);
    case Scalar::kDouble:
      return append(value, cloud);
  }
}

void append_place(const pcl::PointXYZ& point, FieldedCloud& cloud) {
  for (const float coordinate : {point.x, point.y, point.z})
    append(coordinate, cloud);
}

}  // namespace scan_cell_common
