// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <chrono>
#include <optional>

#include "c4g_driver/client.h"

namespace c4g_driver {

/// The /diagnostics of the link: totals, and what has come since the last report.
class LinkDiagnosis {
 public:
  void report(const LinkReport& link, diagnostic_updater::DiagnosticStatusWrapper& status);

 private:
  LinkReport before_;
  std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
};

/// The /diagnostics of the robot.
/// @param state the latest; none without a link
void report(const std::optional<MeasuredState>& state,
            diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace c4g_driver
