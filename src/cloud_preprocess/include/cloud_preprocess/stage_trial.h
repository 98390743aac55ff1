// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cloud_preprocess/clean.h"

namespace cloud_preprocess {

/// What one stage takes of a cloud.
struct StageTaking {
  StageReport report;                 //!< its name among it
  std::vector<std::uint32_t> points;  //!< of the cloud, ascending
  std::string error;                  //!< why it cannot be done; empty: it can
};

/// Tries the stages floor, outliers and isolate on one cloud again and again, while a person moves
/// their parameters. What each takes is what clean() lets it take. A stage is run anew only where
/// its parameters, or those of a stage before it, are others than the time before. Not safe for use
/// from several threads.
class StageTrial {
 public:
  explicit StageTrial(Cloud cloud);  //!< [m] after the edits by hand

  /// @return one a stage, up to the first that cannot be done
  std::vector<StageTaking> run(const CleanParameters& parameters);

 private:
  /// A stage as it was run last.
  struct Step {
    std::string settings;
    StageTaking taking;
    TracedCloud left;
  };

  TracedCloud cloud_;
  std::vector<Step> steps_;
};

}  // namespace cloud_preprocess
