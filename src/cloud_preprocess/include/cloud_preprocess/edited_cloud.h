// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "cloud_preprocess/cloud_edits.h"

namespace cloud_preprocess {

/// A cloud that a person edits step by step, with undo and redo without end. The cloud itself never
/// changes: what the edits in force leave of it is what CloudEdits leaves, point by point. Not safe
/// for use from several threads.
class EditedCloud {
 public:
  using Indices = std::vector<std::uint32_t>;  //!< of points of the source, ascending

  EditedCloud() = default;
  /// @param source [m]; points that are not finite are no part of it
  explicit EditedCloud(Cloud source);

  const Cloud& source() const { return source_; }                   //!< [m] as it came
  const std::vector<CloudEdit>& edits() const { return done_; }     //!< in force, in their order
  const std::vector<CloudEdit>& undone() const { return undone_; }  //!< the next one to redo last
  Indices kept() const;                                             //!< by the edits in force
  std::size_t count() const { return count_; }                      //!< of points kept
  std::vector<std::size_t> counts() const;  //!< of points that each edit in force took
  /// What the edit with this number, from 0, took.
  Indices taken_by(std::size_t edit) const;
  /// What an edit would take of what is kept.
  Indices would_take(const CloudEdit& edit) const;

  /// What was undone before is gone for good.
  /// @return how many points it took
  /// @throw scan_cell_common::UnusableInput if it would leave nothing; then nothing has changed
  std::size_t add(const CloudEdit& edit);

  bool undo();  //!< @return false if there is none
  bool redo();  //!< @return false if there is none

 private:
  static constexpr std::int32_t kKept = -1, kNotFinite = -2;

  Indices with(std::int32_t taken) const;
  std::size_t take(const CloudEdit& edit);

  Cloud source_;
  std::vector<std::int32_t> taken_;  // number of the edit that took each point
  std::size_t count_ = 0;
  std::vector<CloudEdit> done_;
  std::vector<CloudEdit> undone_;
};

}  // namespace cloud_preprocess
