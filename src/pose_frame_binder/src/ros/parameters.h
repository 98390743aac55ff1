// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "frame_lookup.h"
#include "profile_binder.h"

namespace pose_frame_binder {

struct Parameters {
  Settings settings;
  Frames frames;
  LookupParameters lookup;
  double transform_timeout = 2;  //!< [s]
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, Parameters& parameters);

}  // namespace pose_frame_binder
