// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "case_list.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/pose/units.h"
#include "tool_paths/tool_path_files.h"

namespace cases {
namespace {

using tool_path_stretcher::Reason;

using scan_cell_common::kDegree;

Similarity moved(double scale, unsigned seed) {
  return {scale, random_rotation(seed), {0.31, -0.12, 0.2}};
}

Similarity turned(double scale, double degrees) {
  return {scale,
          Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d::UnitZ()).toRotationMatrix(),
          {0.05, -0.03, 0.004}};
}

/// Collects cases of one part. Each differs from the last by what is named.
class Family {
 public:
  Family(std::string name, Part part, bool from_above, std::vector<Case>& all)
      : name_(std::move(name)), part_(std::move(part)), from_above_(from_above), all_(all) {}

  Case& add(const std::string& what, const Similarity& similarity,
            const Deformation& deformation = none()) {
    Case each{name_ + ", " + what, part_, part_, deformation, similarity, {}, {}};
    each.reference_scan.from_above = from_above_;
    each.object_scan.from_above = from_above_;
    each.object_scan.seed = static_cast<unsigned>(all_.size()) + 100;
    all_.push_back(each);
    return all_.back();
  }

 private:
  std::string name_;
  Part part_;
  bool from_above_;
  std::vector<Case>& all_;
};

void add_frames(std::vector<Case>& all) {
  Family frames("frame", photo_frame(0.003), true, all);
  frames.add("as it is", turned(1, 0));
  frames.add("turned 40 deg x 1.08", turned(1.08, 40));
  frames.add("turned 170 deg x 0.5", turned(0.5, 170));
  frames.add("any turn x 2", moved(2, 3));
  frames.add("bent 5 mm", turned(1.08, 25), bend(0.005, 0.2));
  frames.add("bent 10 mm, any turn", moved(0.9, 7), bend(0.010, 0.2));
  frames.add("twisted 4 deg", turned(1, -60), twist(4 * kDegree, 0.2));
  frames.add("bulged 3 mm", turned(1.2, 100), bulge(0.003, 0.04, {0.04, -0.06}));
  frames.add("dented 2 mm", turned(0.8, 10), bulge(-0.002, 0.010, {0.0, -0.064}));
  frames.add("swollen 1.5 mm", turned(1.1, 200), swelling(0.0015, 0.2));
  frames.add("filed edge", turned(1, 80), filed({0, -1, 1}, (0.075 + 0.010) / std::sqrt(2)));
  frames.add("bent and bulged", moved(1.08, 11),
             both(bulge(0.0025, 0.05, {-0.05, 0.06}), bend(0.003, 0.2)));
  frames.add("outliers 5 %", turned(1.1, 130)).object_scan.outliers = 0.05;
  frames.add("with floor", turned(0.95, -20)).object_scan.floor = true;
  frames.add("uneven 8 to 1", moved(1.5, 4)).object_scan.density_ratio = 8;
  frames.add("holes of 6 mm", turned(1, 60)).object_scan.hole = 0.006;
  Case& around = frames.add("reference scanned all round", turned(1.05, 33));
  around.reference_scan.from_above = false;
  Case& half = frames.add("three quarters scanned", turned(1.05, 50));
  half.object_scan.share = 0.75;
  half.expected = Reason::kPathNotScanned;
}

void add_boxes(std::vector<Case>& all) {
  Family boxes("box", box(true), false, all);
  boxes.add("turned 40 deg x 1.3", turned(1.3, 40));
  boxes.add("any turn x 0.6", moved(0.6, 5));
  boxes.add("any turn x 1.9", moved(1.9, 6));
  boxes.add("outliers and floor", turned(1, 75)).object_scan.outliers = 0.05;
  all.back().object_scan.floor = true;
  boxes.add("bulged lid 2.5 mm", turned(1.1, 15), bulge(0.0025, 0.05, {-0.02, -0.01}));
  boxes.add("twisted 3 deg", moved(0.8, 9), twist(3 * kDegree, 0.18));
  boxes.add("filed edge", turned(1, 120), filed({0, -1, 1}, (0.06 + 0.056) / std::sqrt(2)));
  boxes.add("two thirds scanned", turned(1.2, 30)).object_scan.share = 0.7;
  boxes.add("holes of 8 mm", moved(1, 13)).object_scan.hole = 0.008;
}

void add_panels(std::vector<Case>& all) {
  Family panels("panel", curved_panel(), false, all);
  panels.add("turned 5 deg x 0.9", turned(0.9, 5));
  panels.add("any turn x 0.5", moved(0.5, 21));
  panels.add("any turn x 2", moved(2, 22));
  panels.add("bent 6 mm", turned(1.1, 65), bend(0.006, 0.3));
  panels.add("twisted 5 deg", moved(0.9, 23), twist(5 * kDegree, 0.3));
  panels.add("bulged 4 mm", turned(1, 140), bulge(0.004, 0.05, {0.03, 0.02}));
  panels.add("dented 2 mm", turned(1, 10), bulge(-0.002, 0.012, {-0.02, -0.02}));
  panels.add("swollen 2 mm", turned(1.05, 30), swelling(0.002, 0.3));
  panels.add("three noises", turned(1.3, 250)).object_scan.noise = 0.0003;
  panels.add("reference of 90 %", turned(1.1, 15)).reference_scan.share = 0.9;
  panels.add("outliers 5 %", moved(1.2, 25)).object_scan.outliers = 0.05;
  Case& half = panels.add("60 % scanned", turned(1, 35));
  half.object_scan.share = 0.6;
  half.expected = Reason::kPathNotScanned;
}

void add_others(std::vector<Case>& all) {
  Family("straight moulding", straight_moulding(), true, all).add("x 1.1", turned(1.1, 20));
  Family("straight moulding", straight_moulding(), true, all)
      .add("bent 3 mm", turned(1, -30), bend(0.003, 0.24));
  const auto refused = [&all](const std::string& name, const Part& reference, const Part& object,
                              Reason reason) {
    Case each{name, reference, object, none(), moved(1, 31), {}, {}, reason};
    each.object_scan.seed = 2;
    all.push_back(each);
  };
  refused("wrong part: box for frame", photo_frame(0.003), box(true), Reason::kWrongPart);
  refused("wrong part: frame for box", box(true), photo_frame(0.003), Reason::kWrongPart);
  refused("wrong part: other panel", curved_panel(), other_panel(), Reason::kWrongPart);
  refused("wrong part: other moulding", photo_frame(0.003), other_frame(), Reason::kWrongPart);
  refused("wrong part: panel for box", box(true), curved_panel(), Reason::kWrongPart);
  refused("wrong part: cup for box", box(true), cup(), Reason::kWrongPart);
  refused("symmetric box", box(false), box(false), Reason::kAmbiguous);
  refused("cup", cup(), cup(), Reason::kAmbiguous);
  refused("symmetric box, symmetric path", box_with_loop(), box_with_loop(), Reason::kAccepted);
  all.back().own_image = true;
  Family("frame", photo_frame(0.003), true, all).add("x 2.6", turned(2.6, 10)).expected =
      Reason::kScaleAtBound;
  Family("frame", photo_frame(0.003), true, all).add("x 0.38", turned(0.38, 10)).expected =
      Reason::kScaleAtBound;
}

void add_real(const std::string& data, std::vector<Case>& all) {
  namespace fs = std::filesystem;
  unsigned seed = 40;
  for (const char* name : {"crs_part_1", "crs_part_2"}) {
    const fs::path folder = fs::path(data) / "parts" / name;
    if (data.empty() || !fs::exists(folder)) continue;
    const Part part = part_of_mesh(scan_cell_common::load_mesh((folder / "part.stl").string()),
                                   tool_paths::load_tool_path((folder / "toolpath.yaml").string()));
    Family real(name, part, false, all);
    real.add("any turn x 0.7", moved(0.7, ++seed));
    real.add("any turn x 1.4", moved(1.4, ++seed));
    real.add("bent 10 mm", moved(1, ++seed), bend(0.01, 2 * part.size));
    real.add("outliers 5 %", moved(1, ++seed)).object_scan.outliers = 0.05;
  }
}

}  // namespace

