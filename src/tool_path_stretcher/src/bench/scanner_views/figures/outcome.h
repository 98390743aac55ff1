// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scanner_views/methods/methods.h"

namespace scanner_views {

/// How good an answer is.
enum class Worth {
  kRight,  //!< accepted, and the path is right
  kWrong,  //!< accepted, but a waypoint is wrong, or the object should be refused
  kRefusedNeedlessly,
  kRefusedRightly,
};

std::string to_string(Worth worth);

/// Error above which a waypoint of an accepted path is wrong.
constexpr double kWrongNormal = 0.001;          // [m]
constexpr double kWrongPosition = 0.005;        // [m]
constexpr double kWrongAngle = 5 * M_PI / 180;  // [rad]

/// How many waypoints of a path have errors within three times the expected ones.
struct Expectations {
  std::size_t waypoints = 0;  //!< with expected errors
  std::size_t normal = 0;
  std::size_t along = 0;
  std::size_t with_angle = 0;   //!< with an expected error of orientation
  std::size_t angle = 0;        //!< of these
  std::size_t truly_along = 0;  //!< less than 0.5 mm off along the surface
  std::size_t known_along = 0;  //!< of these: with less than 2 mm expected
  double largest_along = 0;     //!< [m] expected error along the surface

  Expectations& operator+=(const Expectations& other);
};

/// Errors of one path, in the true frame of each waypoint.
struct Errors {
  double normal = 0;          //!< [m] RMS
  double tangential = 0;      //!< [m] RMS
  double angle = 0;           //!< [rad] RMS
  double position = 0;        //!< [m] RMS
  double worst_normal = 0;    //!< [m]
  double worst_position = 0;  //!< [m]
  double worst_angle = 0;     //!< [rad]
  std::size_t waypoints = 0;
  Expectations expectations;

  bool wrong() const {
    return worst_normal > kWrongNormal || worst_position > kWrongPosition ||
           worst_angle > kWrongAngle;
  }
};

Errors errors_of(const Answer& answer, const ToolPath& truth);

/// An answer compared with the truth.
struct Outcome {
  Answer answer;  //!< without its path
  Worth worth = Worth::kRefusedNeedlessly;
  Errors errors;  //!< of an accepted path
};

Outcome outcome_of(Answer answer, const ViewCase& each, const View& view);

}  // namespace scanner_views
