// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "path_design/border/border.h"
#include "path_design/border/offset.h"
#include "path_design/path_builder.h"
#include "path_design/surface/reference.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace part_recipes {
namespace {

using namespace path_design;
using scan_cell_common::Refused;

PartMesh face_of(const PartMesh& reference, const EdgeParameters& parameters) {
  if (!parameters.near.empty())
    return face_around(reference, Eigen::Vector3d(parameters.near.data()),
                       parameters.path.crease_angle);
  // A cloud's surface is only what is seen.
  return reference.spacing > 0 ? reference
                               : seen_part(reference, parameters.path.from.normalized());
}

/// The edges of a face, without holes that count as filled.
std::vector<Trace> edges_of(const MeshSearch& face, const EdgeParameters& parameters,
                            PathBuilder& builder) {
  constexpr double kSpacings = 4;  // of a cloud: beyond its noise; chosen
  const double filled = filled_width(face.mesh(), parameters.path);
  const double reach =
      parameters.smoothing > 0 ? parameters.smoothing : kSpacings * face.mesh().spacing;
  std::vector<Trace> edges;
  std::size_t narrow = 0;
  for (const Trace& border : borders_of(face.mesh(), parameters.path.corner_angle)) {
    if (is_hole(border) && width_of(border) <= filled) {
      ++narrow;
      continue;
    }
    edges.push_back(reach > 0 ? smoothed_border(border, reach, parameters.path.corner_angle, face)
                              : border);
  }
  if (narrow > 0)
    builder.note(fmt::format("taken as filled: {} holes up to {:g} mm wide", narrow, 1e3 * filled));
  return edges;
}

bool is_wanted(const Trace& line, Loops loops) {
  return loops == Loops::kAll || is_hole(line) == (loops == Loops::kHoles);
}

}  // namespace

DesignedPath path_from_edge(const PartMesh& reference, const EdgeParameters& parameters) {
  scan_cell_common::check(parameters);
  const PartMesh face = face_of(reference, parameters);
  const MeshSearch search(face);
  PathBuilder builder(parameters.path);
  const std::vector<Trace> edges = edges_of(search, parameters, builder);
  if (edges.empty()) {
    throw Refused("edge", "the surface has none: it is closed",
                  "give a face by --near, or the side that is seen by --from");
  }
  const auto lines = offset_from(search, edges, parameters.offset, parameters.path.corner_angle);
  if (lines.empty()) {
    throw Refused("offset",
                  fmt::format("{:g} mm: the surface is too narrow for it", 1e3 * parameters.offset),
                  "give a smaller one");
  }
  std::size_t outer = 0, holes = 0, open = 0;
  for (const Trace& line : lines) {
    if (!is_wanted(line, parameters.loops)) continue;
    open += line.closed ? 0 : 1;
    builder.add(line,
                is_hole(line) ? fmt::format("hole {}", ++holes) : fmt::format("edge {}", ++outer));
  }
  if (open > 0)
    builder.note(
        fmt::format("not closed: {} of {} lines, beside a ragged edge", open, outer + holes));
  return builder.finish("edges");
}

}  // namespace part_recipes
