// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scan_cell_common/clouds/cloud_files.h"

namespace cloud_preprocess {

using scan_cell_common::Cloud;

/// Where a reference lies in a scene.
struct FoundReference {
  Cloud laid;                            //!< [m] its points, where they come to lie
  std::vector<std::uint32_t> explained;  //!< points of the scene, in rising order
};

/// What of a scene a reference explains.
struct ReferenceSearch {
  std::vector<FoundReference> found = {};  //!< one: that is the object; several: they look alike
  std::string why_none = {};               //!< empty where there is one
};

/// Finds what a reference explains. A registration is needed for that, which is not this package's
/// job: who has one implements this.
class ReferenceFinder {
 public:
  ReferenceFinder() = default;
  ReferenceFinder(const ReferenceFinder&) = delete;
  ReferenceFinder& operator=(const ReferenceFinder&) = delete;
  virtual ~ReferenceFinder() = default;

  /// Called once, before all else.
  /// @param file cloud or mesh
  /// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
  virtual void load(const std::string& file, double metres_per_unit) = 0;

  /// @param scene [m] finite, without the floor
  /// @param objects points of the scene that belong together, object by object
  /// @throw scan_cell_common::UnusableInput
  virtual ReferenceSearch find(const Cloud& scene,
                               const std::vector<std::vector<std::uint32_t>>& objects) const = 0;
};

}  // namespace cloud_preprocess
