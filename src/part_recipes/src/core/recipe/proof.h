// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "recipe/recipe.h"

namespace part_recipes {

/// SHA-256 of files, in lower case hexadecimal digits, by name.
using Hashes = std::map<std::string, std::string>;

/// Of the files in a recipe's folder that its runs depend on.
/// @throw scan_cell_common::FileError naming the first that is missing
Hashes hashes_of(const Recipe& recipe);

/// One hash for all of them.
std::string hash_over(const Hashes& files);

/// What a recipe was proven with, or made with: RECIPE/proof.json.
struct Proof {
  bool proven = false;  //!< by a scan of the reference part; false: only made
  std::string time;     //!< UTC, as 2026-11-25T12:13:14.123Z
  std::string run;      //!< that proved it; empty: none
  Hashes files;         //!< in the recipe's folder
  Hashes calibration;   //!< "scanner" and "cell" of the cell; empty: not known
};

/// @throw scan_cell_common::FileError if there is none, or it is broken
Proof load_proof(const Recipe& recipe);

/// Writes it, whole or not at all.
/// @throw scan_cell_common::FileError if it cannot be written
void save_proof(const Recipe& recipe, const Proof& proof);

/// Whether the recipe's files are those that it was proven with.
/// @param now as hashes_of() gives them
/// @throw scan_cell_common::Refused naming the first that is not
void check_unchanged(const Recipe& recipe, const Proof& proof, const Hashes& now);

/// Whether a cell's calibration is the one that the recipe was proven with.
/// @param calibration of the cell that scanned; what is not known on both sides is not compared
/// @return what the person should know: that it was never proven, that a calibration is not known
/// @throw scan_cell_common::Refused naming the file that is not
std::string check_calibration(const Recipe& recipe, const Proof& proof, const Hashes& calibration);

}  // namespace part_recipes
