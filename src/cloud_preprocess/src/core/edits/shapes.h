// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cloud_preprocess/cloud_edits.h"

namespace cloud_preprocess {

/// Whether each point lies in a shape.
std::vector<bool> points_in(const Cloud& cloud, const BoxShape& box);
std::vector<bool> points_in(const Cloud& cloud, const HalfSpace& half);
std::vector<bool> points_in(const Cloud& cloud, const PrismShape& prism);
std::vector<bool> points_in(const Cloud& cloud, const BrushShape& brush);
std::vector<bool> points_in(const Cloud& cloud, const ClusterShape& cluster);

}  // namespace cloud_preprocess
