// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/files/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace fs = std::filesystem;

namespace scan_cell_common {
namespace {

void check_readable(const std::string& path) {
  constexpr std::uintmax_t kLargest = std::uintmax_t{2} << 30;
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (status.type() == fs::file_type::not_found) {
    throw FileError(path, "no such file", "check the path");
  }
  if (failure) throw FileError(path, failure.message(), "check the path and its permissions");
  if (!fs::is_regular_file(status)) {
    throw FileError(path, "a folder, a device or a pipe, not a file", "give a file");
  }
  if (fs::file_size(path, failure) > kLargest) {
    throw FileError(path, "larger than 2 GiB", "split it or make it smaller");
  }
}

bool is_same_file(const std::string& one, const std::string& other) {
  std::error_code failure;
  if (fs::equivalent(one, other, failure)) return true;
  const fs::path place = fs::weakly_canonical(one, failure);  // even if it does not exist yet
  return !failure && place == fs::weakly_canonical(other, failure);
}

}  // namespace

std::string read_file(const std::string& path) {
  check_readable(path);
  errno = 0;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::string bytes(file ? static_cast<std::size_t>(file.tellg()) : 0, '\0');
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file) {
    const std::string why = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    throw FileError(path, "cannot be read" + why, "check its permissions");
  }
  return bytes;
}

std::string extension_of(const std::string& path) {
  return lower_case(fs::path(path).extension().string());
}

void save_whole(const std::string& path, const std::function<bool(const std::string&)>& write) {
  const std::string partial = path + ".partial";
  std::error_code failure;
  std::string reason = "cannot be written";
  try {
    if (write(partial)) {
      fs::rename(partial, path, failure);
      if (!failure) return;
      reason += " (" + failure.message() + ")";
    }
  } catch (...) {
    fs::remove(partial, failure);
    throw;
  }
  fs::remove(partial, failure);
  throw FileError(path, reason, "check the folder and its permissions");
}

void save_text(const std::string& path, const std::string& text) {
  save_whole(path, [&text](const std::string& partial) {
    std::ofstream file(partial, std::ios::binary);
    file << text;
    file.close();
    return !file.fail();
  });
}

void refuse_overwriting(const std::string& written, const std::vector<std::string>& others) {
  for (const std::string& other : others) {
    if (other.empty() || !is_same_file(written, other)) continue;
    throw FileError(written, "given twice", "write to a file of its own");
  }
}

void check_output(const std::string& path, const std::vector<std::string>& extensions,
                  const std::string& cure) {
  const std::string extension = extension_of(path);
  if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) {
    throw FileError(path, "extension '" + extension + "'", cure);
  }
  std::error_code failure;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, failure)) {
    throw FileError(path, "no folder '" + folder.string() + "'", "create it, or check the path");
  }
}

}  // namespace scan_cell_common
