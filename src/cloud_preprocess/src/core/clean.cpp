// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/clean.h"

#include <optional>
#include <set>
#include <utility>

#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::ParameterValue;
using scan_cell_common::YamlEntry;

/// Reads one section of a YAML file.
class YamlSection final : public scan_cell_common::ParameterTable {
 public:
  YamlSection(const YamlEntry& root, const std::string& section)
      : entry_(root[section]), section_(section) {}

  void refuse_unknown() const { entry_.refuse_unknown(names_); }

 private:
  void visit(const scan_cell_common::Parameter& parameter, ParameterValue& value) override {
    names_.insert(parameter.name);
    if (!entry_.has(parameter.name)) return;
    std::visit([entry = entry_[parameter.name]](
                   auto& as) { as = entry.template as<std::decay_t<decltype(as)>>(); },
               value);
  }
  bool is_given(const std::string& old, const std::string&) override { return entry_.has(old); }
  std::string named(const std::string& name) const override { return section_ + "." + name; }

  YamlEntry entry_;
  std::string section_;
  std::set<std::string> names_;
};

template <class Parameters>
void read_section(const YamlEntry& root, const std::string& section, Parameters& parameters) {
  if (!root.has(section)) return;
  YamlSection table(root, section);
  describe(table, parameters);
  table.refuse_unknown();
}

class Chain {
 public:
  explicit Chain(const CleanParameters& parameters)
      : floor_(parameters.floor), outliers_(parameters.outliers), isolation_(parameters.isolate) {
    if (!parameters.edits.empty()) edits_.emplace(parameters.edits);
    if (parameters.grid) grid_.emplace(*parameters.grid);
  }

  void before_isolation(TracedCloud& cloud, std::vector<StageReport>& reports) const {
    if (edits_) edits_->run(cloud, reports.emplace_back());
    floor_.run(cloud, reports.emplace_back());
    outliers_.run(cloud, reports.emplace_back());
  }

  void isolate(TracedCloud& cloud, std::vector<StageReport>& reports) const {
    isolation_.run(cloud, reports.emplace_back());
  }

  std::vector<TracedCloud> objects(TracedCloud cloud, const TracedCloud& kept) const {
    return isolation_.objects(std::move(cloud), kept);
  }

  void reduce(TracedCloud& cloud, std::vector<StageReport>& reports) const {
    if (grid_) grid_->run(cloud, reports.emplace_back());
  }

 private:
  std::optional<CloudEdits> edits_;
  FloorRemoval floor_;
  OutlierRemoval outliers_;
  ObjectIsolation isolation_;
  std::optional<GridReduction> grid_;
};

}  // namespace

void describe(scan_cell_common::ParameterTable& table, CleanParameters& parameters) {
  table.group("floor", parameters.floor);
  table.group("outliers", parameters.outliers);
  table.group("isolate", parameters.isolate);
  if (parameters.grid) table.group("grid", *parameters.grid);
}

CleanParameters read_clean_parameters(const YamlEntry& root) {
  root.refuse_unknown({"edits", "floor", "outliers", "isolate", "grid"});
  CleanParameters parameters;
  if (root.has("edits")) parameters.edits = read_edits(root["edits"]);
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
  TracedCloud traced(std::move(cloud));
  clean(traced, parameters, reports);
  return traced.cloud();
}

void clean(TracedCloud& cloud, const CleanParameters& parameters,
           std::vector<StageReport>& reports) {
  const Chain chain(parameters);
  chain.before_isolation(cloud, reports);
  chain.isolate(cloud, reports);
  chain.reduce(cloud, reports);
}

void clean(TracedCloud& cloud, const CleanParameters& parameters, std::vector<StageReport>& reports,
           std::vector<TracedCloud>& objects) {
  const Chain chain(parameters);
  chain.before_isolation(cloud, reports);
  TracedCloud scene = cloud;
  chain.isolate(cloud, reports);
  objects = chain.objects(std::move(scene), cloud);
  chain.reduce(cloud, reports);
  std::vector<StageReport> of_objects;
  for (TracedCloud& object : objects)
    chain.reduce(object, of_objects);
}

}  // namespace cloud_preprocess
