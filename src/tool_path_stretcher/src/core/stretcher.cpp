// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/stretcher.h"

#include <algorithm>
#include <chrono>

#include "adaptation.h"
#include "scan_cell_common/errors/errors.h"
#include "scene/own_place.h"
#include "sight/seeable.h"
#include "stages.h"
#include "thesis/thesis_fit.h"
#include "verdict/checks.h"
#include "views/views.h"

namespace tool_path_stretcher {
namespace {

StretchResult begun(const Surface& reference, const Surface& object,
                    const StretchParameters& parameters) {
  StretchResult result;
  result.method = parameters.method;
  result.reference_points = reference.points.size();
  result.object_points = object.points.size();
  return result;
}

/// Adapts with the whole reference, or with its visible part if the prior has a view.
Attempt attempt(const SurfacePair& surfaces, const ToolPath& path,
                const StretchParameters& parameters, const Stages& stages) {
  const bool is_whole = !parameters.prior.view;
  Attempt attempt{is_whole, begun(surfaces.reference, surfaces.object, parameters)};
  try {
    stages.report("check", 0);
    check_surfaces(surfaces, parameters);
    const bool has_path = !path.segments.empty();
    if (has_path && is_whole) check_path(path, surfaces.reference, parameters);
    if (has_path && !is_whole) check_seeable(path, surfaces.reference, parameters);
    Adaptation adaptation(surfaces, path, parameters, stages);
    stages.report("align", 0.05);
    adaptation.run(attempt);
  } catch (const Refusal& refusal) {
    attempt.result.verdict = refusal.verdict;
  }
  return attempt;
}

/// No scan sees all of a closed reference, and either face of a sheet would match the scan.
StretchResult stretch_closed(const SurfacePair& surfaces, const ToolPath& path,
                             const StretchParameters& parameters, const Progress& progress) {
  constexpr double kFirst = 0.3;  // of the work; a guess for the bar
  std::vector<Attempt> attempts = {
      attempt(surfaces, path, parameters, Stages(progress, 0, kFirst))};
  const std::vector<ViewPrior> views = possible_views(surfaces, attempts.front());
  const double each = (1 - kFirst) / std::max(1.0, static_cast<double>(views.size()));
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (attempts.back().result.verdict.reason == Reason::kCancelled) return attempts.back().result;
    const Surface seeable = seeable_part(surfaces.reference, views[i].of_reference);
    if (seeable.points.size() < static_cast<std::size_t>(parameters.min_points)) continue;
    StretchParameters with_view = parameters;
    with_view.prior.view = views[i];
    const double from = kFirst + each * static_cast<double>(i);
    attempts.push_back(
        attempt({seeable, surfaces.object}, path, with_view, Stages(progress, from, from + each)));
  }
  return judge(attempts, path, surfaces, parameters);
}

StretchResult stretch_onto(const SurfacePair& surfaces, const ToolPath& path,
                           const StretchParameters& parameters, const Progress& progress) {
  return surfaces.reference.closed && !is_thesis(parameters.method)
             ? stretch_closed(surfaces, path, parameters, progress)
             : attempt(surfaces, path, parameters, Stages(progress)).result;
}

bool explains_too_little(const StretchResult& result, const StretchParameters& parameters) {
  return result.verdict.reason == Reason::kWrongPart && result.aligned &&
         result.inlier_ratio < parameters.min_inlier_ratio;
}

StretchResult stretch_in_scene(const SurfacePair& surfaces, const ToolPath& path,
                               const StretchParameters& parameters, const Progress& progress) {
  const StretchResult result = stretch_onto(surfaces, path, parameters, progress);
  if (!explains_too_little(result, parameters)) return result;
  const Progress still_at_work = [&progress](const std::string& stage, double) {
    constexpr double kLate = 0.9;  // of the work; a guess for the bar
    return !progress || progress(stage, kLate);
  };
  const auto onto = [&](const Surface& part) {
    return stretch_onto({surfaces.reference, part}, path, parameters, still_at_work);
  };
  return stretch_in_own_place(surfaces.object, path, result, parameters, onto);
}

/// Does not throw: the verdict tells what is wrong with the path.
StretchResult without_a_path(const ToolPath& path, StretchResult result) {
  try {
    check(path);
  } catch (const scan_cell_common::UnusableInput& error) {
    result.verdict = {Reason::kUnusableInput, error.what(), {}};
  }
  return result;
}

}  // namespace

StretchResult stretch(const Surface& reference, const Surface& object, const ToolPath& path,
                      const StretchParameters& parameters, const Progress& progress) {
  check(parameters);
  const auto start = std::chrono::steady_clock::now();
  StretchResult result = path.segments.empty()
                             ? without_a_path(path, begun(reference, object, parameters))
                             : stretch_in_scene({reference, object}, path, parameters, progress);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

StretchResult lay(const Surface& reference, const Surface& object,
                  const StretchParameters& parameters, const Progress& progress) {
  check(parameters);
  StretchParameters alone = parameters;
  alone.method = Method::kGeneral;
  alone.resample_spacing = 0;
  return stretch_in_scene({reference, object}, {}, alone, progress);
}

}  // namespace tool_path_stretcher
