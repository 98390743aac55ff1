// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tecnogamma_camera {

/// Columns that share a trigger level.
constexpr int kLevelColumns = 64;  // [px] the bits of a word

inline int levels_of(int columns) {
  return (columns + kLevelColumns - 1) / kLevelColumns;
}

/// Which pixels of a row are above the trigger level of their columns, one bit a pixel.
///
/// A laser line lights a few pixels of a row, so nearly all of the time goes into skipping dark
/// ones. They are skipped a block at a time, by its brightest pixel, in a loop that compilers
/// vectorise. The lit runs are then found in the bits, 64 columns at a time.
class LitPixels {
 public:
  /// @param levels levels_of(columns)
  void mark(const std::uint8_t* row, int columns, const std::vector<std::uint8_t>& levels);
  void mark(const std::uint16_t* row, int columns, const std::vector<std::uint16_t>& levels);

  /// First lit column from `from` on, or the number of columns.
  int next_lit(int from) const {
    if (from / kBits < lit_from_) from = lit_from_ * kBits;
    int word = from / kBits;
    if (word >= dark_from_) return columns_;
    std::uint64_t bits = words_[word] & (~std::uint64_t{0} << (from % kBits));
    while (bits == 0) {
      if (++word == dark_from_) return columns_;
      bits = words_[word];
    }
    return word * kBits + __builtin_ctzll(bits);
  }

  /// First dark column after the lit one `from`, or the number of columns.
  int next_dark(int from) const {
    int word = from / kBits;
    std::uint64_t dark = ~words_[word] & (~std::uint64_t{0} << (from % kBits));
    while (dark == 0) {
      if (++word == dark_from_) return std::min(columns_, word * kBits);
      dark = ~words_[word];
    }
    return std::min(columns_, word * kBits + __builtin_ctzll(dark));
  }

 private:
  static constexpr int kBits = kLevelColumns;  // of a word

  template <class Pixel>
  void mark_pixels(const Pixel* row, int columns, const std::vector<Pixel>& levels);

  int columns_ = 0;
  int lit_from_ = 0;   // the words before it are dark
  int dark_from_ = 0;  // and so are those from here
  std::vector<std::uint64_t> words_;
};

}  // namespace tecnogamma_camera
