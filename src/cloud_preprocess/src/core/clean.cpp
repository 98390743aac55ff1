// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/clean.h"

#include <optional>
#include <utility>

#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

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
