// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cloud_preprocess/clean.h"

namespace cloud_preprocess {

/// The points that one stage removes from a cloud.
struct StageTaking {
  StageReport report;                 //!< including the stage's name
  std::vector<std::uint32_t> points;  //!< indices of the points, ascending
  std::string error;                  //!< why the stage fails; empty if it does not
};

/// Tries the stages floor, outliers and isolate on one cloud repeatedly while a person changes
/// their parameters. Each removes what it would remove in clean(). A stage runs again only if its
/// parameters, or those of an earlier stage, have changed. Not thread-safe.
class StageTrial {
 public:
  explicit StageTrial(Cloud cloud);  //!< [m] after the edits by hand

  /// @return one per stage, up to the first that fails
  std::vector<StageTaking> run(const CleanParameters& parameters);

 private:
  /// The last run of a stage.
  struct Step {
    std::string settings;
    StageTaking taking;
    TracedCloud left;
  };

  TracedCloud cloud_;
  std::vector<Step> steps_;
};

}  // namespace cloud_preprocess
