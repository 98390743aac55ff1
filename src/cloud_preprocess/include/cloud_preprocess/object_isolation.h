// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cloud_preprocess/limits.h"
#include "cloud_preprocess/reference_finder.h"
#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

/// Which object is kept.
enum class Selection { kAll, kLargest, kNearest, kIndex, kReference };
/// An axis of the cloud's frame.
enum class Axis { kX, kY, kZ };

/// Parameters of the stage isolate; see docs/cloud_preprocess.md.
struct IsolationParameters {
  Selection select = Selection::kLargest;           //!< kAll: only the limits cut
  double gap = 0.01;                                //!< [m] objects are at least this far apart
  int min_points = 200;                             //!< a cluster with fewer is no object
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  //!< [m] kNearest: the object nearest to this
  bool across_shadows = true;                       //!< joins pieces with no floor seen between
  Axis axis = Axis::kX;                             //!< kIndex: objects are counted along this axis
  int index = 0;                                    //!< kIndex: which object, from 0
  std::string reference;                            //!< kReference: file of the part to look for
  std::string reference_units = "m";                //!< kReference: units of that file
  Limits limits;                                    //!< by hand, cut before all else
  std::shared_ptr<const ReferenceFinder> finder;    //!< kReference: has loaded that file
};

/// Describes every parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, IsolationParameters& parameters);

/// Keeps one of several objects side by side. An object is a cluster of points with gaps below a
/// given one. Several clusters are one object if nothing was seen between them, not even the floor
/// that the stage floor has found. The largest object has the most points; along an axis, objects
/// are ordered by the middle of their extent. With a reference, the object is what the reference
/// explains, plus what stands over it or is nearer to it than the gap.
class ObjectIsolation final : public Stage {
 public:
  using Parameters = IsolationParameters;  //!< parameters of this stage

  /// @throw scan_cell_common::InvalidParameter
  explicit ObjectIsolation(const IsolationParameters& parameters);

  std::string name() const override { return "isolate"; }  //!< name of the stage

  /// Each object as a separate cloud, along the axis; the whole cloud if all are kept.
  /// @param cloud finite and not empty
  /// @param kept what run() left of it
  /// @throw scan_cell_common::UnusableInput as run()
  std::vector<TracedCloud> objects(TracedCloud cloud, const TracedCloud& kept) const;

 private:
  std::string apply(TracedCloud& cloud) const override;

  IsolationParameters parameters_;
};

}  // namespace cloud_preprocess
