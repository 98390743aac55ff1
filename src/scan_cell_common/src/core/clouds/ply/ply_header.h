// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "files/scalars.h"
#include "scan_cell_common/errors/text.h"

namespace scan_cell_common {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

struct PlyProperty {
  std::string name;
  Scalar type;
  bool is_list = false;
  Scalar count_type = Scalar::kUint8;  // of a list

  std::size_t min_size() const { return size_of(is_list ? count_type : type); }
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
};

/// Reads up to and including the line end_header.
/// @throw FileError
PlyHeader read_ply_header(LineReader& lines, const std::string& source);

}  // namespace scan_cell_common
