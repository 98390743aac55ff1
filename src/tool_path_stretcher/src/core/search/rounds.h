// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>

#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// One round of a search: improves each pose, then keeps the better ones.
struct Round {
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  std::optional<Density> density;  //!< samples for point to plane; none: point to point
  std::size_t stride;              //!< point to point uses every stride-th of at most 300 points
  int iterations;                  //!< at most; 0: only rates the pose
  double hopeless;                 //!< a pose is dropped above this multiple of the least bulk cost
  double radius;  //!< of the object's size: of two poses nearer to each other, one is dropped
  std::size_t max_kept;  //!< poses kept, best first; kAll: the radius is ignored
};

// The numbers below were chosen on the 60 cases on which the stretcher was developed. `make bench`
// measures what they find, and how long that takes, on these and other cases.

/// For a scan that shows most of what the reference shows.
struct WholeRounds {
  Round guess, near, retry, rough, fine, last;
};

constexpr WholeRounds whole_rounds(std::size_t max_near, std::size_t max_retried,
                                   std::size_t max_kept) {
  constexpr std::nullopt_t kPoints = std::nullopt;
  return {                                    // samples, stride, iterations, hopeless, radius, kept
          {kPoints, 1, 4, 3, 0.1, max_near},  // every guess
          {kPoints, 1, 10, kNever, 0.05, max_retried},     // the promising ones
          {Density::kFewest, 1, 5, 3, 0.02, max_retried},  // those not refined before
          {Density::kFew, 1, 5, 3, 0, Round::kAll},
          {Density::kFew, 1, 15, kNever, 0.03, max_kept},
          {Density::kSome, 1, 30, kNever, 0.01, max_kept}};
}

constexpr WholeRounds kWholeRounds = whole_rounds(40, 12, 5);

/// For rotations of a pose that already explains the object. All that explain it equally well are
/// kept, and a cube has 24; those only half refined so far are among the many.
constexpr WholeRounds kTurnedRounds = whole_rounds(150, 50, 24);

/// For surfaces either of which may show only a part of the other: there are far more guesses
/// (about 10,000), and each tells less.
constexpr Round kPartialRounds[] = {
    // samples, stride, iterations, hopeless, radius, kept
    {std::nullopt, 12, 0, kNever, 0, 2500},     {std::nullopt, 4, 0, kNever, 0.05, 500},
    {std::nullopt, 4, 4, kNever, 0.05, 100},    {std::nullopt, 1, 10, kNever, 0.05, 60},
    {Density::kFewest, 1, 6, kNever, 0.03, 10},  // rated like the rounds before
    {Density::kFew, 1, 15, kNever, 0.03, 10},    // rated by all samples of both surfaces
};

}  // namespace tool_path_stretcher
