// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/clean.h"

#include <algorithm>
#include <set>

#include "scan_cell_common/yaml_file.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::YamlEntry;

/// A reader of one map of a YAML file.
class YamlReader {
 public:
  using Range = RangeCheck::Range;

  explicit YamlReader(const YamlEntry& entry) : entry_(entry) {}

  template <class T, class... Limits>
  void read(const std::string& name, T& value, const Limits&... limits) {
    get(name, value);
    RangeCheck::read(name, value, limits...);
  }

  void read_choice(const std::string& name, std::string& value,
                   const std::vector<std::string>& choices) {
    get(name, value);
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
    std::string allowed;
    for (const std::string& choice : choices)
      allowed += (allowed.empty() ? "" : ", ") + choice;
    throw InvalidParameter(name, "'" + value + "'", "give one of " + allowed);
  }

  void refuse_unknown() const { entry_.refuse_unknown(names_); }

 private:
  template <class T>
  void get(const std::string& name, T& value) {
    names_.insert(name);
    if (entry_.has(name)) value = entry_[name].as<T>();
  }

  YamlEntry entry_;
  std::set<std::string> names_;
};

template <class Parameters>
void read_section(const YamlEntry& root, const std::string& section, Parameters& parameters) {
  if (!root.has(section)) return;
  YamlReader reader(root[section]);
  try {
    describe(reader, parameters);
  } catch (const InvalidParameter& error) {
    throw InvalidParameter(section + "." + error.thing(), error.value(), error.cure());
  }
  reader.refuse_unknown();
}

void run(const Stage& stage, Cloud& cloud, std::vector<StageReport>& reports) {
  cloud = stage.run(std::move(cloud), reports.emplace_back());
}

}  // namespace

CleanParameters read_clean_parameters(const YamlEntry& root) {
  root.refuse_unknown({"floor", "outliers", "isolate", "grid"});
  CleanParameters parameters;
  read_section(root, "floor", parameters.floor);
  read_section(root, "outliers", parameters.outliers);
  read_section(root, "isolate", parameters.isolate);
  if (root.has("grid") && !root["grid"].is_map() && !root["grid"].as<bool>()) {
    parameters.grid.reset();
  } else {
    read_section(root, "grid", *parameters.grid);
  }
  return parameters;
}

CleanParameters load_clean_parameters(const std::string& path) {
  return read_clean_parameters(YamlEntry::load(path));
}

Cloud clean(Cloud cloud, const CleanParameters& parameters, std::vector<StageReport>& reports) {
  const FloorRemoval floor(parameters.floor);
  const OutlierRemoval outliers(parameters.outliers);
  const ObjectIsolation isolation(parameters.isolate);
  const GridReduction grid(parameters.grid.value_or(GridParameters{}));
  run(floor, cloud, reports);
  run(outliers, cloud, reports);
  run(isolation, cloud, reports);
  if (parameters.grid) run(grid, cloud, reports);
  return cloud;
}

}  // namespace cloud_preprocess
