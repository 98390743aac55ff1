// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace tecnogamma_camera {

/// A grey image that someone else owns: the pixels of a region of the sensor, row by row.
template <class Pixel>
struct ImageView {
  const Pixel* pixels = nullptr;  //!< owned by the caller
  int columns = 0;                //!< [px]
  int rows = 0;                   //!< [px]
  std::ptrdiff_t stride = 0;      //!< [pixels] from one row to the next
  int first_column = 0;           //!< [px] sensor column of the first pixel
  int first_row = 0;              //!< [px] sensor row of the first pixel

  /// The pixels of a row, from 0.
  const Pixel* row(int index) const { return pixels + index * stride; }
};

using ImageView8 = ImageView<std::uint8_t>;    //!< 8 bits a pixel
using ImageView16 = ImageView<std::uint16_t>;  //!< up to 16 bits a pixel

/// An ImageView8 or an ImageView16, depending on `bits`. Grey values are 0 .. 2^bits - 1, in the
/// host's byte order regardless of the order on the wire.
struct GreyImage : ImageView<void> {
  int bits = 8;  //!< of a grey value: 8, or 9 .. 16 in 16 bit pixels

  GreyImage() = default;
  /// @param grey_bits of a pixel that are used
  template <class Pixel>
  GreyImage(const ImageView<Pixel>& view, int grey_bits = 8 * static_cast<int>(sizeof(Pixel)))
      : ImageView<void>{view.pixels, view.columns,      view.rows,
                        view.stride, view.first_column, view.first_row},
        bits(grey_bits) {}

  int greatest_grey_value() const { return (1 << bits) - 1; }  //!< that a pixel may have
  int bytes_per_pixel() const { return bits > 8 ? 2 : 1; }     //!< 1 or 2

  /// @pre Pixel has bytes_per_pixel() bytes
  template <class Pixel>
  ImageView<Pixel> as() const {
    return {static_cast<const Pixel*>(pixels), columns, rows, stride, first_column, first_row};
  }
};

/// Calls `visitor` with the image as an ImageView8 or ImageView16, whichever it is.
template <class Visitor>
void visit(const GreyImage& image, const Visitor& visitor) {
  if (image.bytes_per_pixel() == 2) {
    visitor(image.as<std::uint16_t>());
  } else {
    visitor(image.as<std::uint8_t>());
  }
}

}  // namespace tecnogamma_camera
