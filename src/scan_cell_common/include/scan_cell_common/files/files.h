// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace scan_cell_common {

/// The bytes of a file of at most 2 GiB.
/// @throw FileError if it is missing, larger, unreadable, or a folder, device or pipe
std::string read_file(const std::string& path);

/// The extension of a file's name in lower case, with its dot.
std::string extension_of(const std::string& path);

/// Writes a file whole or not at all: `write` writes a temporary file beside it, which is then
/// renamed; on failure nothing is left behind.
/// @param write gets the name to write to and returns whether it succeeded
/// @throw FileError if it cannot be written
void save_whole(const std::string& path, const std::function<bool(const std::string&)>& write);

/// Writes a text file, whole or not at all.
/// @throw FileError if it cannot be written
void save_text(const std::string& path, const std::string& text);

/// Refuses to write over a file that is read, even under another name of the same file.
/// @throw FileError if `written` is one of the others; empty names are ignored
void refuse_overwriting(const std::string& written, const std::vector<std::string>& others);

/// Checks what can be checked of a file to be written before the work that fills it: its extension,
/// and that its folder exists.
/// @param extensions allowed, in lower case, with the dot
/// @param cure names them: "write clouds as .ply or .pcd"
/// @throw FileError
void check_output(const std::string& path, const std::vector<std::string>& extensions,
                  const std::string& cure);

}  // namespace scan_cell_common
