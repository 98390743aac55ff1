// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "clock/utc_time.h"
#include "disk/to_disk.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/sha256.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;

/// Only the letters and digits of a name that any file system takes.
std::string plain(const std::string& name) {
  constexpr std::size_t kLongest = 40;  // [letters] an id stays readable
  std::string result;
  for (const char letter : name) {
    const bool kept = std::isalnum(static_cast<unsigned char>(letter)) != 0 && (letter & 0x80) == 0;
    if (kept) result += letter;
    if (!kept && !result.empty() && result.back() != '_') result += '_';
  }
  return result.substr(0, kLongest);
}

std::string new_id(const std::string& recipe_name) {
  std::random_device entropy;
  constexpr unsigned kMask = 0xffffff;  // 24 bits part the runs of one second
  return fmt::format("{}_{}_{:06x}", utc_stamp(), plain(recipe_name), entropy() & kMask);
}

}  // namespace

RunFolder::RunFolder(const fs::path& runs, const std::string& recipe_name)
    : runs_(fs::absolute(runs)), id_(new_id(recipe_name)), partial_(runs_ / ("." + id_)) {
  try {
    fs::create_directories(runs_);
    if (!fs::create_directory(partial_))
      throw FileError(partial_.string(), "already exists", "run again");
    fs::create_directory(partial_ / "inputs");
    fs::create_directory(partial_ / "stages");
  } catch (const fs::filesystem_error& error) {
    throw_file_error(error);
  }
}

RunFolder::~RunFolder() {
  std::error_code failure;
  if (!sealed_) fs::remove_all(partial_, failure);
}

void RunFolder::add(const fs::path& file, const std::string& name) const {
  try {
    fs::create_directories((partial_ / name).parent_path());
    fs::copy_file(file, partial_ / name);
  } catch (const fs::filesystem_error& error) {
    throw_file_error(error);
  }
}

void RunFolder::write(RunRecord& record) const {
  record.id = id_;
  record.files = files_of(partial_);
  scan_cell_common::save_text((partial_ / kRunFile).string(), to_json(record));
}

fs::path RunFolder::seal() {
  try {
    for (const auto& entry : fs::recursive_directory_iterator(partial_))
      to_disk(entry.path());
    to_disk(partial_);
    const fs::path whole = runs_ / id_;
    fs::rename(partial_, whole);
    sealed_ = true;
    to_disk(runs_);
    return whole;
  } catch (const fs::filesystem_error& error) {
    throw_file_error(error);
  }
}

std::map<std::string, FileEntry> files_of(const fs::path& folder) {
  std::map<std::string, FileEntry> files;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_directory()) continue;
      const std::string name = entry.path().lexically_relative(folder).string();
      if (name == kRunFile || name == kReportPage) continue;
      files[name] = {scan_cell_common::sha256_of_file(entry.path().string()), entry.file_size()};
    }
  } catch (const fs::filesystem_error& error) {
    throw_file_error(error);
  }
  return files;
}

void check_files(const fs::path& folder, const RunRecord& record) {
  const auto now = files_of(folder);
  const std::string cure = "take a copy of the run that nobody changed";
  for (const auto& [name, then] : record.files) {
    const auto found = now.find(name);
    if (found == now.end()) throw UnusableInput((folder / name).string(), "missing", cure);
    if (found->second.sha256 != then.sha256)
      throw UnusableInput((folder / name).string(), "changed since the run", cure);
  }
  for (const auto& [name, file] : now) {
    if (record.files.count(name) == 0)
      throw UnusableInput((folder / name).string(), "not of this run", cure);
  }
}

}  // namespace part_recipes
