// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

namespace tecnogamma_camera {

/// The value of a row without a peak.
constexpr float kNoPeak = std::numeric_limits<float>::quiet_NaN();

/// The laser line of one frame. Each array has one element a row, from sensor row first_row
/// downwards; all three are quiet NaN if the row has no peak. Pixel centres are whole numbers.
struct PeakProfile {
  int first_row = 0;             //!< [px] sensor row of element 0
  std::vector<float> position;   //!< [px] sensor column of the peak
  std::vector<float> width;      //!< [px] columns of the stripe, from rising to falling edge
  std::vector<float> intensity;  //!< [grey value] brightest pixel of the stripe

  int rows() const { return static_cast<int>(position.size()); }  //!< of each array

  /// All rows without a peak. Allocates only where the number of rows grows.
  void clear(int new_first_row, int rows) {
    first_row = new_first_row;
    position.assign(rows, kNoPeak);
    width.assign(rows, kNoPeak);
    intensity.assign(rows, kNoPeak);
  }
};

}  // namespace tecnogamma_camera
