// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lit_pixels.h"
#include "tecnogamma_camera/image_view.h"

namespace tecnogamma_camera {

/// What the pixels of a tile are like where no laser is: median and scatter, by two low quantiles
/// that a line through the tile does not reach.
struct TileLight {
  double background = 0;  //!< [grey value]
  double noise = 0;       //!< [grey value] standard deviation, with the tile's own slope in it
  bool measured = false;
};

/// Straight line through the background about a column.
struct BackgroundLine {
  double value = 0;  //!< [grey value] at that column
  double slope = 0;  //!< [grey values/px]
};

/// The light of a frame that is not the laser's: dark offset, ambient light and its gradient, in
/// tiles of kTileColumns x kBandRows pixels of which four rows are looked at. The last tile of a
/// row reaches back over the one before it. A tile is measured when it is first asked for.
template <class Pixel>
class Background {
 public:
  static constexpr int kBandRows = 128;

  explicit Background(const ImageView<Pixel>& image);

  const TileLight& tile(int row, int tile);

  /// About a column: through the middles of its tile and of the next one on its side; level where
  /// there is no next one, or where it overlaps by more than a half.
  BackgroundLine about(int row, int column);

 private:
  TileLight measure(int band, int tile, const TileLight& guess) const;
  int first_column_of(int tile) const;

  ImageView<Pixel> image_;
  int tiles_;
  std::vector<TileLight> light_;
};

extern template class Background<std::uint8_t>;
extern template class Background<std::uint16_t>;

}  // namespace tecnogamma_camera
