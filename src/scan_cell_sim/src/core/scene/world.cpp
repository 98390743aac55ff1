// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scan_cell_common/files/yaml_file.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector3d;
using scan_cell_common::UnusableInput;
using scan_cell_common::YamlEntry;

double number(const YamlEntry& entry, double least, double most) {
  const auto value = entry.as<double>();
  if (!(value >= least) || !(value <= most)) {
    entry.refuse(fmt::format("{:g}", value), fmt::format("give {:g} .. {:g}", least, most));
  }
  return value;
}

void read(const YamlEntry& map, const std::string& key, double& value, double least, double most) {
  if (map.has(key)) value = number(map[key], least, most);
}

Vector3d direction(const YamlEntry& entry) {
  const Vector3d value = entry.vector<3>();
  if (!(value.norm() > 0)) entry.refuse("zero", "give a direction");
  return value.normalized();
}

template <int N>
Eigen::Matrix<double, N, 1> lengths(const YamlEntry& entry, double least) {
  const Eigen::Matrix<double, N, 1> value = entry.vector<N>();
  if (!(value.minCoeff() >= least)) {
    entry.refuse(fmt::format("a length of {:g} m", value.minCoeff()),
                 fmt::format("give at least {:g} m", least));
  }
  return value;
}

constexpr double kMinRadius = 0.001;  // [m] chosen
constexpr double kMaxRadius = 1;      // [m] chosen
constexpr double kMaxShift = 0.05;    // [m] chosen

Bulge read_bulge(const YamlEntry& entry) {
  entry.refuse_unknown({"kind", "centre", "towards", "radius", "height"});
  Bulge bulge;
  bulge.centre = entry["centre"].vector<3>();
  if (entry.has("towards")) bulge.towards = direction(entry["towards"]);
  bulge.radius = number(entry["radius"], kMinRadius, kMaxRadius);
  bulge.height = number(entry["height"], -kMaxShift, kMaxShift);
  return bulge;
}

Bend read_bend(const YamlEntry& entry) {
  entry.refuse_unknown({"kind", "along", "towards", "curvature"});
  constexpr double kMaxCurvature = 10;  // [1/m] chosen
  return {direction(entry["along"]), direction(entry["towards"]),
          number(entry["curvature"], -kMaxCurvature, kMaxCurvature)};
}

FiledEdge read_filed_edge(const YamlEntry& entry) {
  entry.refuse_unknown({"kind", "from", "to", "towards", "radius", "depth"});
  FiledEdge edge{entry["from"].vector<3>(), entry["to"].vector<3>(), direction(entry["towards"]),
                 number(entry["radius"], kMinRadius, kMaxRadius),
                 number(entry["depth"], 0, kMaxShift)};
  if (!((edge.to - edge.from).norm() > 0))
    entry["to"].refuse("the same as from", "give another point");
  return edge;
}

Deformation::Term read_term(const YamlEntry& entry) {
  const auto kind = entry["kind"].as<std::string>();
  if (kind == "bulge") return read_bulge(entry);
  if (kind == "bend") return read_bend(entry);
  if (kind == "filed_edge") return read_filed_edge(entry);
  entry["kind"].refuse(kind, "give bulge, bend or filed_edge");
}

FrameShape read_frame(const YamlEntry& entry) {
  constexpr double kMinOutside = 0.1;  // [m] chosen: hanger and opening fit
  FrameShape frame;
  if (entry.has("size")) frame.size = lengths<2>(entry["size"], kMinOutside);
  if (!entry.has("sheet")) return frame;
  const YamlEntry sheet = entry["sheet"];
  sheet.refuse_unknown({"height", "bulge"});
  frame.sheet = Sheet{};
  read(sheet, "height", frame.sheet->height, 0, kMaxShift);
  read(sheet, "bulge", frame.sheet->bulge, -kMaxShift, kMaxShift);
  return frame;
}

BoxShape read_box(const YamlEntry& entry) {
  constexpr double kMinSide = 0.001;  // [m] chosen
  BoxShape box;
  if (entry.has("size")) box.size = lengths<3>(entry["size"], kMinSide);
  if (entry.has("sheet")) entry["sheet"].refuse("in a box", "only a frame can hold a sheet");
  return box;
}

