// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/mesh_topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

namespace tool_path_stretcher {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The directed edges of all triangles, sorted.
std::vector<Edge> edges_of(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(triangles.size() * 3);
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i)
      edges.emplace_back(triangle[i], triangle[(i + 1) % 3]);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Where more triangles run along an edge one way than the other: there the mesh ends, or its
/// triangles do not agree.
struct MeshBorder {
  std::multimap<std::uint32_t, std::uint32_t> edges;  // so many begin at each vertex as end there
  bool alike = true;                                  // the mesh ends wherever they are
};

MeshBorder border_of(const std::vector<Edge>& edges) {
  MeshBorder border;
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto end = std::upper_bound(edge, edges.end(), *edge);
    const auto [back, back_end] =
        std::equal_range(edges.begin(), edges.end(), Edge(edge->second, edge->first));
    const auto over = (end - edge) - (back_end - back);
    for (auto i = over; i > 0; --i)
      border.edges.insert(*edge);
    border.alike = border.alike && over < 2;
    edge = end;
  }
  return border;
}

/// [m^2] twice the area that spans each line of a border: nothing for a crack, whose sides run
/// there and back.
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

/// [m^3] six times what the triangles enclose; below 0 where they are wound the wrong way round.
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
  const MeshBorder border = border_of(edges_of(triangles));
  MeshTopology topology;
  topology.closed = twice_open_area(vertices, border) <= 2 * kOpen * area;
  topology.oriented = topology.closed || border.alike;
  topology.inside_out = topology.closed && enclosed(vertices, triangles) < 0;
  return topology;
}

}  // namespace tool_path_stretcher
