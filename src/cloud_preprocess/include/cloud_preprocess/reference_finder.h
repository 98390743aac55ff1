// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scan_cell_common/clouds/cloud_files.h"

namespace cloud_preprocess {

using scan_cell_common::Cloud;

/// A place of a reference in a scene.
struct FoundReference {
  Cloud laid;                            //!< [m] the reference's points in the found pose
  std::vector<std::uint32_t> explained;  //!< indices of scene points, ascending
};

/// The parts of a scene that a reference explains.
struct ReferenceSearch {
  std::vector<FoundReference> found = {};  //!< one: the object; several: they look alike
  std::string why_none = {};               //!< empty if there is one
};

/// Finds what a reference explains. This needs a registration, which is not this package's job: a
/// package that has one implements this interface.
class ReferenceFinder {
 public:
  ReferenceFinder() = default;
  ReferenceFinder(const ReferenceFinder&) = delete;
  ReferenceFinder& operator=(const ReferenceFinder&) = delete;
  virtual ~ReferenceFinder() = default;

  /// Called once, before find().
  /// @param file cloud or mesh
  /// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
  virtual void load(const std::string& file, double metres_per_unit) = 0;

  /// @param scene [m] finite, without the floor
  /// @param objects indices of the scene points of each object
  /// @throw scan_cell_common::UnusableInput
  virtual ReferenceSearch find(const Cloud& scene,
                               const std::vector<std::vector<std::uint32_t>>& objects) const = 0;
};

}  // namespace cloud_preprocess
