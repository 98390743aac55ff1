// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "files/scalars.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

// PCL's writers would link VTK and OpenNI into every program that reads or writes a cloud.

namespace scan_cell_common {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "both formats are written as they lie");

struct TypeNames {
  std::size_t size;  // [bytes]
  const char* ply;
  char pcd;
};

TypeNames names_of(FieldType type) {
  constexpr std::array<TypeNames, 9> kNames = {{{0, "", ' '},
                                                {1, "char", 'I'},
                                                {1, "uchar", 'U'},
                                                {2, "short", 'I'},
                                                {2, "ushort", 'U'},
                                                {4, "int", 'I'},
                                                {4, "uint", 'U'},
                                                {4, "float", 'F'},
                                                {8, "double", 'F'}}};
  const auto index = static_cast<std::size_t>(type);
  return kNames.at(index < kNames.size() ? index : 0);
}

std::string ply_header(const PointsToWrite& points) {
  std::string header = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n",
                                   points.width * points.height);
  for (const CloudField& field : points.fields)
    header += fmt::format("property {} {}\n", names_of(field.type).ply, field.name);
  return header + "end_header\n";
}

std::string pcd_header(const PointsToWrite& points) {
  std::string fields, sizes, types, counts;
  for (const CloudField& field : points.fields) {
    fields += " " + field.name;
    sizes += fmt::format(" {}", size_of(field.type));
    types += fmt::format(" {}", names_of(field.type).pcd);
    counts += " 1";
  }
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\n"
      "WIDTH {}\nHEIGHT {}\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
      fields, sizes, types, counts, points.width, points.height, points.width * points.height);
}

void append_length(const std::uint8_t* metres, double per_metre, std::string& bytes) {
  float value = 0;
  std::memcpy(&value, metres, sizeof value);
  value = to_float(static_cast<double>(value) * per_metre);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// How one field of each point is written.
struct Column {
  std::size_t offset;  // [bytes] in a point
  std::size_t size;    // [bytes]
  bool is_scaled;      // a length in a unit other than metres
};

std::vector<Column> columns_of(const std::vector<CloudField>& fields, double metres_per_unit) {
  std::vector<std::size_t> lengths;
  for (const std::string& prefix : place_prefixes()) {
    const std::vector<std::size_t> place = offsets_of(fields, prefix);
    if (metres_per_unit != 1) lengths.insert(lengths.end(), place.begin(), place.end());
  }
  std::vector<Column> columns;
  for (const CloudField& field : fields) {
    const bool is_scaled = std::find(lengths.begin(), lengths.end(), field.offset) != lengths.end();
    columns.push_back({field.offset, size_of(field.type), is_scaled});
  }
  return columns;
}

/// Writes the fields one after the other, without the gaps between them in memory. Writes in
/// blocks, since the cloud may take most of the memory.
void write_points(std::ostream& file, const PointsToWrite& points, double metres_per_unit) {
  constexpr std::size_t kAtOnce = 65536;
  const double per_metre = 1 / metres_per_unit;
  const std::vector<Column> columns = columns_of(points.fields, metres_per_unit);
  std::string bytes;
  const std::size_t count = points.width * points.height;
  for (std::size_t begin = 0; begin < count && file; begin += kAtOnce) {
    bytes.clear();
    for (std::size_t i = begin; i < std::min(begin + kAtOnce, count); ++i) {
      const std::uint8_t* const point = points.at(i);
      for (const Column& column : columns) {
        const std::uint8_t* const value = point + column.offset;
        if (column.is_scaled) {
          append_length(value, per_metre, bytes);
        } else {
          bytes.append(reinterpret_cast<const char*>(value), column.size);
        }
      }
    }
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

}  // namespace

std::size_t size_of(FieldType type) {
  return names_of(type).size;
}

const std::vector<std::string>& place_prefixes() {
  static const std::vector<std::string> prefixes = {"", "vp_"};
  return prefixes;
}

std::vector<std::size_t> offsets_of(const std::vector<CloudField>& fields,
                                    const std::string& prefix) {
  std::vector<std::size_t> offsets;
  for (const char* const axis : {"x", "y", "z"}) {
    for (const CloudField& field : fields) {
      if (field.name != prefix + axis || field.type != FieldType::kFloat32) continue;
      offsets.push_back(field.offset);
      break;
    }
  }
  if (offsets.size() < 3) offsets.clear();
  return offsets;
}

void check_coordinates(const std::vector<CloudField>& fields) {
  for (const std::string name : {"x", "y", "z"}) {
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const CloudField& each) { return each.name == name; });
    if (field == fields.end())
      throw UnusableInput("cloud: field " + name, "missing", "give a cloud with x, y and z");
    if (field->type != FieldType::kFloat32)
      throw UnusableInput("cloud: field " + name, "not float32", "give x, y and z as float32");
  }
}

void write_cloud(const std::string& path, const PointsToWrite& points, double metres_per_unit) {
  check_cloud_output(path);
  check_coordinates(points.fields);
  const bool ply = extension_of(path) == ".ply";
  save_whole(path, [&](const std::string& partial) {
    std::ofstream file(partial, std::ios::binary);
    file << (ply ? ply_header(points) : pcd_header(points));
    write_points(file, points, metres_per_unit);
    file.close();
    return !file.fail();
  });
}

}  // namespace scan_cell_common
