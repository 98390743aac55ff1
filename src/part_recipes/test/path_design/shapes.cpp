// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "path_design/surface/cloud_sheet.h"

namespace shapes {

using Eigen::Vector3d;

void Soup::add(const Soup& other) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles)
    triangles.push_back({a + first, b + first, c + first});
}

Soup grid(int columns, int rows, const std::function<Vector3d(double u, double v)>& at) {
  Soup soup;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      soup.vertices.push_back(
          at(static_cast<double>(column) / columns, static_cast<double>(row) / rows));
  const auto number = [columns](int column, int row) {
    return static_cast<std::uint32_t>(row * (columns + 1) + column);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto a = number(column, row), b = number(column + 1, row),
                 c = number(column + 1, row + 1), d = number(column, row + 1);
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  }
  return soup;
}

Soup plate(double width, double depth, double hole, const Eigen::Vector2d& centre) {
  if (hole == 0)
    return grid(1, 1, [=](double u, double v) {
      return Vector3d((u - 0.5) * width, (v - 0.5) * depth, 0);
    });
  std::vector<double> angles;
  constexpr int kSides = 720;
  for (int i = 0; i < kSides; ++i)
    angles.push_back(2 * M_PI * i / kSides - M_PI);
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      angles.push_back(std::atan2(y * depth - centre.y(), x * width - centre.x()));
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front() + 2 * M_PI);
  return grid(static_cast<int>(angles.size()) - 1, 1, [=](double u, double v) {
    const auto i =
        static_cast<std::size_t>(std::lround(u * static_cast<double>(angles.size() - 1)));
    // The last is the first again, to the last bit.
    const double angle = i + 1 == angles.size() ? angles.front() : angles[i];
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    const double out = std::min((std::copysign(width / 2, way.x()) - centre.x()) / way.x(),
                                (std::copysign(depth / 2, way.y()) - centre.y()) / way.y());
    const Eigen::Vector2d at = centre + (v == 0 ? out : hole) * way;
    return Vector3d(at.x(), at.y(), 0);
  });
}

Soup cylinder(double radius, double length, double angle, int facets) {
  return grid(facets, 40, [=](double u, double v) {
    const double at = (2 * u - 1) * angle;
    return Vector3d(radius * std::sin(at), v * length, radius * std::cos(at));
  });
}

Soup sphere(double radius, int facets) {
  return grid(2 * facets, facets, [=](double u, double v) {
    const double turn = u == 1 ? 0 : 2 * M_PI * u, rise = M_PI * (v - 0.5);
    const double out = v == 0 || v == 1 ? 0 : radius * std::cos(rise);
    return Vector3d(out * std::cos(turn), out * std::sin(turn), radius * std::sin(rise));
  });
}

Soup box(double width, double depth, double height) {
  Soup soup;
  for (const double z : {0.0, height})
    for (const double y : {-depth / 2, depth / 2})
      for (const double x : {-width / 2, width / 2})
        soup.vertices.emplace_back(x, y, z);
  soup.triangles = {{0, 3, 1}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {1, 3, 7}, {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}};
  return soup;
}

Soup roof(double width, double length) {
  return grid(2, 1, [=](double u, double v) {
    const double x = (u - 0.5) * width;
    return Vector3d(x, v * length, -std::abs(x));
  });
}

Soup squares(const std::vector<std::string>& picture, double side) {
  Soup soup;
  for (std::size_t row = 0; row < picture.size(); ++row) {
    for (std::size_t column = 0; column < picture[row].size(); ++column) {
      if (picture[row][column] != 'x') continue;
      const auto left = static_cast<double>(column);
      const auto low = static_cast<double>(picture.size() - 1 - row);
      soup.add(grid(1, 1, [=](double u, double v) {
        return Vector3d((left + u) * side, (low + v) * side, 0);
      }));
    }
  }
  return soup;
}

Soup panel(int columns) {
  const int rows = columns * 2 / 3;
  Soup soup = grid(columns, rows, [](double u, double v) {
    const double x = 0.3 * (u - 0.5), y = 0.2 * (v - 0.5);
    return Vector3d(x, y, 0.012 * std::sin(17 * x + 0.4) * std::cos(13 * y) + 0.8 * x * y);
  });
  const auto in_hole = [&soup](const Triangle& triangle) {
    const Vector3d& at = soup.vertices[triangle[0]];
    return std::hypot(at.x() - 0.08, at.y() - 0.03) < 0.02;
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), in_hole),
                       soup.triangles.end());
  return soup;
}

Soup moved(Soup soup, const Eigen::Isometry3d& motion) {
  for (Vector3d& vertex : soup.vertices)
    vertex = motion * vertex;
  return soup;
}

PartMesh mesh_of(const Soup& soup, const Vector3d& towards) {
  return part_recipes::path_design::joined_mesh(soup.vertices, soup.triangles, towards,
                                                30 * kDegree, "shape");
}

Points cloud_of(const Soup& soup, double spacing, double noise, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  Points cloud;
  double left = 0;
  for (const auto& [i, j, k] : soup.triangles) {
    const Vector3d &a = soup.vertices[i], b = soup.vertices[j] - a, c = soup.vertices[k] - a;
    const Vector3d normal = b.cross(c).normalized();
    for (left += b.cross(c).norm() / 2 / (spacing * spacing); left >= 1; --left) {
      double u = uniform(), v = uniform(), off = -6;
      if (u + v > 1) u = 1 - u, v = 1 - v;
      for (int n = 0; n < 12; ++n)
        off += uniform();  // nearly normal, deviation 1
      cloud.push_back(a + u * b + v * c + noise * off * normal);
    }
  }
  return cloud;
}

PartMesh sheet_of(const Points& cloud, const Vector3d& towards) {
  const auto surface =
      tool_path_stretcher::surface_from_cloud(cloud, Vector3d::Constant(0.001), "cloud");
  return part_recipes::path_design::sheet_of(surface, towards, "cloud");
}

void save_stl(const std::string& file, const Soup& soup) {
  std::ofstream out(file);
  out.precision(9);
  out << "solid part\n";
  for (const Triangle& triangle : soup.triangles) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : triangle)
      out << "vertex " << soup.vertices[corner].transpose() << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid part\n";
}

}  // namespace shapes
