// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/clouds/fielded_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace scan_cell_common {
namespace {

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

const CloudField& coordinate(const FieldedCloud& cloud, const std::string& name) {
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [&](const CloudField& each) { return each.name == name; });
  if (field == cloud.fields.end())
    throw UnusableInput("cloud: field " + name, "missing", "give a cloud with x, y and z");
  if (field->type != FieldType::kFloat32)
    throw UnusableInput("cloud: field " + name, "no float32", "give x, y and z as float32");
  return *field;
}

void check(const FieldedCloud& cloud) {
  for (const CloudField& field : cloud.fields) {
    const std::size_t size = size_of(field.type);
    if (size == 0 || field.offset > cloud.step || size > cloud.step - field.offset) {
      throw UnusableInput("cloud: field " + field.name, "not within the point",
                          "check the program that made the cloud");
    }
  }
  if (cloud.step == 0 ? !cloud.bytes.empty() : cloud.bytes.size() % cloud.step != 0) {
    throw UnusableInput("cloud: data",
                        fmt::format("{} bytes in points of {}", cloud.bytes.size(), cloud.step),
                        "give whole points");
  }
}

std::array<std::size_t, 3> place_offsets(const FieldedCloud& cloud) {
  check(cloud);
  return {coordinate(cloud, "x").offset, coordinate(cloud, "y").offset,
          coordinate(cloud, "z").offset};
}

std::string ply_header(const FieldedCloud& cloud) {
  std::string header =
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", cloud.size());
  for (const CloudField& field : cloud.fields)
    header += fmt::format("property {} {}\n", names_of(field.type).ply, field.name);
  return header + "end_header\n";
}

std::string pcd_header(const FieldedCloud& cloud) {
  std::string fields, sizes, types, counts;
  for (const CloudField& field : cloud.fields) {
    fields += " " + field.name;
    sizes += fmt::format(" {}", size_of(field.type));
    types += fmt::format(" {}", names_of(field.type).pcd);
    counts += " 1";
  }
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\n"
      "WIDTH {}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
      fields, sizes, types, counts, cloud.size(), cloud.size());
}

/// The fields one behind the other, without what lies between them in memory.
void write_points(std::ostream& file, const FieldedCloud& cloud, double metres_per_unit) {
  const std::array<std::size_t, 3> places = place_offsets(cloud);
  constexpr std::size_t kAtOnce = 65536;  // points; chosen: the cloud may take most of the memory
  std::string bytes;
  std::vector<std::uint8_t> point(cloud.step);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::memcpy(point.data(), &cloud.bytes[i * cloud.step], cloud.step);
    for (const std::size_t offset : places) {
      float value = 0;
      std::memcpy(&value, &point[offset], sizeof value);
      value = static_cast<float>(static_cast<double>(value) / metres_per_unit);
      std::memcpy(&point[offset], &value, sizeof value);
    }
    for (const CloudField& field : cloud.fields)
      bytes.append(reinterpret_cast<const char*>(&point[field.offset]), size_of(field.type));
    if (i % kAtOnce != kAtOnce - 1 && i + 1 != cloud.size()) continue;
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.clear();
  }
}

}  // namespace

std::size_t size_of(FieldType type) {
  return names_of(type).size;
}

Cloud places_of(const FieldedCloud& cloud) {
  const std::array<std::size_t, 3> places = place_offsets(cloud);
  Cloud result;
  result.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::array<float, 3> p{};
    for (std::size_t k = 0; k < 3; ++k)
      std::memcpy(&p[k], &cloud.bytes[i * cloud.step + places[k]], sizeof(float));
    result.push_back({p[0], p[1], p[2]});
  }
  return result;
}

FieldedCloud with_fields(const Cloud& places, const FieldedCloud& from,
                         const std::vector<std::uint32_t>& sources) {
  const std::array<std::size_t, 3> offsets = place_offsets(from);
  FieldedCloud result{from.fields, from.step, {}};
  result.bytes.resize(places.size() * from.step);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::uint8_t* const point = &result.bytes[i * from.step];
    std::memcpy(point, &from.bytes.at(sources.at(i) * from.step), from.step);
    for (std::size_t k = 0; k < 3; ++k)
      std::memcpy(point + offsets[k], &places[i].data[k], sizeof(float));
  }
  return result;
}

void save_cloud(const std::string& path, const FieldedCloud& cloud, double metres_per_unit) {
  check_cloud_output(path);
  check(cloud);
  const bool ply = extension_of(path) == ".ply";
  save_whole(path, [&](const std::string& partial) {
    std::ofstream file(partial, std::ios::binary);
    file << (ply ? ply_header(cloud) : pcd_header(cloud));
    write_points(file, cloud, metres_per_unit);
    file.close();
    return !file.fail();
  });
}

}  // namespace scan_cell_common
