// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "path_design/border/border.h"
#include "path_design/border/links.h"
#include "path_design/border/offset.h"
#include "path_design/path_builder.h"
#include "path_design/raster_frame.h"
#include "path_design/surface/reference.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace part_recipes {
namespace {

using namespace path_design;

constexpr double kLook = 0.001;  // [m] steps in which a row is looked at; chosen

class Raster {
 public:
  Raster(const PartMesh& reference, const SliceParameters& parameters)
      : parameters_(parameters),
        is_cloud_(reference.spacing > 0),
        whole_(reference),
        seen_(is_cloud_ ? reference : seen_part(reference, parameters.path.from.normalized())),
        surface_(seen_),
        frame_(raster_frame(seen_, parameters)),
        filled_(filled_width(reference, parameters.path)),
        borders_(wide_borders()),
        border_(surface_, borders_) {}

  DesignedPath path() {
    PathBuilder builder(parameters_.path);
    add_border_passes(builder);
    std::vector<std::vector<Trace>> rows;
    for (std::vector<Trace>& row : cut(seen_, frame_.planes))
      rows.push_back(pieces_of(row));
    if (parameters_.order == RasterOrder::kZigzag) {
      constexpr double kLongest = 5;  // spacings: of a link on a slant border; chosen
      const auto lines = linked(
          rows, surface_, border_,
          {kLongest * parameters_.spacing + filled_, parameters_.margin, parameters_.spacing / 2});
      for (std::size_t i = 0; i < lines.size(); ++i)
        builder.add(lines[i], fmt::format("raster {}", i + 1));
    } else {
      for (std::size_t row = 0; row < rows.size(); ++row)
        for (const Trace& piece : rows[row])
          builder.add(piece, fmt::format("row {}", row + 1));
    }
    return builder.finish("rows");
  }

 private:
  /// All borders except holes that count as filled.
  std::vector<Trace> wide_borders() const {
    std::vector<Trace> borders = borders_of(seen_, parameters_.path.corner_angle);
    borders.erase(std::remove_if(borders.begin(), borders.end(),
                                 [this](const Trace& border) {
                                   return is_hole(border) && width_of(border) <= filled_;
                                 }),
                  borders.end());
    if (!is_cloud_) return borders;
    constexpr double kSpacings = 4;  // of a cloud: beyond its noise; chosen
    for (Trace& border : borders)
      border = smoothed_border(border, kSpacings * seen_.spacing, parameters_.path.corner_angle,
                               surface_);
    return borders;
  }

  void add_border_passes(PathBuilder& builder) const {
    for (int pass = 0; pass < parameters_.border_passes; ++pass) {
      const double offset = parameters_.margin + pass * parameters_.spacing;
      const auto lines = offset_from(surface_, borders_, offset, parameters_.path.corner_angle);
      for (std::size_t i = 0; i < lines.size(); ++i)
        builder.add(lines[i], fmt::format("border {}.{}", pass + 1, i + 1));
      if (lines.empty())
        builder.note(fmt::format("border pass {}: the surface is too narrow for it", pass + 1));
    }
  }

  /// What the viewer sees of a row, across the gaps that count as filled, within the margin.
  std::vector<Trace> pieces_of(const std::vector<Trace>& row) const {
    std::vector<Trace> seen;
    for (const Trace& line : row) {
      const Trace open = opened(line);
      const auto parts = is_cloud_ ? std::vector<Trace>{open}
                                   : kept_where(open, kLook, [this](const TracePoint& point) {
                                       return !whole_.is_hidden(point.position, frame_.towards);
                                     });
      seen.insert(seen.end(), parts.begin(), parts.end());
    }
    std::vector<Trace> pieces;
    for (const Trace& line : joined_over_gaps(std::move(seen), frame_.along, filled_)) {
      if (parameters_.margin == 0) {
        pieces.push_back(line);
        continue;
      }
      const auto parts = kept_where(line, kLook, [this](const TracePoint& point) {
        return border_.is_beyond(point.position, parameters_.margin);
      });
      pieces.insert(pieces.end(), parts.begin(), parts.end());
    }
    return pieces;
  }

  const SliceParameters& parameters_;
  const bool is_cloud_;
  const MeshSearch whole_;
  const PartMesh seen_;
  const MeshSearch surface_;
  const RasterFrame frame_;
  const double filled_;  // [m] widest hole that counts as filled
  const std::vector<Trace> borders_;
  const BorderDistance border_;
};

}  // namespace

DesignedPath path_from_slices(const PartMesh& reference, const SliceParameters& parameters) {
  scan_cell_common::check(parameters);
  return Raster(reference, parameters).path();
}

}  // namespace part_recipes
