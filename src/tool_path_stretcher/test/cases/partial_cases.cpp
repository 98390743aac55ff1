// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "case_list.h"

namespace cases {
namespace {

using tool_path_stretcher::Waypoint;

Eigen::AlignedBox3d extent_of(const Part& part) {
  constexpr int kSteps = 20;
  Eigen::AlignedBox3d box;
  for (const Facet& facet : part.facets) {
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j)
        box.extend(facet.at(i / double{kSteps}, j / double{kSteps}).position);
    }
  }
  return box;
}

}  // namespace

Part with_path_within(Part part, double from, double to) {
  const Eigen::AlignedBox3d box = extent_of(part);
  std::vector<Waypoint>& waypoints = part.path.segments.at(0).waypoints;
  std::vector<Waypoint> longest;
  std::vector<Waypoint> piece;
  for (const Waypoint& waypoint : waypoints) {
    const double at = (waypoint.pose.translation().x() - box.min().x()) / box.sizes().x();
    if (at < from || at > to) {
      piece.clear();
      continue;
    }
    piece.push_back(waypoint);
    if (piece.size() > longest.size()) longest = piece;
  }
  waypoints = longest;
  return part;
}

namespace {

class PartialCases {
 public:
  explicit PartialCases(std::vector<Case>& all) : all_(all) {}

  /// @param whole how the part is scanned if all of it is
  void add(const std::string& name, const Part& part, const Scan& whole) {
    Scan begin = whole;
    begin.share = 0.6;
    const Part within = with_path_within(part, 0.1, 0.5);
    add_one(name + ", reference of 60 %", within, 1.1, begin, whole);
    add_one(name + ", 60 % scanned, path within", within, 0.9, whole, begin);
    begin.share = 0.75;
    Scan end = whole;
    end.share = 0.65;
    end.far_end = true;
    // The features that break its symmetry may lie outside the part that both scans show.
    add_one(name + ", reference of 75 %, other 65 % scanned", with_path_within(part, 0.4, 0.7), 1,
            begin, end)
        .also = tool_path_stretcher::Reason::kAmbiguous;
  }

 private:
  Case& add_one(const std::string& name, const Part& part, double scale, const Scan& reference,
                const Scan& object) {
    seed_ += 10;
    const Similarity similarity{scale, random_rotation(seed_), {0.11, 0.2, -0.15}};
    all_.push_back({name, part, part, none(), similarity, reference, object});
    all_.back().reference_scan.seed = seed_ + 1;
    all_.back().object_scan.seed = seed_ + 2;
    return all_.back();
  }

  std::vector<Case>& all_;
  unsigned seed_ = 12000;
};

}  // namespace

void add_partial(std::vector<Case>& all) {
  PartialCases cases(all);
  Scan from_above;
  from_above.from_above = true;
  cases.add("panel", curved_panel(), {});
  cases.add("ribbed plate", ribbed_plate(), {});
  cases.add("bracket", bracket(), {});
  cases.add("box", box(true), {});
  cases.add("frame", photo_frame(0.003), from_above);
  cases.add("elbow", elbow(), {});
}

}  // namespace cases
