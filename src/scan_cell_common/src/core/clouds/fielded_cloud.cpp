// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/clouds/fielded_cloud.h"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

#include "clouds/cloud_writers.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

void check(const CloudView& cloud) {
  for (const CloudField& field : cloud.fields) {
    const std::size_t size = size_of(field.type);
    if (size == 0 || field.offset > cloud.step || size > cloud.step - field.offset) {
      throw UnusableInput("cloud: field " + field.name, "extends beyond the point",
                          "check the program that made the cloud");
    }
  }
  if (cloud.step == 0 ? cloud.bytes > 0 : cloud.bytes % cloud.step != 0) {
    throw UnusableInput("cloud: data",
                        fmt::format("{} bytes in points of {}", cloud.bytes, cloud.step),
                        "give whole points");
  }
  check_coordinates(cloud.fields);
}

Eigen::Vector3f read(const std::uint8_t* point, const std::vector<std::size_t>& offsets) {
  Eigen::Vector3f vector;
  for (std::size_t k = 0; k < 3; ++k)
    std::memcpy(&vector[static_cast<Eigen::Index>(k)], point + offsets[k], sizeof(float));
  return vector;
}

void write(const float* vector, const std::vector<std::size_t>& offsets, std::uint8_t* point) {
  for (std::size_t k = 0; k < 3; ++k)
    std::memcpy(point + offsets[k], vector + k, sizeof(float));
}

/// The fields that are transformed with a point between frames, besides its position.
class CarriedVectors {
 public:
  CarriedVectors(const std::vector<CloudField>& fields, const Eigen::Isometry3f& motion)
      : motion_(motion) {
    if (motion.matrix() == Eigen::Matrix4f::Identity()) return;
    for (const std::string& prefix : place_prefixes())
      if (!prefix.empty()) places_.push_back(offsets_of(fields, prefix));
    directions_.push_back(offsets_of(fields, "normal_"));
  }

  void move(std::uint8_t* point) const {
    for (const auto& offsets : places_)
      if (!offsets.empty()) write((motion_ * read(point, offsets)).eval().data(), offsets, point);
    for (const auto& offsets : directions_)
      if (!offsets.empty())
        write((motion_.linear() * read(point, offsets)).eval().data(), offsets, point);
  }

 private:
  const Eigen::Isometry3f motion_;
  std::vector<std::vector<std::size_t>> places_, directions_;
};

}  // namespace

Cloud places_of(const CloudView& cloud) {
  check(cloud);
  const std::vector<std::size_t> offsets = offsets_of(cloud.fields, "");
  Cloud result;
  result.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f place = read(cloud.data + i * cloud.step, offsets);
    result.push_back({place.x(), place.y(), place.z()});
  }
  return result;
}

FieldedCloud with_fields(const Cloud& places, const CloudView& from,
                         const std::vector<std::uint32_t>& sources,
                         const Eigen::Isometry3f& motion) {
  check(from);
  const std::vector<std::size_t> offsets = offsets_of(from.fields, "");
  const CarriedVectors carried(from.fields, motion);
  FieldedCloud result{from.fields, from.step, {}};
  result.bytes.resize(places.size() * from.step);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (sources.at(i) >= from.size()) throw std::out_of_range("source of a point");
    std::uint8_t* const point = &result.bytes[i * from.step];
    std::memcpy(point, from.data + sources[i] * from.step, from.step);
    write(places[i].data, offsets, point);
    carried.move(point);
  }
  return result;
}

void save_cloud(const std::string& path, const std::vector<CloudField>& fields, std::size_t points,
                const PointAt& at, double metres_per_unit) {
  write_cloud(path, {fields, points, 1, at}, metres_per_unit);
}

void save_cloud(const std::string& path, const CloudView& cloud, double metres_per_unit) {
  check(cloud);
  const auto at = [&cloud](std::size_t index) { return cloud.data + index * cloud.step; };
  write_cloud(path, {cloud.fields, cloud.size(), 1, at}, metres_per_unit);
}

}  // namespace scan_cell_common
