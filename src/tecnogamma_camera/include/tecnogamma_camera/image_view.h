// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace tecnogamma_camera {

/// A grey image that someone else owns: the pixels of a region of the sensor, row by row.
template <class Pixel>
struct ImageView {
  const Pixel* pixels = nullptr;
  int columns = 0;
  int rows = 0;
  std::ptrdiff_t stride = 0;  //!< [pixels] from one row to the next
  int first_column = 0;       //!< [px] sensor column of the first pixel
  int first_row = 0;          //!< [px] sensor row of the first pixel

  const Pixel* row(int index) const { return pixels + index * stride; }
};

using ImageView8 = ImageView<std::uint8_t>;

}  // namespace tecnogamma_camera
