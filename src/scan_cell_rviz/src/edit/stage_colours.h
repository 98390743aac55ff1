// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace scan_cell_rviz {

/// Colours of what each stage would remove, in the view and on the page. They can be told apart
/// with any colour vision (Okabe and Ito, Color Universal Design), and are darker than the rest.
struct StageColour {
  const char* stage;
  float red, green, blue;  // 0 .. 1
};
inline constexpr std::array<StageColour, 3> kStageColours = {{{"floor", 0.00F, 0.45F, 0.70F},
                                                              {"outliers", 0.80F, 0.47F, 0.65F},
                                                              {"isolate", 0.00F, 0.62F, 0.45F}}};

}  // namespace scan_cell_rviz
