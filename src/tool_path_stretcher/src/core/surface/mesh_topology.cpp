// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/mesh_topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "surface/mesh_sides.h"

namespace tool_path_stretcher {
namespace {

/// The edges along which more triangles run one way than the other: there the mesh ends, or its
/// triangles disagree.
struct MeshBorder {
  std::multimap<std::uint32_t, std::uint32_t> edges;  // as many begin at each vertex as end there
  bool alike = true;                                  // the mesh ends at all of them
};

MeshBorder border_of(const std::vector<Side>& sides) {
  MeshBorder border;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for_each_edge(sides, [&](auto first, auto last) {
    const auto forth = std::count_if(first, last, [](const Side& each) { return each.forward; });
    const auto over = 2 * forth - (last - first);
    const auto [from, to] =
        over > 0 ? std::pair(first->low, first->high) : std::pair(first->high, first->low);
    edges.insert(edges.end(), static_cast<std::size_t>(std::abs(over)), {from, to});
    border.alike = border.alike && std::abs(over) < 2;
  });
  std::sort(edges.begin(),
            edges.end());  // makes the lines of a border independent of the order of triangles
  border.edges.insert(edges.begin(), edges.end());
  return border;
}

/// [m^2] twice the area spanned by each line of a border; zero for a crack, whose sides run there
/// and back.
double twice_open_area(const Points& vertices, MeshBorder border) {
  double sum = 0;
  while (!border.edges.empty()) {
    const Eigen::Vector3d& origin = vertices[border.edges.begin()->first];
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (auto edge = border.edges.begin(); edge != border.edges.end();) {
      const std::uint32_t to = edge->second;
      area += (vertices[edge->first] - origin).cross(vertices[to] - origin);
      border.edges.erase(edge);
      edge = border.edges.find(to);
    }
    sum += area.norm();
  }
  return sum;
}

/// [m^3] six times the enclosed volume; below 0 if the triangles are wound inside out.
double enclosed(const Points& vertices, const std::vector<Triangle>& triangles) {
  const Eigen::Vector3d& origin = vertices[triangles.front()[0]];
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += (vertices[a] - origin).dot((vertices[b] - origin).cross(vertices[c] - origin));
  return sum;
}

}  // namespace

MeshTopology topology_of(const Points& vertices, const std::vector<Triangle>& triangles,
                         double area) {
  constexpr double kOpen = 0.02;  // of the area, in holes; chosen
  const MeshBorder border = border_of(sides_of(triangles));
  MeshTopology topology;
  topology.closed = twice_open_area(vertices, border) <= 2 * kOpen * area;
  topology.oriented = topology.closed || border.alike;
  topology.inside_out = topology.closed && enclosed(vertices, triangles) < 0;
  return topology;
}

}  // namespace tool_path_stretcher