Scene scene_of(const Case& each) {
  const auto off_the_surface = [](ToolPath path, double distance) {
    for (auto& segment : path.segments) {
      for (auto& waypoint : segment.waypoints)
        waypoint.pose.translation() += distance * waypoint.pose.linear().col(2);
    }
    return path;
  };
  const ToolPath& path = each.reference.path;
  return {scan(each.reference, none(), Similarity(), each.reference_scan),
          scan(each.object, each.deformation, each.similarity, each.object_scan),
          off_the_surface(path, each.stand_off),
          off_the_surface(truth(path, each.deformation, each.similarity),
                          each.similarity.scale * each.stand_off)};
}

ToolPath truth_beside(const ToolPath& path, const Scene& scene, const Case& each) {
  if (!each.own_image) return scene.truth;
  ToolPath nearest = scene.truth;
  for (std::size_t s = 0; s < nearest.segments.size(); ++s) {
    auto& waypoints = nearest.segments[s].waypoints;
    for (std::size_t w = 0; w < waypoints.size(); ++w) {
      const Eigen::Vector3d at = path.segments.at(s).waypoints.at(w).pose.translation();
      const auto closer = [&at](const auto& a, const auto& b) {
        return (a.pose.translation() - at).norm() < (b.pose.translation() - at).norm();
      };
      const auto& candidates = scene.truth.segments[s].waypoints;
      waypoints[w] = *std::min_element(candidates.begin(), candidates.end(), closer);
    }
  }
  return nearest;
}

std::vector<Case> all_cases(const std::string& data) {
  std::vector<Case> all;
  add_frames(all);
  add_boxes(all);
  add_panels(all);
  add_others(all);
  add_real(data, all);
  add_harder(all);
  add_partial(all);
  return all;
}

}  // namespace cases
