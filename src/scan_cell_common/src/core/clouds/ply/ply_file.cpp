// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "clouds/carried_fields.h"
#include "clouds/meshes.h"
#include "clouds/ply/ply_body.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

/// Which properties of a vertex are x, y and z.
std::array<std::size_t, 3> find_coordinates(const PlyElement& vertex, const std::string& source) {
  constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
  std::array<std::size_t, 3> found{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t times = 0;
    for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
      if (vertex.properties[i].name != kNames[axis]) continue;
      found[axis] = i;
      ++times;
    }
    if (times == 1 && !vertex.properties[found[axis]].is_list &&
        is_real(vertex.properties[found[axis]].type)) {
      continue;
    }
    throw FileError(
        source,
        "its vertices do not have exactly one " + std::string(kNames[axis]) + " as float or double",
        "write it again with x, y and z as float or double");
  }
  return found;
}

const PlyElement& vertex_of(const PlyHeader& header, const std::string& source) {
  const auto is_vertex = [](const PlyElement& element) { return element.name == "vertex"; };
  if (std::count_if(header.elements.begin(), header.elements.end(), is_vertex) != 1) {
    throw FileError(source, "not exactly one element 'vertex'", "write it again with x, y and z");
  }
  return *std::find_if(header.elements.begin(), header.elements.end(), is_vertex);
}

/// The list of a face's corners; none if it has no single list of whole numbers.
std::optional<std::size_t> corners_of(const PlyElement& face) {
  std::vector<std::size_t> lists, named;
  for (std::size_t i = 0; i < face.properties.size(); ++i) {
    const PlyProperty& property = face.properties[i];
    if (!property.is_list || is_real(property.type)) continue;
    lists.push_back(i);
    if (property.name == "vertex_indices" || property.name == "vertex_index") named.push_back(i);
  }
  if (named.size() == 1) return named[0];
  if (lists.size() == 1) return lists[0];
  return std::nullopt;
}

/// Reads all elements, so that a truncated file is detected even if the requested part is whole.
/// @param take_vertex, take_face called with the values of each, as the body returns them
template <class Body, class TakeVertex, class TakeFace>
void read_body(const PlyHeader& header, Body& body, const TakeVertex& take_vertex,
               const TakeFace& take_face) {
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;
    if (element.name == "vertex") {
      body.read(element, take_vertex);
    } else if (element.name == "face") {
      body.read(element, [&](const typename Body::Values& values) { take_face(element, values); });
    } else {
      body.read(element, [](const typename Body::Values&) {});
    }
  }
  body.end();
}

/// The properties of a vertex besides x, y and z; their fields are added to the cloud.
std::vector<std::size_t> carried_properties(const PlyElement& vertex, FieldedCloud& carried) {
  std::vector<std::size_t> found;
  add_coordinates(carried);
  for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
    const PlyProperty& property = vertex.properties[i];
    if (!property.is_list && add_field(carried, property.name, property.type)) found.push_back(i);
  }
  return found;
}

/// @param carried null: not wanted
template <class Body, class TakeFace>
Cloud read_vertices(const PlyHeader& header, Body& body, const std::string& source,
                    FieldedCloud* carried, const TakeFace& take_face) {
  const PlyElement& vertex = vertex_of(header, source);
  const std::array<std::size_t, 3> xyz = find_coordinates(vertex, source);
  const std::vector<std::size_t> others =
      carried != nullptr ? carried_properties(vertex, *carried) : std::vector<std::size_t>();
  Cloud cloud;
  const auto take_vertex = [&](const typename Body::Values& values) {
    const auto number = [&](std::size_t axis) {
      return body.number(values[xyz[axis]], vertex.properties[xyz[axis]]);
    };
    cloud.points.emplace_back(number(0), number(1), number(2));
    if (carried == nullptr) return;
    append_place(cloud.points.back(), *carried);
    for (const std::size_t i : others)
      body.append(values[i], vertex.properties[i], *carried);
  };
  read_body(header, body, take_vertex, take_face);
  cloud.width = static_cast<std::uint32_t>(cloud.points.size());
  cloud.height = 1;
  return cloud;
}

template <class Body>
Cloud read_cloud(const PlyHeader& header, Body& body, const std::string& source,
                 FieldedCloud* carried) {
  return read_vertices(header, body, source, carried,
                       [](const PlyElement&, const typename Body::Values&) {});
}

pcl::index_t checked_corner(std::uint64_t corner, const std::string& source) {
  if (corner <= static_cast<std::uint64_t>(std::numeric_limits<pcl::index_t>::max()))
    return static_cast<pcl::index_t>(corner);
  throw FileError(source, fmt::format("a face with vertex {}", corner), "export the part again");
}

template <class Body>
pcl::PolygonMesh read_mesh(const PlyHeader& header, Body& body, const std::string& source) {
  std::vector<pcl::Vertices> polygons;
  std::vector<std::uint64_t> corners;
  const auto take_face = [&](const PlyElement& face, const typename Body::Values& values) {
    const std::optional<std::size_t> at = corners_of(face);
    if (!at) {
      throw FileError(source, "its faces do not have exactly one list of corners",
                      "write it again with the list vertex_indices");
    }
    body.list(values[*at], face.properties[*at], corners);
    if (corners.size() < 3) {
      throw FileError(source, fmt::format("a face with {} corners", corners.size()),
                      "give at least three");
    }
    polygons.emplace_back();
    for (const std::uint64_t corner : corners)
      polygons.back().vertices.push_back(checked_corner(corner, source));
  };
  Cloud vertices = read_vertices(header, body, source, nullptr, take_face);
  check_corners(polygons, vertices.points.size(), source, 0);
  return mesh_of(vertices, std::move(polygons));
}

/// @param read called with the header and the body
template <class Read>
auto parse(std::string_view file, const std::string& source, const Read& read) {
  const std::string_view bytes = without_byte_order_mark(file);
  LineReader lines(bytes, source);
  const PlyHeader header = read_ply_header(lines, source);
  if (header.format == PlyFormat::kAscii) {
    AsciiPlyBody body(lines, source);
    return read(header, body);
  }
  BinaryPlyBody body(bytes.substr(lines.position()), header.format == PlyFormat::kBigEndian,
                     source);
  return read(header, body);
}

}  // namespace

Cloud parse_ply(std::string_view bytes, const std::string& source, FieldedCloud* carried) {
  return parse(bytes, source, [&](const PlyHeader& header, auto& body) {
    return read_cloud(header, body, source, carried);
  });
}

Cloud parse_ply(std::string_view bytes, const std::string& source) {
  return parse_ply(bytes, source, nullptr);
}

pcl::PolygonMesh parse_ply_mesh(std::string_view bytes, const std::string& source) {
  return parse(bytes, source, [&source](const PlyHeader& header, auto& body) {
    return read_mesh(header, body, source);
  });
}

std::size_t faces_of_ply(std::string_view header) {
  LineReader lines(without_byte_order_mark(header), "");
  try {
    std::size_t faces = 0;
    for (const PlyElement& element : read_ply_header(lines, "").elements)
      faces += element.name == "face" && corners_of(element) ? element.count : 0;
    return faces;
  } catch (const FileError&) {
    return 0;  // reading the file says what is wrong with it
  }
}

}  // namespace scan_cell_common
