// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace scan_cell_rviz {

/// What a stage would take, in the view and on the page. Told apart by all eyes (Okabe and Ito,
/// Color Universal Design), and all darker than what stays.
struct StageColour {
  const char* stage;
  float red, green, blue;  // 0 .. 1
};
inline constexpr std::array<StageColour, 3> kStageColours = {{{"floor", 0.00F, 0.45F, 0.70F},
                                                              {"outliers", 0.80F, 0.47F, 0.65F},
                                                              {"isolate", 0.00F, 0.62F, 0.45F}}};

}  // namespace scan_cell_rviz
