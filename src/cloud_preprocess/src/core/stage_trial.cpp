// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/stage_trial.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {
namespace {

/// A stage and the settings that determine it.
struct Trial {
  std::string name;
  std::string settings;
  std::function<std::unique_ptr<Stage>()> make;
};

std::vector<Trial> trials_of(const CleanParameters& parameters) {
  CleanParameters floor, outliers, isolate;
  floor.floor = parameters.floor;
  outliers.outliers = parameters.outliers;
  isolate.isolate = parameters.isolate;
  return {
      {"floor", stages_yaml(floor), [=] { return std::make_unique<FloorRemoval>(floor.floor); }},
      {"outliers", stages_yaml(outliers),
       [=] { return std::make_unique<OutlierRemoval>(outliers.outliers); }},
      {"isolate", stages_yaml(isolate),
       [=] { return std::make_unique<ObjectIsolation>(isolate.isolate); }}};
}

StageTaking take(const Trial& trial, TracedCloud& cloud) {
  StageTaking taking;
  taking.report.stage = trial.name;
  const std::vector<std::uint32_t> before = cloud.sources();
  try {
    trial.make()->run(cloud, taking.report);
  } catch (const scan_cell_common::Error& error) {
    taking.error = error.what();
    return taking;
  }
  const std::vector<std::uint32_t>& left = cloud.sources();
  std::set_difference(before.begin(), before.end(), left.begin(), left.end(),
                      std::back_inserter(taking.points));
  return taking;
}

}  // namespace

StageTrial::StageTrial(Cloud cloud) : cloud_(std::move(cloud)) {}

std::vector<StageTaking> StageTrial::run(const CleanParameters& parameters) {
  std::vector<StageTaking> takings;
  const std::vector<Trial> trials = trials_of(parameters);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (i >= steps_.size() || steps_[i].settings != trials[i].settings) {
      steps_.resize(i);
      Step step;
      step.settings = trials[i].settings;
      step.left = i == 0 ? cloud_ : steps_.back().left;
      step.taking = take(trials[i], step.left);
      steps_.push_back(std::move(step));
    }
    takings.push_back(steps_[i].taking);
    if (!takings.back().error.empty()) break;
  }
  return takings;
}

}  // namespace cloud_preprocess
