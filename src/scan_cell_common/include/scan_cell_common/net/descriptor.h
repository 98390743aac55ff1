// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <utility>

namespace scan_cell_common {

/// Owns a file descriptor and closes it.
class Descriptor {
 public:
  /// @param number of an open descriptor, or -1: none
  explicit Descriptor(int number = -1) : number_(number) {}
  /// Takes over the other's descriptor.
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  /// Takes over the other's descriptor.
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  int number() const { return number_; }  //!< -1: none

 private:
  int number_;
};

}  // namespace scan_cell_common
