// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/cloud_edits.h"

#include <fmt/format.h>

#include <utility>

#include "edits/shapes.h"
#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {

CloudEdits::CloudEdits(std::vector<CloudEdit> edits) : edits_(std::move(edits)) {}

std::string CloudEdits::apply(TracedCloud& cloud) const {
  std::string said;
  for (std::size_t number = 0; number < edits_.size(); ++number) {
    const CloudEdit& edit = edits_[number];
    const std::vector<bool> in =
        std::visit([&](const auto& shape) { return points_in(cloud.cloud(), shape); }, edit.shape);
    const std::size_t gone = cloud.keep_if([&](std::size_t i) { return in[i] == edit.keep; });
    said += fmt::format("{}{} {}: {} points removed", said.empty() ? "" : ", ",
                        edit.keep ? "keep" : "delete", name_of(edit), gone);
    if (cloud.cloud().empty())
      throw scan_cell_common::UnusableInput(
          fmt::format("edit {} ({} {})", number + 1, edit.keep ? "keep" : "delete", name_of(edit)),
          "leaves nothing", "look at its shape, and at the cloud's frame and unit");
  }
  return said;
}

}  // namespace cloud_preprocess
