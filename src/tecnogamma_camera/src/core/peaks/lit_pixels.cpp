// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "peaks/lit_pixels.h"

#include <algorithm>

#include "peaks/vector_clones.h"

namespace tecnogamma_camera {
namespace {

constexpr int kBits = kLevelColumns;           // of a word
constexpr int kWordsOfBlock = 2;               // chosen
constexpr int kBlock = kWordsOfBlock * kBits;  // [px]

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
  constexpr int kGroup = 8;  // bits of a byte
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

/// Range of words; empty where no pixel is lit.
struct Words {
  int first = 0;
  int end = 0;

  void add(int from, int to) {
    if (end == 0) first = from;
    end = to;
  }
};

/// Writes the words of the lit blocks and of the dark ones between them.
template <class Pixel>
TECNOGAMMA_INLINE Words mark_blocks(const Pixel* row, int columns, const Pixel* levels,
                                    std::uint64_t* words) {
  Words lit;
  int word = 0;
  for (; (word + kWordsOfBlock) * kBits <= columns; word += kWordsOfBlock) {
    const Pixel* const block = row + word * kBits;
    if (brightest(block, kBlock) <= std::min(levels[word], levels[word + 1])) {
      std::fill_n(words + word, kWordsOfBlock, 0);
      continue;
    }
    for (int i = 0; i < kWordsOfBlock; ++i)
      words[word + i] = lit_bits(block + i * kBits, kBits, levels[word + i]);
    lit.add(word, word + kWordsOfBlock);
  }
  for (; word * kBits < columns; ++word) {
    const Pixel* const rest = row + word * kBits;
    const int count = std::min(kBits, columns - word * kBits);
    words[word] = 0;
    if (brightest(rest, count) <= levels[word]) continue;
    words[word] = lit_bits(rest, count, levels[word]);
    lit.add(word, word + 1);
  }
  return lit;
}

TECNOGAMMA_VECTOR_CLONES Words mark_row(const std::uint8_t* row, int columns,
                                        const std::uint8_t* levels, std::uint64_t* words) {
  return mark_blocks(row, columns, levels, words);
}

TECNOGAMMA_VECTOR_CLONES Words mark_row(const std::uint16_t* row, int columns,
                                        const std::uint16_t* levels, std::uint64_t* words) {
  return mark_blocks(row, columns, levels, words);
}

}  // namespace

template <class Pixel>
void LitPixels::mark_pixels(const Pixel* row, int columns, const std::vector<Pixel>& levels) {
  columns_ = columns;
  words_.resize(static_cast<std::size_t>(levels_of(columns)));
  const Words lit = mark_row(row, columns, levels.data(), words_.data());
  lit_from_ = lit.first;
  dark_from_ = lit.end;
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
