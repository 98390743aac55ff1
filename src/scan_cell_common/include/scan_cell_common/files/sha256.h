// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell_common {

/// SHA-256 of bytes in lower case hexadecimal digits.
/// @param name of their source, for the error
/// @throw FileError if it cannot be computed
std::string sha256_of(const std::string& bytes, const std::string& name);

/// SHA-256 of a file's bytes. @throw FileError if it cannot be read
std::string sha256_of_file(const std::string& path);

}  // namespace scan_cell_common
