// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lit_pixels.h"

#include <algorithm>

#include "vector_clones.h"

namespace tecnogamma_camera {
namespace {

constexpr int kBits = 64;  // of a word
constexpr int kWordsOfTile = kTileColumns / kBits;

template <class Pixel>
TECNOGAMMA_INLINE Pixel brightest(const Pixel* row, int columns) {
  Pixel most = 0;
  for (int i = 0; i < columns; ++i)
    most = std::max(most, row[i]);
  return most;
}

/// One bit a pixel, from the lowest on.
template <class Pixel>
TECNOGAMMA_INLINE std::uint64_t lit_bits(const Pixel* row, int columns, Pixel level) {
  constexpr int kGroup = 8;
  std::uint8_t lit[kBits] = {};
  for (int i = 0; i < columns; ++i)
    lit[i] = row[i] > level;
  std::uint64_t bits = 0;
  for (int first = 0; first < kBits; first += kGroup) {
    std::uint64_t group = 0;
    for (int i = 0; i < kGroup; ++i)
      group |= static_cast<std::uint64_t>(lit[first + i]) << (kGroup * i);
    // The product gathers the lowest bit of each byte in its highest byte, in the same order.
    bits |= (group * 0x0102040810204080U >> (kBits - kGroup)) << first;
  }
  return bits;
}

/// Range of tiles; empty where none is lit.
struct Tiles {
  int first = 0;
  int end = 0;

  void add(int tile) {
    if (end == 0) first = tile;
    end = tile + 1;
  }
};

/// Writes the words of the lit tiles and of the dark ones between them.
template <class Pixel>
TECNOGAMMA_INLINE Tiles mark_tiles(const Pixel* row, int columns, const Pixel* levels,
                                   std::uint64_t* words) {
  Tiles lit;
  const int whole = columns / kTileColumns;
  for (int tile = 0; tile < whole; ++tile) {
    const Pixel* const pixels = row + tile * kTileColumns;
    std::uint64_t* const bits = words + tile * kWordsOfTile;
    if (brightest(pixels, kTileColumns) <= levels[tile]) {
      std::fill_n(bits, kWordsOfTile, 0);
      continue;
    }
    for (int i = 0; i < kWordsOfTile; ++i)
      bits[i] = lit_bits(pixels + i * kBits, kBits, levels[tile]);
    lit.add(tile);
  }
  const int first = whole * kTileColumns;
  if (first == columns || brightest(row + first, columns - first) <= levels[whole]) return lit;
  for (int column = first; column < columns; column += kBits)
    words[column / kBits] =
        lit_bits(row + column, std::min(kBits, columns - column), levels[whole]);
  lit.add(whole);
  return lit;
}

TECNOGAMMA_VECTOR_CLONES Tiles mark_row(const std::uint8_t* row, int columns,
                                        const std::uint8_t* levels, std::uint64_t* words) {
  return mark_tiles(row, columns, levels, words);
}

TECNOGAMMA_VECTOR_CLONES Tiles mark_row(const std::uint16_t* row, int columns,
                                        const std::uint16_t* levels, std::uint64_t* words) {
  return mark_tiles(row, columns, levels, words);
}

}  // namespace

template <class Pixel>
void LitPixels::mark_pixels(const Pixel* row, int columns, const std::vector<Pixel>& levels) {
  const int words = (columns + kBits - 1) / kBits;
  columns_ = columns;
  words_.resize(static_cast<std::size_t>(words));
  const Tiles lit = mark_row(row, columns, levels.data(), words_.data());
  lit_from_ = lit.first * kWordsOfTile;
  dark_from_ = std::min(words, lit.end * kWordsOfTile);
}

void LitPixels::mark(const std::uint8_t* row, int columns,
                     const std::vector<std::uint8_t>& levels) {
  mark_pixels(row, columns, levels);
}

void LitPixels::mark(const std::uint16_t* row, int columns,
                     const std::vector<std::uint16_t>& levels) {
  mark_pixels(row, columns, levels);
}

}  // namespace tecnogamma_camera
