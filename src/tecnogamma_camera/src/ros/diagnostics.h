// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "tecnogamma_camera/acquisition.h"

namespace tecnogamma_camera {

/// ERROR: not connected. WARN: stopped by a loss, or frames were lost since `before`.
void write_diagnostics(const AcquisitionState& before, const AcquisitionState& now,
                       diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace tecnogamma_camera
