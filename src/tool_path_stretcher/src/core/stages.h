// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>

#include "search/candidates.h"
#include "tool_path_stretcher/stretcher.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {

/// Reports progress to the caller, and ends the work if the caller asks for it.
class Stages {
 public:
  /// @param from,to shares of the whole work
  explicit Stages(const Progress& progress, double from = 0, double to = 1)
      : progress_(progress), from_(from), to_(to) {}

  void report(const std::string& stage, double done) const {
    if (progress_ && !progress_(stage, from_ + done * (to_ - from_))) {
      throw Refusal{{Reason::kCancelled, fmt::format("cancelled during '{}'", stage), {}}};
    }
  }

  AlignmentProgress within(const std::string& stage, double from, double to) const {
    return [this, stage, from, to](double share) { report(stage, from + share * (to - from)); };
  }

 private:
  const Progress& progress_;
  double from_, to_;
};

/// Reports how many of a stage's equal parts are done, from any thread but one at a time.
class Parts {
 public:
  /// @param from,to shares of the whole work at the stage's begin and end
  Parts(const Stages& stages, std::string stage, double from, double to, std::size_t count)
      : progress_(stages.within(std::move(stage), from, to)), count_(count) {}

  void one_done() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (cancelled_) return;
    cancelled_ = true;  // unless it returns
    progress_(static_cast<double>(++done_) / static_cast<double>(count_));
    cancelled_ = false;
  }

 private:
  const AlignmentProgress progress_;
  const std::size_t count_;
  std::mutex mutex_;
  bool cancelled_ = false;
  std::size_t done_ = 0;
};

}  // namespace tool_path_stretcher
