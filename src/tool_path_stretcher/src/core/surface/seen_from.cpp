// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/seen_from.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "scan_cell_common/clouds/fielded_cloud.h"

namespace tool_path_stretcher {
namespace {

constexpr double kApart = 0.94;  // cosine: 20 degrees; chosen: what is hidden changes little within

struct Cluster {
  Eigen::Vector3d sum;
  std::size_t count = 0;
};

/// Three float32 fields of a cloud.
class VectorField {
 public:
  VectorField(const scan_cell_common::CloudView& cloud, const std::string& prefix) : cloud_(cloud) {
    const std::array<std::string, 3> names = {prefix + "x", prefix + "y", prefix + "z"};
    for (std::size_t axis = 0; axis < names.size(); ++axis) {
      const auto found = std::find_if(
          cloud.fields.begin(), cloud.fields.end(),
          [&](const scan_cell_common::CloudField& field) { return field.name == names[axis]; });
      if (found == cloud.fields.end() || found->type != scan_cell_common::FieldType::kFloat32)
        return;
      offsets_[axis] = found->offset;
    }
    is_there_ = true;
  }

  bool is_there() const { return is_there_; }

  Eigen::Vector3d at(std::size_t point) const {
    Eigen::Vector3d result;
    for (std::size_t axis = 0; axis < offsets_.size(); ++axis) {
      float value = 0;
      std::memcpy(&value, cloud_.data + point * cloud_.step + offsets_[axis], sizeof value);
      result[static_cast<Eigen::Index>(axis)] = static_cast<double>(value);
    }
    return result;
  }

 private:
  const scan_cell_common::CloudView& cloud_;
  std::array<std::size_t, 3> offsets_{};
  bool is_there_ = false;
};

}  // namespace

Points directions_seen_from(const Points& points, const Points& viewers) {
  constexpr double kFew = 0.02;  // of the points; chosen
  std::vector<Cluster> clusters;
  std::size_t all = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d way = viewers[i] - points[i];
    if (!way.allFinite() || way.isZero()) continue;
    const Eigen::Vector3d direction = way.normalized();
    auto cluster = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& each) {
      return each.sum.normalized().dot(direction) > kApart;
    });
    if (cluster == clusters.end())
      cluster = clusters.insert(cluster, {direction, 0});
    else
      cluster->sum += direction;
    ++cluster->count;
    ++all;
  }
  Points result;
  for (const Cluster& cluster : clusters) {
    if (static_cast<double>(cluster.count) >= kFew * static_cast<double>(all))
      result.push_back(cluster.sum.normalized());
  }
  return result;
}

Points directions_seen_from(const scan_cell_common::CloudView& cloud) {
  constexpr std::size_t kLooked = 20000;  // points, evenly through the cloud; chosen
  const VectorField place(cloud, ""), viewer(cloud, "vp_");
  if (!place.is_there() || !viewer.is_there()) return {};
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / kLooked);
  Points points, viewers;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    points.push_back(place.at(i));
    viewers.push_back(viewer.at(i));
  }
  return directions_seen_from(points, viewers);
}

}  // namespace tool_path_stretcher
