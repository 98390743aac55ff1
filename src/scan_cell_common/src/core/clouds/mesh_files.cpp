// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <limits>

#include "clouds/meshes.h"
#include "files/scalars.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace scan_cell_common {
namespace {

using Words = std::vector<std::string_view>;

pcl::PointXYZ vertex_of(const Words& words, const std::string& where) {
  std::array<float, 3> xyz{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<double> value =
        i + 1 < words.size() ? parse_number(words[i + 1]) : std::nullopt;
    if (!value) {
      throw FileError(where, i + 1 < words.size() ? "'" + excerpt(words[i + 1]) + "'" : "truncated",
                      "give a vertex as three numbers");
    }
    xyz[i] = to_float(*value);
  }
  return {xyz[0], xyz[1], xyz[2]};
}

/// Every three consecutive vertices are a triangle.
pcl::PolygonMesh mesh_of_triples(Cloud& vertices) {
  std::vector<pcl::Vertices> polygons(vertices.points.size() / 3);
  pcl::index_t next = 0;
  for (pcl::Vertices& polygon : polygons) {
    polygon.vertices = {next, next + 1, next + 2};
    next += 3;
  }
  return mesh_of(vertices, std::move(polygons));
}

constexpr std::size_t kStlHead = 84;      // 80 of text, 4 of count
constexpr std::size_t kStlTriangle = 50;  // normal, three vertices, attributes

pcl::PolygonMesh parse_binary_stl(std::string_view bytes) {
  Cloud vertices;
  for (std::size_t at = kStlHead; at < bytes.size(); at += kStlTriangle) {
    for (std::size_t vertex = 1; vertex <= 3; ++vertex) {
      const char* place = bytes.data() + at + 12 * vertex;
      vertices.points.emplace_back(load_as<float>(place, false), load_as<float>(place + 4, false),
                                   load_as<float>(place + 8, false));
    }
  }
  return mesh_of_triples(vertices);
}

pcl::PolygonMesh parse_ascii_stl(std::string_view text, const std::string& source) {
  LineReader lines(text, source);
  Cloud vertices;
  bool in_solid = false;
  const auto expect = [&](bool as_it_should) {
    if (!as_it_should) {
      throw FileError(lines.where(), "'" + excerpt(lines.words()[0]) + "' out of place",
                      "export the part again");
    }
  };
  while (lines.next_filled()) {
    const std::string key = lower_case(lines.words()[0]);
    if (key == "vertex") {
      expect(in_solid);
      vertices.points.push_back(vertex_of(lines.words(), lines.where()));
    } else if (key == "facet" || key == "endfacet") {
      expect(in_solid && vertices.points.size() % 3 == 0);
    } else if (key == "solid" || key == "endsolid") {
      expect(in_solid == (key == "endsolid") && vertices.points.size() % 3 == 0);
      in_solid = !in_solid;
    } else {
      expect(key == "outer" || key == "endloop");
    }
  }
  if (in_solid) throw FileError(source, "truncated: no 'endsolid'", "export the part again");
  return mesh_of_triples(vertices);
}

/// The vertex named by a corner of a face: counted from 1, or backwards from the last one so far.
pcl::index_t corner_of(std::string_view word, std::size_t vertices, const std::string& where) {
  constexpr std::uint64_t kMost = std::numeric_limits<pcl::index_t>::max();
  const std::string_view first = word.substr(0, word.find('/'));
  const bool backwards = !first.empty() && first[0] == '-';
  const std::optional<std::uint64_t> number = parse_count(backwards ? first.substr(1) : first);
  if (!number || *number == 0 || *number > (backwards ? vertices : kMost)) {
    throw FileError(where, "a face with vertex '" + excerpt(first) + "'", "export the part again");
  }
  return static_cast<pcl::index_t>(backwards ? vertices - *number : *number - 1);
}

}  // namespace

pcl::PolygonMesh parse_stl(std::string_view bytes, const std::string& source) {
  const std::string_view text = without_byte_order_mark(bytes);
  if (bytes.size() >= kStlHead) {
    const auto triangles = load_as<std::uint32_t>(bytes.data() + 80, false);
    const std::uint64_t wanted = kStlHead + std::uint64_t{kStlTriangle} * triangles;
    if (bytes.size() == wanted) return parse_binary_stl(bytes);
    const bool is_text = bytes.find('\0') == std::string_view::npos;
    if (!is_text) {
      throw FileError(
          source,
          fmt::format("not an STL file, or truncated: it has {} of {} bytes", bytes.size(), wanted),
          "export the part again");
    }
  }
  LineReader lines(text, source);
  if (!lines.next_filled() || lower_case(lines.words()[0]) != "solid") {
    throw FileError(source, "not an STL file", "give a mesh as STL or OBJ");
  }
  return parse_ascii_stl(text, source);
}

pcl::PolygonMesh parse_obj(std::string_view bytes, const std::string& source) {
  LineReader lines(without_byte_order_mark(bytes), source);
  Cloud vertices;
  std::vector<pcl::Vertices> polygons;
  while (lines.next_filled()) {
    const Words& words = lines.words();
    if (words[0] == "v") {
      vertices.points.push_back(vertex_of(words, lines.where()));
    } else if (words[0] == "f") {
      if (words.size() < 4) {
        throw FileError(lines.where(), fmt::format("a face with {} corners", words.size() - 1),
                        "give at least three");
      }
      polygons.emplace_back();
      for (std::size_t i = 1; i < words.size(); ++i) {
        polygons.back().vertices.push_back(
            corner_of(words[i], vertices.points.size(), lines.where()));
      }
    }
  }
  check_corners(polygons, vertices.points.size(), source, 1);
  return mesh_of(vertices, std::move(polygons));
}

}  // namespace scan_cell_common
