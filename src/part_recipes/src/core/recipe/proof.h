// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "recipe/recipe.h"

namespace part_recipes {

/// SHA-256 of files, in lower case hexadecimal digits, by name.
using Hashes = std::map<std::string, std::string>;

/// Hashes of the files in a recipe's folder that its runs depend on.
/// @throw scan_cell_common::FileError naming the first that is missing
Hashes hashes_of(const Recipe& recipe);

/// One hash for all of them.
std::string hash_over(const Hashes& files);

/// The files with which a recipe was proven, or made: RECIPE/proof.json.
struct Proof {
  bool proven = false;  //!< by a scan of the reference part; false: only made
  std::string time;     //!< UTC, as 2026-11-25T12:13:14.123Z
  std::string run;      //!< that proved it; empty: none
  Hashes files;         //!< in the recipe's folder
  Hashes calibration;   //!< "scanner" and "cell" of the cell; empty: not known
};

/// @throw scan_cell_common::FileError if there is no proof, or it is broken
Proof load_proof(const Recipe& recipe);

/// Writes the proof, whole or not at all.
/// @throw scan_cell_common::FileError if it cannot be written
void save_proof(const Recipe& recipe, const Proof& proof);

/// Checks that the recipe's files are those with which it was proven.
/// @param now as hashes_of() gives them
/// @throw scan_cell_common::Refused naming the first that differs
void check_unchanged(const Recipe& recipe, const Proof& proof, const Hashes& now);

/// Checks that a cell's calibration is the one with which the recipe was proven.
/// @param calibration of the cell that scanned; a file that is unknown on either side is not
/// compared
/// @return a note for the person: that the recipe was never proven, or a calibration is not known
/// @throw scan_cell_common::Refused naming the file that differs
std::string check_calibration(const Recipe& recipe, const Proof& proof, const Hashes& calibration);

}  // namespace part_recipes
