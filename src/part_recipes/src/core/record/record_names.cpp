// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "record/record_names.h"

#include <filesystem>

namespace part_recipes {
namespace fs = std::filesystem;
namespace {

/// @param index from 0
std::string name_of(const std::string& wanted, std::size_t index) {
  return index == 0 ? wanted : wanted + "_" + std::to_string(index + 1);
}

}  // namespace

std::vector<std::string> taken_names(const std::string& wanted) {
  std::vector<std::string> taken;
  for (std::string name = wanted; fs::exists(name + ".json") || fs::exists(name + ".log");
       name = name_of(wanted, taken.size()))
    taken.push_back(name);
  return taken;
}

std::string free_name(const std::string& wanted) {
  return name_of(wanted, taken_names(wanted).size());
}

}  // namespace part_recipes
