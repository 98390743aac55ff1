// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "case_list.h"
#include "scan_cell_common/pose/units.h"

namespace cases {
namespace {

using tool_path_stretcher::Reason;

using scan_cell_common::kDegree;

/// Collects cases, each with its own seeds.
class Cases {
 public:
  explicit Cases(std::vector<Case>& all) : all_(all) {}

  Case& add(const std::string& name, const Part& part, double scale,
            const Deformation& deformation = none()) {
    seed_ += 10;
    Case each{name, part, part, deformation, {scale, random_rotation(seed_), {-0.17, 0.24, 0.09}},
              {},   {}};
    each.reference_scan.seed = seed_ + 1;
    each.object_scan.seed = seed_ + 2;
    all_.push_back(each);
    return all_.back();
  }

 private:
  std::vector<Case>& all_;
  unsigned seed_ = 7000;
};

void add_brackets(Cases& cases) {
  cases.add("bracket, any turn x 1.3", bracket(), 1.3);
  cases.add("bracket, bent 4 mm, holes", bracket(), 1, bend(0.004, 0.12)).object_scan.hole = 0.005;
  Case& loose = cases.add("bracket, outliers, floor, uneven", bracket(), 0.9);
  loose.object_scan.outliers = 0.05;
  loose.object_scan.floor = true;
  loose.object_scan.density_ratio = 4;
}

void add_shafts(Cases& cases) {
  cases.add("shaft with keyway, any turn x 0.8", shaft(true), 0.8);
  cases.add("shaft with keyway, bent 2 mm", shaft(true), 1.1,
            both([](const Eigen::Vector3d& p)
                     -> Eigen::Vector3d { return p - Eigen::Vector3d(0.08, 0, 0); },
                 bend(0.002, 0.16)));
  cases.add("shaft without keyway", shaft(false), 1).expected = Reason::kAmbiguous;
  Case& unseen = cases.add("shaft, keyway not scanned", shaft(true), 1);
  unseen.object_scan.share = 0.62;
  unseen.expected = Reason::kAmbiguous;
  cases.add("shaft without keyway, path once around", shaft_with_ring(), 1.2).own_image = true;
}

void add_plates(Cases& cases) {
  Case& dented = cases.add("ribbed plate, dent, floor, outliers", ribbed_plate(), 1.05,
                           bulge(-0.0015, 0.015, {-0.015, 0}));
  dented.object_scan.outliers = 0.03;
  dented.object_scan.floor = true;
  Case& twisted = cases.add("ribbed plate, twisted 3 deg, uneven, holes", ribbed_plate(), 0.95,
                            twist(3 * kDegree, 0.24));
  twisted.object_scan.density_ratio = 6;
  twisted.object_scan.hole = 0.006;
  Case& partial = cases.add("ribbed plate, 70 % scanned", ribbed_plate(), 1.2);
  partial.object_scan.share = 0.7;
  Case& known = cases.add("ribbed plate, reference of 70 %", ribbed_plate(), 1);
  known.reference_scan.share = 0.7;
  Case& variant = cases.add("wrong part: ribbed plate with a rib in the path", ribbed_plate(), 1);
  variant.object = ribbed_plate(-0.020);
  variant.expected = Reason::kWrongPart;
  variant.also = Reason::kToleranceExceeded;
}

void add_elbows(Cases& cases) {
  cases.add("elbow, any turn x 0.7", elbow(), 0.7);
  // In the middle of the bend, outwards: a hill along the surface would not show.
  const Eigen::Vector3d out = Eigen::Vector3d(-1, 0, 1).normalized();
  const Eigen::Vector3d middle = Eigen::Vector3d(0.08, 0, 0) + 0.105 * out;
  cases.add("elbow, bulged 2 mm, holes", elbow(), 1.1, bulge_at(middle, 0.002 * out, 0.03))
      .object_scan.hole = 0.005;
  cases.add("elbow, twice the noise, outliers", elbow(), 1.5).object_scan = {
      20000, 0.0002, false, 1, false, 1, 0, 0.05, false, 7654};
}

void add_frames_and_panels(Cases& cases) {
  Case& rim = cases.add("frame, filed away from the path", photo_frame(0.003), 1.1,
                        filed({0, -1, 0.3}, 0.0735 / std::hypot(1, 0.3)));
  rim.reference_scan.from_above = rim.object_scan.from_above = true;
  Case& crest = cases.add("frame, crest filed 1.8 mm on one side", photo_frame(0.003), 1,
                          filed({0, -0.08, 1}, 0.0227 / std::hypot(1, 0.08)));
  crest.reference_scan.from_above = crest.object_scan.from_above = true;
  // The rosette is gone too, which was all that told one end from the other.
  Case& flat =
      cases.add("frame, whole crest filed flat", photo_frame(0.003), 1, filed({0, 0, 1}, 0.0175));
  flat.reference_scan.from_above = flat.object_scan.from_above = true;
  flat.expected = Reason::kAmbiguous;
  const Part middle = with_path_between(curved_panel(), 0.25, 0.75);
  cases.add("panel, stand-off 15 mm, bent 5 mm", curved_panel(), 1, bend(0.005, 0.3)).stand_off =
      0.015;
  Case& ends = cases.add("panel, reference of 90 %, other 80 % scanned", middle, 1.1);
  ends.reference_scan.share = 0.9;
  ends.object_scan.share = 0.8;
  ends.object_scan.far_end = true;
  Case& half = cases.add("panel, half scanned, path within",
                         with_path_between(curved_panel(), 0.1, 0.45), 1.3, bend(0.003, 0.3));
  half.object_scan.share = 0.55;
  Case& strip = cases.add("panel, dent, floor, outliers, uneven", curved_panel(), 0.9,
                          bulge(-0.0015, 0.015, {0.02, -0.04}));
  strip.object_scan.floor = true;
  strip.object_scan.outliers = 0.05;
  strip.object_scan.density_ratio = 5;
}

void add_wrong_parts(Cases& cases) {
  const auto wrong = [&cases](const std::string& name, const Part& reference, const Part& object) {
    Case& each = cases.add("wrong part: " + name, reference, 1);
    each.object = object;
    each.expected = Reason::kWrongPart;
  };
  wrong("elbow for bracket", bracket(), elbow());
  wrong("shaft for elbow", elbow(), shaft(true));
  wrong("bracket for ribbed plate", ribbed_plate(), bracket());
}

}  // namespace

void add_harder(std::vector<Case>& all) {
  Cases cases(all);
  add_brackets(cases);
  add_shafts(cases);
  add_plates(cases);
  add_elbows(cases);
  add_frames_and_panels(cases);
  add_wrong_parts(cases);
}

}  // namespace cases
