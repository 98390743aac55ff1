// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "cloud_preprocess/reference_finder.h"
#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Lets cloud_preprocess find a reference's part in a scan with the stretcher's registration.
class PartsFinder final : public cloud_preprocess::ReferenceFinder {
 public:
  void load(const std::string& file, double metres_per_unit) override;

  cloud_preprocess::ReferenceSearch find(
      const cloud_preprocess::Cloud& scene,
      const std::vector<std::vector<std::uint32_t>>& objects) const override;

 private:
  StretchParameters parameters_;  // defaults
  std::optional<Surface> reference_;
};

}  // namespace tool_path_stretcher
