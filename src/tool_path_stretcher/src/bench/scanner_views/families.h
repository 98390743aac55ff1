// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scanner_views/view_case.h"

namespace scanner_views {

// Each family does one thing to a part; everything else is random.
// @param seed the same seed gives the same case

ViewCase moved_case(const ViewPart& part, std::uint64_t seed);
ViewCase bent_case(const ViewPart& part, std::uint64_t seed);
ViewCase scaled_case(const ViewPart& part, std::uint64_t seed);
ViewCase warped_case(const ViewPart& part, std::uint64_t seed);
ViewCase dented_case(const ViewPart& part, std::uint64_t seed);
ViewCase scene_case(const ViewPart& part, std::uint64_t seed);
/// The part's own path, unchanged, including moves through the air.
ViewCase own_path_case(const ViewPart& part, std::uint64_t seed);
ViewCase bent_own_path_case(const ViewPart& part, std::uint64_t seed);
ViewCase symmetric_case(const ViewPart& part, std::uint64_t seed);
/// The part lies on its working side.
ViewCase upside_down_case(const ViewPart& part, std::uint64_t seed);
ViewCase mirrored_case(const ViewPart& part, std::uint64_t seed);
ViewCase wrong_case(const ViewPart& reference, const ViewPart& object, std::uint64_t seed);

}  // namespace scanner_views
