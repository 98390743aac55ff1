// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/cell_shapes.h"

#include <fmt/format.h>

#include <cmath>

#include "scan_cell_common/files/yaml_file.h"

namespace c4g_driver {
namespace {

using scan_cell_common::YamlEntry;

double positive(const YamlEntry& entry) {
  const double value = entry.as<double>();
  if (!(value > 0) || !std::isfinite(value))
    entry.refuse(fmt::format("{:g} m", value), "give metres above 0");
  return value;
}

template <int N>
Eigen::Matrix<double, N, 1> positives(const YamlEntry& entry) {
  const Eigen::Matrix<double, N, 1> values = entry.vector<N>();
  if (!(values.minCoeff() > 0))
    entry.refuse(fmt::format("{:g} m", values.minCoeff()), "give metres above 0");
  return values;
}

Eigen::Vector3d direction(const YamlEntry& entry) {
  const Eigen::Vector3d out = entry.vector<3>();
  constexpr double kLeast = 1e-6, kMost = 1e6;  // range in which a length can be computed exactly
  if (!(out.norm() > kLeast && out.norm() < kMost))
    entry.refuse("no direction", "give the normal that points out of the solid, such as [0, 0, 1]");
  return out.normalized();
}

void read_size(const YamlEntry& entry, CellShape& shape) {
  int kinds = 0;
  const auto take = [&](const char* key, CellShape::Kind kind, const auto& read) {
    if (!entry.has(key)) return;
    ++kinds;
    shape.kind = kind;
    shape.size = read(entry[key]);
  };
  take("sphere", CellShape::Kind::kSphere,
       [](const YamlEntry& size) { return Eigen::Vector3d(positive(size), 0, 0); });
  take("box", CellShape::Kind::kBox, [](const YamlEntry& size) { return positives<3>(size); });
  take("capsule", CellShape::Kind::kCapsule, [](const YamlEntry& size) {
    const Eigen::Vector2d both = positives<2>(size);
    return Eigen::Vector3d(both.x(), both.y(), 0);
  });
  take("half_space", CellShape::Kind::kHalfSpace, direction);
  if (kinds != 1) {
    entry.refuse(fmt::format("{} of sphere, box, capsule and half_space", kinds),
                 "give exactly one of them");
  }
}

CellShape read_shape(const YamlEntry& entry) {
  entry.refuse_unknown({"name", "frame", "pose", "sphere", "box", "capsule", "half_space"});
  CellShape shape;
  shape.name = entry["name"].as<std::string>();
  shape.frame = entry["frame"].as<std::string>();
  read_size(entry, shape);
  if (entry.has("pose")) shape.pose = entry["pose"].pose();
  if (shape.kind == CellShape::Kind::kHalfSpace && shape.frame != "base_link")
    entry["frame"].refuse("'" + shape.frame + "'", "give base_link: a half-space cannot move");
  return shape;
}

class Reader {
 public:
  explicit Reader(const YamlEntry& root) : root_(root) {
    root.refuse_unknown({"clearance", "shapes", "links", "may_touch"});
    if (root.has("clearance")) read_clearance(root["clearance"]);
    for (const YamlEntry& entry : list("shapes")) {
      result_.shapes.push_back(read_shape(entry));
      take_name(entry["name"]);
    }
    for (const YamlEntry& entry : list("links")) {
      entry.refuse_unknown({"link", "radius"});
      result_.links.push_back({entry["link"].as<std::string>(), positive(entry["radius"])});
      take_name(entry["link"]);
    }
    for (const YamlEntry& entry : list("may_touch"))
      read_pair(entry);
  }

  CellShapes take() { return std::move(result_); }

 private:
  std::vector<YamlEntry> list(const std::string& key) const {
    return root_.has(key) ? root_[key].elements() : std::vector<YamlEntry>();
  }

  void read_clearance(const YamlEntry& entry) {
    result_.clearance = entry.as<double>();
    if (!(result_.clearance >= 0) || !std::isfinite(result_.clearance))
      entry.refuse(fmt::format("{:g} m", result_.clearance), "give 0 m or more");
  }

  void take_name(const YamlEntry& entry) {
    const auto name = entry.as<std::string>();
    if (name.empty()) entry.refuse("empty", "give a name");
    if (!names_.insert(name).second)
      entry.refuse("'" + name + "' is already used", "give each shape its own name");
  }

  void read_pair(const YamlEntry& entry) {
    std::vector<std::string> pair;
    for (const YamlEntry& name : entry.elements()) {
      pair.push_back(name.as<std::string>());
      if (names_.count(pair.back()) == 0)
        name.refuse("'" + pair.back() + "'", "give names of shapes or links of this file, or part");
    }
    if (pair.size() != 2) entry.refuse(fmt::format("{} names", pair.size()), "give two");
    result_.may_touch.insert(std::minmax(pair[0], pair[1]));
  }

  const YamlEntry& root_;
  std::set<std::string> names_ = {"part"};
  CellShapes result_;
};

}  // namespace

CellShapes read_cell_shapes(const std::string& path) {
  return Reader(YamlEntry::load(path)).take();
}

CellShapes parse_cell_shapes(const std::string& text, const std::string& name) {
  return Reader(YamlEntry::parse(text, name)).take();
}

}  // namespace c4g_driver
