// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "cloud_preprocess/cloud_edits.h"
#include "edits/shapes.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/pose/unit_quaternion.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::yaml_list;
using scan_cell_common::YamlEntry;

double positive(const YamlEntry& entry) {
  const auto value = entry.as<double>();
  if (!(value > 0 && std::isfinite(value)))
    entry.refuse(std::to_string(value), "give metres above 0");
  return value;
}

std::vector<Eigen::Vector3d> places(const YamlEntry& list, std::size_t least) {
  std::vector<Eigen::Vector3d> all;
  for (const YamlEntry& entry : list.elements())
    all.push_back(entry.vector<3>());
  if (all.size() < least)
    list.refuse(std::to_string(all.size()) + " places", "give at least " + std::to_string(least));
  return all;
}

BoxShape read_box(const YamlEntry& entry) {
  entry.refuse_unknown({"center", "size", "rotation"});
  BoxShape box;
  box.pose.translation() = entry["center"].vector<3>();
  box.size = entry["size"].vector<3>();
  if (!(box.size.minCoeff() > 0)) entry["size"].refuse("not above 0", "give metres");
  if (!entry.has("rotation")) return box;
  const Eigen::Vector4d numbers = entry["rotation"].vector<4>();
  const Eigen::Quaterniond rotation(numbers[3], numbers[0], numbers[1], numbers[2]);
  if (!scan_cell_common::is_unit(rotation))
    entry["rotation"].refuse(scan_cell_common::quaternion_fault(rotation),
                             scan_cell_common::kGiveUnitQuaternion);
  box.pose.linear() = rotation.normalized().toRotationMatrix();
  return box;
}

HalfSpace read_plane(const YamlEntry& entry) {
  entry.refuse_unknown({"point", "normal"});
  return {entry["point"].vector<3>(), entry["normal"].direction()};
}

PrismShape read_polygon(const YamlEntry& entry) {
  entry.refuse_unknown({"corners", "towards", "depth"});
  PrismShape prism;
  prism.corners = places(entry["corners"], 3);
  prism.towards = entry["towards"].direction();
  const Eigen::Vector2d depth = entry["depth"].vector<2>();
  if (!(depth[0] < depth[1])) entry["depth"].refuse("no depth", "give the nearer one first");
  prism.nearest = depth[0];
  prism.farthest = depth[1];
  return prism;
}

BrushShape read_brush(const YamlEntry& entry) {
  entry.refuse_unknown({"places", "radius"});
  return {places(entry["places"], 1), positive(entry["radius"])};
}

ClusterShape read_cluster(const YamlEntry& entry) {
  entry.refuse_unknown({"at", "gap"});
  return {entry["at"].vector<3>(), positive(entry["gap"])};
}

CloudEdit read_edit(const YamlEntry& entry) {
  entry.refuse_unknown({"delete", "keep"});
  CloudEdit edit;
  edit.keep = entry.has("keep");
  if (edit.keep == entry.has("delete"))
    entry.refuse("neither or both", "give delete or keep, with a shape");
  const YamlEntry shape = entry[edit.keep ? "keep" : "delete"];
  shape.refuse_unknown({"box", "plane", "polygon", "brush", "cluster"});
  int shapes = 0;
  const auto take = [&](const char* name, const auto& read) {
    if (!shape.has(name)) return;
    edit.shape = read(shape[name]);
    ++shapes;
  };
  take("box", read_box);
  take("plane", read_plane);
  take("polygon", read_polygon);
  take("brush", read_brush);
  take("cluster", read_cluster);
  if (shapes != 1)
    shape.refuse(std::to_string(shapes) + " shapes",
                 "give one of box, plane, polygon, brush and cluster");
  return edit;
}

YAML::Node list_of(const std::vector<Eigen::Vector3d>& places) {
  YAML::Node list(YAML::NodeType::Sequence);
  for (const Eigen::Vector3d& place : places)
    list.push_back(yaml_list(place));
  return list;
}

YAML::Node node_of(const BoxShape& box) {
  YAML::Node node;
  node["center"] = yaml_list(box.pose.translation());
  node["size"] = yaml_list(box.size);
  node["rotation"] = yaml_list(Eigen::Quaterniond(box.pose.linear()).coeffs());
  return node;
}

YAML::Node node_of(const HalfSpace& half) {
  YAML::Node node;
  node["point"] = yaml_list(half.point);
  node["normal"] = yaml_list(half.normal);
  return node;
}

YAML::Node node_of(const PrismShape& prism) {
  YAML::Node node;
  node["corners"] = list_of(prism.corners);
  node["towards"] = yaml_list(prism.towards);
  node["depth"] = yaml_list(Eigen::Vector2d(prism.nearest, prism.farthest));
  return node;
}

YAML::Node node_of(const BrushShape& brush) {
  YAML::Node node;
  node["places"] = list_of(brush.places);
  node["radius"] = brush.radius;
  return node;
}

YAML::Node node_of(const ClusterShape& cluster) {
  YAML::Node node;
  node["at"] = yaml_list(cluster.place);
  node["gap"] = cluster.gap;
  return node;
}

}  // namespace

std::vector<CloudEdit> read_edits(const YamlEntry& list) {
  std::vector<CloudEdit> edits;
  for (const YamlEntry& entry : list.elements())
    edits.push_back(read_edit(entry));
  return edits;
}

std::vector<CloudEdit> load_edits(const std::string& path) {
  const YamlEntry root = YamlEntry::load(path);
  root.refuse_unknown({"edits"});
  return read_edits(root["edits"]);
}

std::string to_yaml(const std::vector<CloudEdit>& edits) {
  YAML::Node root;
  root["edits"] = YAML::Node(YAML::NodeType::Sequence);
  for (const CloudEdit& edit : edits) {
    YAML::Node node;
    node[edit.keep ? "keep" : "delete"][name_of(edit)] =
        std::visit([](const auto& shape) { return node_of(shape); }, edit.shape);
    root["edits"].push_back(node);
  }
  YAML::Emitter out;
  out << root;
  return std::string(out.c_str()) + "\n";
}

}  // namespace cloud_preprocess
