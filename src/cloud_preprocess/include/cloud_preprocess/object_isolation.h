// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/limits.h"
#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

enum class Selection { kAll, kLargest, kNearest, kIndex };
enum class Axis { kX, kY, kZ };

struct IsolationParameters {
  Selection select = Selection::kLargest;           //!< kAll: only the limits cut
  double gap = 0.01;                                //!< [m] objects are at least this far apart
  int least_points = 200;                           //!< fewer are no object
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  //!< [m] kNearest: the object nearest to this
  Axis axis = Axis::kX;                             //!< kIndex: objects are counted along this axis
  int index = 0;                                    //!< kIndex: which of them, the first is 0
  Limits limits;
};

template <class Reader>
void describe(Reader& reader, IsolationParameters& parameters) {
  using Range = typename Reader::Range;
  describe_choice(reader, "select", parameters.select, {"all", "largest", "nearest", "index"});
  reader.read("gap", parameters.gap, Range{1e-4, 1});
  reader.read("least_points", parameters.least_points, Range{1, 1e9});
  describe_vector(reader, "point", parameters.point, {-1e3, 1e3});
  describe_choice(reader, "axis", parameters.axis, {"x", "y", "z"});
  reader.read("index", parameters.index, Range{0, 1e6});
  describe(reader, parameters.limits);
}

/// Keeps one object of those that lie side by side: an object is a cluster of points with gaps
/// below a given one. The largest is the one with the most points; along an axis, objects are
/// ordered by the middle of their extent.
class ObjectIsolation final : public Stage {
 public:
  using Parameters = IsolationParameters;

  /// @throw scan_cell_common::InvalidParameter
  explicit ObjectIsolation(const IsolationParameters& parameters);

  std::string name() const override { return "isolate"; }

 private:
  std::string apply(Cloud& cloud) const override;

  IsolationParameters parameters_;
};

}  // namespace cloud_preprocess
