// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace part_recipes::path_design {

using Points = std::vector<Eigen::Vector3d>;           //!< [m]
using Triangle = std::array<std::uint32_t, 3>;         //!< numbers of its corners
using CornerNormals = std::array<Eigen::Vector3d, 3>;  //!< of a triangle, unit length

constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFU;  //!< beyond an edge where the surface ends

/// The surface of a part as triangles that know their neighbours. Seen from outside, the corners
/// of a triangle go round counterclockwise. Edge i of a triangle runs from corner i to the next.
struct PartMesh {
  Points vertices;                                   //!< [m]
  std::vector<Triangle> triangles;                   //!< none without area
  Points facets;                                     //!< unit normal of each triangle
  std::vector<CornerNormals> normals;                //!< of the smooth surface at each corner
  std::vector<std::array<std::uint32_t, 3>> beside;  //!< beyond each edge, or kNoTriangle
  double spacing = 0;  //!< [m] pitch of the cloud it was made from; 0: a mesh
};

/// A mesh of loose triangles. Vertices in the same place become one, triangles without area are
/// left out, and all triangles of a shell are wound alike: outwards if the shell is closed, else so
/// that most of it faces `towards`. The normal at a corner is the mean over the facets around it,
/// weighted with their angles, without those beyond an edge sharper than `crease_angle`.
/// @param towards unit length
/// @param crease_angle [rad] between the facets of a sharp edge
/// @param name of the mesh in error messages
/// @throw scan_cell_common::UnusableInput if a vertex is not finite, or no triangle has an area
PartMesh joined_mesh(const Points& vertices, const std::vector<Triangle>& triangles,
                     const Eigen::Vector3d& towards, double crease_angle, const std::string& name);

/// A mesh whose vertices have normals of their own.
/// @param vertex_normals unit length, one a vertex
PartMesh mesh_with_normals(const Points& vertices, const Points& vertex_normals,
                           const std::vector<Triangle>& triangles);

/// Some triangles of a mesh, with their normals.
PartMesh part_of(const PartMesh& mesh, const std::vector<std::uint32_t>& triangles);

/// The number of the shell that each triangle belongs to, in the order of their first triangles.
std::vector<std::uint32_t> shells_of(const PartMesh& mesh);

/// [m^2] of a triangle
double area_of(const PartMesh& mesh, std::size_t triangle);

/// Cosine of the angle between the facets at an edge; 1 if there is none beyond.
double bend_at(const PartMesh& mesh, std::size_t triangle, std::size_t edge);

}  // namespace part_recipes::path_design
