// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "load_finder.h"

#include <pluginlib/class_loader.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/pose/units.h"

namespace cloud_preprocess {
namespace {

using FinderLoader = pluginlib::ClassLoader<ReferenceFinder>;

[[noreturn]] void refuse(const std::string& why) {
  throw scan_cell_common::Refused(
      "isolate/select", "reference",
      "build tool_path_stretcher, which finds the reference, and source its setup.bash (" + why +
          ")");
}

/// The plugin. Its library stays loaded as long as it lives.
std::shared_ptr<ReferenceFinder> plugin() {
  try {
    const auto loader =
        std::make_shared<FinderLoader>("cloud_preprocess", "cloud_preprocess::ReferenceFinder");
    const std::vector<std::string> names = loader->getDeclaredClasses();
    if (names.empty()) refuse("no package has a plugin for it");
    ReferenceFinder* const finder = loader->createUnmanagedInstance(names.front());
    return {finder, [loader](const ReferenceFinder* each) { delete each; }};
  } catch (const pluginlib::PluginlibException& error) {
    refuse(error.what());
  }
}

}  // namespace

std::shared_ptr<const ReferenceFinder> load_finder(const IsolationParameters& parameters) {
  scan_cell_common::check(parameters);
  if (parameters.select != Selection::kReference) return nullptr;
  std::shared_ptr<ReferenceFinder> finder = plugin();
  finder->load(parameters.reference, scan_cell_common::metres_per(parameters.reference_units));
  return finder;
}

}  // namespace cloud_preprocess
