// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/cell_shapes_targets.h"

#include <cmath>

#include "c4g_driver/cell_shapes.h"

namespace {

using namespace scan_cell_common;
using c4g_driver::CellShape;

const char* const kCell =
    "clearance: 0.01\nshapes:\n"
    "  - {name: bracket, frame: flange, box: [0.6, 0.04, 0.04],\n"
    "     pose: {translation: [0, 0, 0.03], rotation: [0, 0, 0, 1]}}\n"
    "  - {name: camera, frame: flange, sphere: 0.06}\n"
    "  - {name: spindle, frame: tool_tip, capsule: [0.02, 0.1]}\n"
    "  - {name: floor, frame: base_link, half_space: [0, 0, 1]}\n"
    "links:\n  - {link: link_2, radius: 0.1}\n"
    "may_touch:\n  - [spindle, floor]\n  - [link_2, part]\n";

/// Expects that a shape read keeps every promise of a shape.
void expect_usable(const CellShape& shape) {
  promise(!shape.name.empty(), "a name");
  promise(shape.size.allFinite(), "a finite size");
  promise(shape.pose.translation().allFinite(), "a place");
  const Eigen::Matrix3d rotation = shape.pose.linear();
  promise((rotation * rotation.transpose()).isIdentity(1e-9), "a rotation");
  if (shape.kind == CellShape::Kind::kHalfSpace) {
    promise(std::abs(shape.size.norm() - 1) < 1e-9, "a unit direction");
    promise(shape.frame == "base_link", "a half-space in the cell");
  } else {
    promise(shape.size.x() > 0 && shape.size.minCoeff() >= 0, "a size above 0");
  }
}

}  // namespace

std::vector<FuzzTarget> cell_shapes_targets() {
  FuzzTarget target;
  target.name = "cell_shapes";
  target.seeds = {kCell};
  target.words = {"shapes", "name", "frame",    "box",   "sphere", "capsule", "half_space", "pose",
                  "links",  "link", "radius",   "[",     "]",      "{",       "}",          "- ",
                  ": ",     "&p ",  "*p",       "<<",    "? ",     "|\n",     "#",          "~",
                  ".nan",   ".inf", "1e-320",   "0",     "-1",     "1e308",   "null",       "part",
                  "\t",     "---",  "[[[[[[[[", "flange"};
  target.run = [](const std::string& bytes) {
    const c4g_driver::CellShapes shapes = c4g_driver::parse_cell_shapes(bytes, "shapes.yaml");
    promise(shapes.clearance >= 0 && std::isfinite(shapes.clearance), "a clearance");
    for (const CellShape& shape : shapes.shapes)
      expect_usable(shape);
    for (const c4g_driver::LinkCapsule& link : shapes.links)
      promise(link.radius > 0 && std::isfinite(link.radius), "a radius");
  };
  return {target};
}
