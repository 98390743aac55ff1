// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edits/edits_targets.h"

#include <cmath>

#include "cloud_preprocess/cloud_edits.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/yaml_file.h"

namespace {

using namespace cloud_preprocess;
using namespace scan_cell_common;

const char* const kSeed =
    "edits:\n"
    "  - delete: {box: {center: [0.1, 0.2, 0.3], size: [0.01, 0.02, 0.03], rotation: [0, 0, 0.6, "
    "0.8]}}\n"
    "  - keep: {plane: {point: [0, 0, 0.001], normal: [0, 0, 2]}}\n"
    "  - delete: {polygon: {corners: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], towards: [0, 0, 1], depth: "
    "[-0.1, 0.1]}}\n"
    "  - delete: {brush: {places: [[0, 0, 0], [0.1, 0, 0]], radius: 0.004}}\n"
    "  - keep: {cluster: {at: [0, 0, 0.05], gap: 0.003}}\n";

void expect_usable(const BoxShape& box) {
  promise(box.pose.matrix().allFinite() && box.size.minCoeff() > 0, "a box");
  promise(box.pose.linear().isUnitary(1e-6), "a rotation");
}
void expect_usable(const HalfSpace& half) {
  promise(half.point.allFinite() && std::abs(half.normal.norm() - 1) < 1e-9, "a plane");
}
void expect_usable(const PrismShape& prism) {
  promise(prism.corners.size() >= 3 && prism.nearest < prism.farthest, "a polygon");
  promise(std::abs(prism.towards.norm() - 1) < 1e-9, "a direction");
}
void expect_usable(const BrushShape& brush) {
  promise(!brush.places.empty() && brush.radius > 0, "a brush");
}
void expect_usable(const ClusterShape& cluster) {
  promise(cluster.place.allFinite() && cluster.gap > 0, "a cluster");
}

/// Every accepted edit can be applied, and leaves the cloud's points or fewer of them.
void run(const std::string& bytes) {
  const auto edits = read_edits(YamlEntry::parse(bytes, "edits.yaml")["edits"]);
  for (const CloudEdit& edit : edits)
    std::visit([](const auto& shape) { expect_usable(shape); }, edit.shape);
  Cloud cloud;
  for (int i = 0; i < 8; ++i)
    cloud.push_back({0.1F * static_cast<float>(i % 2), 0.05F * static_cast<float>(i / 2), 0.05F});
  StageReport report;
  try {
    const std::size_t left = CloudEdits(edits).run(cloud, report).size();
    promise(left > 0 && left <= cloud.size(), "a cloud");
  } catch (const UnusableInput&) {  // the edits leave nothing, and say so
  }
}

}  // namespace

std::vector<FuzzTarget> edits_targets() {
  FuzzTarget target;
  target.name = "edits";
  target.seeds = {kSeed, "edits: []\n"};
  target.words = {"delete", "keep",   "box",   "plane", "polygon", "brush", "cluster", "center",
                  "size",   "normal", "point", "gap",   "radius",  "depth", "towards", "corners",
                  "places", "[",      "]",     "{",     "}",       "- ",    ": ",      "&p ",
                  "*p",     "<<",     ".nan",  ".inf",  "-.inf",   "0",     "-1",      "1e308",
                  "1e-320", "1e-200", "null",  "~",     "---",     "'",     "[[[[[[",  "\t"};
  target.run = run;
  return {target};
}
