// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pass_planner {

/// Files of the simulated cell.
struct CellFiles {
  std::string scanner;  //!< scanner model
  std::string cell;     //!< where the robot stands
  std::string urdf;     //!< of the robot
};

/// A part that was scanned along one line, and then along the one proposed pass.
struct CureTrial {
  std::string part;            //!< of which kind
  bool not_scanned = false;    //!< the first scan was refused with path_not_scanned
  std::size_t waypoints = 0;   //!< of the path
  std::size_t missing = 0;     //!< waypoints that the refusal names
  std::string first_verdict;   //!< in words
  std::string pass;            //!< that was proposed; empty: none
  std::size_t passes = 0;      //!< that a plan without limit has
  std::string why;             //!< there was none
  bool cured = false;          //!< both scans together were accepted
  std::string second_verdict;  //!< in words
};

/// Scans a drawn part along a drawn line, cleans the cloud, adapts the path; if that is refused
/// with path_not_scanned, plans one pass, scans along it and adapts the path to both clouds.
CureTrial run_cure(const CellFiles& files, std::uint64_t seed);

}  // namespace pass_planner
