// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "cloud_preprocess/cloud_edits.h"

namespace cloud_preprocess {

/// A cloud that a person edits step by step, with unlimited undo and redo. The cloud itself never
/// changes. The active edits leave exactly the points that CloudEdits would leave. Not thread-safe.
class EditedCloud {
 public:
  using Indices = std::vector<std::uint32_t>;  //!< of points of the source, ascending

  EditedCloud() = default;
  /// @param source [m]; points that are not finite are ignored
  explicit EditedCloud(Cloud source);

  const Cloud& source() const { return source_; }                   //!< [m] as it came
  const std::vector<CloudEdit>& edits() const { return done_; }     //!< active edits, in order
  const std::vector<CloudEdit>& undone() const { return undone_; }  //!< next to redo is last
  Indices kept() const;                                             //!< by the active edits
  std::size_t count() const { return count_; }                      //!< of points kept
  std::vector<std::size_t> counts() const;  //!< of points that each active edit removed
  /// Points that the edit with this number, from 0, removed.
  Indices taken_by(std::size_t edit) const;
  /// Points among those kept that an edit would remove.
  Indices would_take(const CloudEdit& edit) const;

  /// Adds an edit. Undone edits are lost.
  /// @return number of points removed
  /// @throw scan_cell_common::UnusableInput if it would leave nothing; then nothing changes
  std::size_t add(const CloudEdit& edit);

  bool undo();  //!< @return false if there is none
  bool redo();  //!< @return false if there is none

 private:
  static constexpr std::int32_t kKept = -1, kNotFinite = -2;

  Indices with(std::int32_t taken) const;
  std::size_t take(const CloudEdit& edit);

  Cloud source_;
  std::vector<std::int32_t> taken_;  // number of the edit that removed each point
  std::size_t count_ = 0;
  std::vector<CloudEdit> done_;
  std::vector<CloudEdit> undone_;
};

}  // namespace cloud_preprocess
