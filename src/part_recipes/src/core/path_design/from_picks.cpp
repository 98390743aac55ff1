// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "path_design/path_builder.h"
#include "path_design/spline.h"
#include "path_design/surface/mesh_search.h"
#include "path_design/trace/bends.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace part_recipes {
namespace {

using namespace path_design;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

void check_picks(const Points& picks, const PickParameters& parameters) {
  const std::size_t fewest = parameters.closed ? 3 : 2;
  if (picks.size() < fewest)
    throw UnusableInput("picks", fmt::format("{} of them", picks.size()),
                        fmt::format("give at least {}", fewest));
  for (std::size_t i = 0; i < picks.size(); ++i) {
    if (!picks[i].allFinite())
      throw UnusableInput(fmt::format("pick {}", i + 1), "not finite (NaN or infinite)",
                          "give x, y and z");
    const bool last = i + 1 == picks.size();
    if (last && !parameters.closed) break;
    if ((picks[(i + 1) % picks.size()] - picks[i]).norm() > 1e-6) continue;  // [m] one place
    throw UnusableInput(fmt::format("pick {}", last ? 1 : i + 2),
                        "in the same place as the one before", "leave one out");
  }
}

Foot foot_of(const MeshSearch& surface, const Eigen::Vector3d& point, double most,
             const std::string& name, const std::string& cure) {
  const Foot foot = surface.nearest(point);
  if (foot.distance <= most) return foot;
  throw Refused(name, fmt::format("{:.3g} mm from the surface", 1e3 * foot.distance), cure);
}

/// The spline between picks, projected onto the surface.
Trace line_on(const MeshSearch& surface, const Points& picks, const PickParameters& parameters) {
  constexpr double kStep = 0.0005;  // [m] chosen: a tenth of what is felt of a usual tool
  const double step = std::min(kStep, parameters.path.max_step);
  Points feet;
  for (std::size_t i = 0; i < picks.size(); ++i)
    feet.push_back(foot_of(surface, picks[i], parameters.max_distance,
                           fmt::format("pick {}", i + 1),
                           "pick it on the surface, or allow it by --max-distance")
                       .point);
  const CatmullRom spline(feet, parameters.closed);
  Trace trace;
  for (std::size_t i = 0; i < spline.pieces(); ++i) {
    const std::size_t next = (i + 1) % feet.size();
    const double steps = std::max(4.0, std::ceil((feet[next] - feet[i]).norm() / step));
    const std::string name = fmt::format("line between picks {} and {}", i + 1, next + 1);
    for (double k = i == 0 ? 0 : 1; k <= steps; ++k) {
      const Foot foot = foot_of(surface, spline.at(i, k / steps), parameters.max_distance, name,
                                "pick more points, or allow it by --max-distance");
      trace.points.push_back({foot.point, foot.normal, false});
    }
  }
  return trace;
}

}  // namespace

DesignedPath path_from_picks(const PartMesh& reference, const Points& picks,
                             const PickParameters& parameters) {
  scan_cell_common::check(parameters);
  check_picks(picks, parameters);
  const MeshSearch surface(reference);
  PathBuilder builder(parameters.path);
  Trace line = with_bends(line_on(surface, picks, parameters), parameters.path.crease_angle);
  if (parameters.closed) {
    line.points.pop_back();  // the first place again
    line.closed = true;
  }
  builder.add(line, "picks");
  return builder.finish("picks");
}

}  // namespace part_recipes
