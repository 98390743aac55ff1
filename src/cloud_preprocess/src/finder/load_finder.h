// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "cloud_preprocess/object_isolation.h"

namespace cloud_preprocess {

/// The plugin that finds a reference's object, with the reference loaded; null if the parameters
/// select otherwise.
/// @throw scan_cell_common::Refused if no package has such a plugin
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput for the reference's file
std::shared_ptr<const ReferenceFinder> load_finder(const IsolationParameters& parameters);

}  // namespace cloud_preprocess
