// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/edited_cloud.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "edits/shapes.h"
#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {

EditedCloud::EditedCloud(Cloud source) : source_(std::move(source)), taken_(source_.size(), kKept) {
  for (std::size_t i = 0; i < source_.size(); ++i)
    if (!source_[i].getVector3fMap().allFinite()) taken_[i] = kNotFinite;
  count_ = with(kKept).size();
}

EditedCloud::Indices EditedCloud::with(std::int32_t taken) const {
  Indices indices;
  for (std::size_t i = 0; i < taken_.size(); ++i)
    if (taken_[i] == taken) indices.push_back(static_cast<std::uint32_t>(i));
  return indices;
}

EditedCloud::Indices EditedCloud::kept() const {
  return with(kKept);
}

std::vector<std::size_t> EditedCloud::counts() const {
  std::vector<std::size_t> counts(done_.size());
  for (const std::int32_t taken : taken_)
    if (taken >= 0) ++counts[static_cast<std::size_t>(taken)];
  return counts;
}

EditedCloud::Indices EditedCloud::taken_by(std::size_t edit) const {
  return with(static_cast<std::int32_t>(edit));
}

EditedCloud::Indices EditedCloud::would_take(const CloudEdit& edit) const {
  const Indices kept = this->kept();
  Cloud cloud;
  cloud.reserve(kept.size());
  for (const std::uint32_t i : kept)
    cloud.push_back(source_[i]);
  const std::vector<bool> in =
      std::visit([&](const auto& shape) { return points_in(cloud, shape); }, edit.shape);
  Indices taken;
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (in[k] != edit.keep) taken.push_back(kept[k]);
  return taken;
}

std::size_t EditedCloud::take(const CloudEdit& edit) {
  const Indices taken = would_take(edit);
  if (taken.size() == count_)
    throw scan_cell_common::UnusableInput(name_of(edit), "leaves nothing",
                                          "give a shape that leaves a part of the cloud");
  for (const std::uint32_t i : taken)
    taken_[i] = static_cast<std::int32_t>(done_.size());
  count_ -= taken.size();
  done_.push_back(edit);
  return taken.size();
}

std::size_t EditedCloud::add(const CloudEdit& edit) {
  const std::size_t taken = take(edit);
  undone_.clear();
  return taken;
}

bool EditedCloud::undo() {
  if (done_.empty()) return false;
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  for (const std::uint32_t i : taken_by(done_.size())) {
    taken_[i] = kKept;
    ++count_;
  }
  return true;
}

bool EditedCloud::redo() {
  if (undone_.empty()) return false;
  take(undone_.back());
  undone_.pop_back();
  return true;
}

}  // namespace cloud_preprocess
