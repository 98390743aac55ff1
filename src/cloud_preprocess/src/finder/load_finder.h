// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "cloud_preprocess/object_isolation.h"

namespace cloud_preprocess {

/// The plugin that finds the object of a reference, which it has loaded; null where the parameters
/// select otherwise.
/// @throw scan_cell_common::Refused where no package has such a plugin
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput of the reference's file
std::shared_ptr<const ReferenceFinder> load_finder(const IsolationParameters& parameters);

}  // namespace cloud_preprocess
