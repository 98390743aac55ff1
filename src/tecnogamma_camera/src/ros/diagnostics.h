// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "acquisition/acquisition.h"

namespace tecnogamma_camera {

/// ERROR: not connected, or the scanner model is for another camera. WARN: stopped by a loss, or
/// frames were lost since `before`.
/// @param fault of the scanner model; empty: none
void write_diagnostics(const AcquisitionState& before, const AcquisitionState& now,
                       const std::string& fault,
                       diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace tecnogamma_camera
