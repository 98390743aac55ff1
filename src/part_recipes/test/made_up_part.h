// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

#include "temporary_folder.h"

namespace part_recipes {

/// A plate of 120 x 80 mm with a step and two bosses, without symmetry, as points 1 mm apart; and a
/// path along its step.
struct MadeUpPart {
  /// Writes a cloud [m] of the part, moved, with `added` along z on its left third.
  static void write_cloud(const std::filesystem::path& file, const Eigen::Isometry3d& moved,
                          double added = 0);

  /// Writes positions and orientations of the path on the part before its motion.
  static void write_path(const std::filesystem::path& file);

  /// A motion of 30 degrees about z, 40 and -25 mm.
  static Eigen::Isometry3d moved();
};

/// The bytes of a small text file.
std::string text_of(const std::filesystem::path& file);

}  // namespace part_recipes
