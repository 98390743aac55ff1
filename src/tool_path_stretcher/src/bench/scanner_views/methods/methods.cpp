// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/methods/methods.h"

#include "stopwatch.h"
#include "tool_path_stretcher/seen_from.h"
#include "yardsticks/pcl_pipeline.h"
#include "yardsticks/thesis_method.h"

namespace scanner_views {
namespace {

using namespace tool_path_stretcher;

Surface reference_of(const View& view, const Eigen::Vector3d& leaf) {
  return view.reference_mesh ? surface_from_mesh(*view.reference_mesh, leaf, "reference")
                             : surface_from_cloud(view.reference_scan.places, leaf, "reference");
}

}  // namespace

Reduced reduced(const View& view) {
  const Eigen::Vector3d leaf = StretchParameters().leaf;
  return {reference_of(view, leaf).points,
          surface_from_cloud(view.object.places, leaf, "object").points};
}

Answer run_ours(const View& view) {
  const StretchParameters parameters;
  const Points seen_from = directions_seen_from(view.object.places, view.object.seen_from);
  StretchResult result;
  Answer answer;
  answer.seconds = bench::seconds_of([&] {
    result = stretch(reference_of(view, parameters.leaf),
                     surface_from_cloud(view.object.places, parameters.leaf, "object", seen_from),
                     view.path, parameters);
  });
  answer.accepted = result.verdict.accepted();
  answer.verdict = to_string(result.verdict.reason);
  answer.message = result.verdict.message;
  answer.path = std::move(result.path);
  answer.quality = std::move(result.quality);
  return answer;
}

Answer run_thesis(const View& view) {
  const Reduced clouds = reduced(view);
  Answer answer;
  answer.accepted = true;
  answer.seconds = bench::seconds_of(
      [&] { answer.path = cases::thesis_method(clouds.reference, clouds.object, view.path); });
  return answer;
}

Answer run_pcl(const View& view) {
  const Reduced clouds = reduced(view);
  Answer answer;
  cases::PclResult result;
  answer.seconds = bench::seconds_of(
      [&] { result = cases::pcl_pipeline(clouds.reference, clouds.object, view.path); });
  answer.accepted = result.converged;
  answer.verdict = result.converged ? "converged" : "not";
  answer.path = std::move(result.path);
  return answer;
}

}  // namespace scanner_views