/// @throw UnusableInput if the pipe would run into itself on the inside of its bend
ElbowShape read_elbow(const YamlEntry& entry) {
  constexpr double kMinInside = 0.005;  // [m] radius on the inside of the bend; chosen
  ElbowShape elbow;
  if (entry.has("sheet")) entry["sheet"].refuse("in an elbow", "only a frame can hold a sheet");
  if (!entry.has("size")) return elbow;
  const Eigen::Vector3d size = lengths<3>(entry["size"], 0.001);
  elbow = {size.x(), size.y(), size.z()};
  if (elbow.bend_radius - elbow.pipe_radius < kMinInside) {
    entry["size"].refuse("the bend is too tight for the pipe",
                         "give [pipe radius, bend radius, leg], the second 5 mm above the first");
  }
  return elbow;
}

Shape read_shape(const YamlEntry& entry) {
  const auto shape = entry["shape"].as<std::string>();
  if (shape == "frame") return read_frame(entry);
  if (shape == "box") return read_box(entry);
  if (shape == "elbow") return read_elbow(entry);
  entry["shape"].refuse(shape, "give frame, box or elbow");
}

Part read_part(const YamlEntry& entry) {
  entry.refuse_unknown(
      {"name", "shape", "size", "sheet", "pose", "scale", "reflectance", "deformations"});
  Part part;
  part.name = entry["name"].as<std::string>();
  part.shape = read_shape(entry);
  if (entry.has("pose")) part.pose = entry["pose"].pose();
  constexpr double kMinScale = 0.1, kMaxScale = 10;  // chosen
  read(entry, "scale", part.scale, kMinScale, kMaxScale);
  read(entry, "reflectance", part.reflectance, 0, 1);
  if (entry.has("deformations")) {
    for (const YamlEntry& term : entry["deformations"].elements()) {
      part.deformation.add(read_term(term));
    }
  }
  return part;
}

Floor read_floor(const YamlEntry& entry) {
  entry.refuse_unknown({"height", "size", "reflectance"});
  Floor floor;
  constexpr double kMaxHeight = 2, kMinSize = 0.01;  // [m] chosen
  read(entry, "height", floor.height, -kMaxHeight, kMaxHeight);
  if (entry.has("size")) floor.size = lengths<2>(entry["size"], kMinSize);
  read(entry, "reflectance", floor.reflectance, 0, 1);
  return floor;
}

Checkerboard read_board(const YamlEntry& entry) {
  entry.refuse_unknown({"inner_corners", "square_size", "margin", "white", "black", "pose"});
  constexpr double kMaxCorners = 200;                   // along a side; chosen
  constexpr double kMinSquare = 0.001, kMaxSquare = 1;  // [m] chosen
  constexpr double kMaxMargin = 1;                      // [m] chosen
  Checkerboard board;
  const Eigen::Vector2d corners = entry["inner_corners"].vector<2>();
  if (!(corners.minCoeff() >= 2) || !(corners.maxCoeff() <= kMaxCorners) ||
      corners != corners.array().round().matrix()) {
    entry["inner_corners"].refuse("no such board", "give [columns, rows], whole numbers from 2");
  }
  board.columns = static_cast<int>(corners.x());
  board.rows = static_cast<int>(corners.y());
  board.square_size = number(entry["square_size"], kMinSquare, kMaxSquare);
  read(entry, "margin", board.margin, 0, kMaxMargin);
  read(entry, "white", board.white, 0, 1);
  read(entry, "black", board.black, 0, 1);
  if (entry.has("pose")) board.pose = entry["pose"].pose();
  return board;
}

}  // namespace

const Part& World::part(const std::string& name) const {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&name](const Part& part) { return part.name == name; });
  if (found != parts.end()) return *found;
  std::string names;
  for (const Part& part : parts)
    names += (names.empty() ? "" : ", ") + part.name;
  throw UnusableInput("part", name, "this world has: " + (names.empty() ? "none" : names));
}

World load_world(const std::string& path) {
  const YamlEntry root = YamlEntry::load(path);
  root.refuse_unknown({"floor", "board", "parts"});
  World world;
  if (root.has("floor")) world.floor = read_floor(root["floor"]);
  if (root.has("board")) world.board = read_board(root["board"]);
  std::set<std::string> names;
  if (root.has("parts")) {
    for (const YamlEntry& entry : root["parts"].elements()) {
      world.parts.push_back(read_part(entry));
      if (!names.insert(world.parts.back().name).second) {
        entry["name"].refuse(world.parts.back().name, "give each part a different name");
      }
    }
  }
  return world;
}

}  // namespace scan_cell_sim
