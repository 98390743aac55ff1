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

/// [m^2] twice the area that spans each line of edges without a neighbour: nothing for a crack,
/// whose sides run there and back.
/// @param edges consistently wound: so many of these begin at each vertex as end there
double twice_open_area(const Points& vertices, const std::vector<Edge>& edges) {
  std::multimap<std::uint32_t, std::uint32_t> border;
  for (const Edge& edge : edges) {
    if (!std::binary_search(edges.begin(), edges.end(), Edge(edge.second, edge.first)))
      border.insert(edge);
  }
  double sum = 0;
  while (!border.empty()) {
    const Eigen::Vector3d& origin = vertices[border.begin()->first];
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (auto edge = border.begin(); edge != border.end();) {
      const std::uint32_t to = edge->second;
      area += (vertices[edge->first] - origin).cross(vertices[to] - origin);
      border.erase(edge);
      edge = border.find(to);
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
  const std::vector<Edge> edges = edges_of(triangles);
  MeshTopology topology;
  topology.oriented = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  if (!topology.oriented) return topology;
  topology.closed = twice_open_area(vertices, edges) <= 2 * kOpen * area;
  topology.inside_out = topology.closed && enclosed(vertices, triangles) < 0;
  return topology;
}

}  // namespace tool_path_stretcher
