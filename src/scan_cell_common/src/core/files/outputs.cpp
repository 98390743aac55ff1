// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/files/outputs.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace scan_cell_common {
namespace {

namespace fs = std::filesystem;

/// Why the file must not be removed; empty: it may be.
std::string reason_to_keep(const std::string& path) {
  std::error_code failure;
  const fs::file_status status = fs::symlink_status(path, failure);
  if (!fs::exists(status) || fs::is_regular_file(status)) return "";
  return fs::is_symlink(status) ? "is a symbolic link" : "is not a file";
}

/// Splits off the values of an option, `--name value` or `--name=value`.
std::vector<std::string> take_values(const CLI::Option& option, std::vector<std::string>& words) {
  std::vector<std::string> values, rest;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    if (name.size() < 2 || name[0] != '-' || !option.check_name(name)) {
      rest.push_back(word);
      if (equals != std::string::npos) rest.push_back(word.substr(equals + 1));
    } else if (equals != std::string::npos) {
      values.push_back(word.substr(equals + 1));
    } else if (i + 1 < words.size()) {
      values.push_back(words[++i]);
    }
  }
  if (values.empty() && !option.get_default_str().empty())
    values.push_back(option.get_default_str());
  words = std::move(rest);
  return values;
}

}  // namespace

void remove_old(const std::string& path) {
  const std::string reason = reason_to_keep(path);
  if (!reason.empty()) throw FileError(path, reason, "give a file of its own");
  std::error_code failure;
  fs::remove(path, failure);
  if (failure) throw FileError(path, failure.message(), "give a file that you own");
}

CLI::Option* Outputs::add(CLI::App& app, const std::string& name, std::string& path,
                          const std::string& description) {
  CLI::Option* const option = app.add_option(name, path, description)->type_name("OUTPUT");
  outputs_.push_back({&app, option, {}});
  return option;
}

CLI::Option* Outputs::add_folder(CLI::App& app, const std::string& name, std::string& path,
                                 const std::string& description,
                                 const std::vector<std::string>& files) {
  CLI::Option* const option = add(app, name, path, description)->type_name("FOLDER");
  outputs_.back().files = files;
  return option;
}

std::vector<Outputs::Named> Outputs::find(const std::vector<std::string>& words) const {
  std::vector<Named> found;
  for (const Output& output : outputs_) {
    const bool is_called = output.app->get_parent() == nullptr || output.app->parsed();
    if (!is_called) continue;
    std::vector<std::string> others = words;
    for (const std::string& value : take_values(*output.option, others)) {
      if (value.empty()) continue;
      if (output.files.empty()) found.push_back({value, others});
      for (const std::string& file : output.files)
        found.push_back({(fs::path(value) / file).string(), others});
    }
  }
  return found;
}

void Outputs::clear(const std::vector<std::string>& words) const {
  if (clearing_ == Clearing::kByTool) return;
  const std::vector<Named> found = find(words);
  for (const Named& named : found) {
    refuse_overwriting(named.path, named.others);
    const std::string reason = reason_to_keep(named.path);
    if (!reason.empty()) throw FileError(named.path, reason, "give a file of its own");
  }
  for (const Named& named : found)
    remove_old(named.path);
}

void Outputs::clear_where_possible(const std::vector<std::string>& words) const {
  for (const Named& named : find(words)) {
    try {
      refuse_overwriting(named.path, named.others);
      remove_old(named.path);
    } catch (const FileError&) {
      // it is not an old result; the fault in the options is reported in any case
    }
  }
}

}  // namespace scan_cell_common
