// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "tool_check/judge/judge.h"

namespace c4g_driver {
namespace {

struct Span {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

Span span_of(const Track& track, int joint) {
  Span span;
  for (const TrackPlace& place : track.places) {
    if (!place.reached) continue;
    span.least = std::min(span.least, place.joints[joint]);
    span.most = std::max(span.most, place.joints[joint]);
  }
  return span;
}

/// How far outside the range [rad] with this number of full turns added.
double excess(const Span& span, double turns, double lower, double upper) {
  const double shift = 2 * M_PI * turns;
  return std::max({0.0, lower - span.least - shift, span.most + shift - upper});
}

/// The number of full turns that fits best; the smallest if several do.
double best_turns(const Span& span, double lower, double upper) {
  const double most = std::ceil((upper - lower) / (2 * M_PI)) + 1;
  double best = 0;
  for (double turns = 1; turns <= most; ++turns) {
    for (const double signed_turns : {turns, -turns}) {
      if (excess(span, signed_turns, lower, upper) < excess(span, best, lower, upper))
        best = signed_turns;
    }
  }
  return best;
}

}  // namespace

void choose_turns(Track& track, const ToolCheckSubject& subject) {
  for (int joint = 0; joint < 6; ++joint) {
    const double lower = subject.limits.joint_lower[joint] + subject.parameters.joint_margin;
    const double upper = subject.limits.joint_upper[joint] - subject.parameters.joint_margin;
    const Span span = span_of(track, joint);
    if (!(span.least <= span.most) || excess(span, 0, lower, upper) <= 0) continue;
    const double shift = 2 * M_PI * best_turns(span, lower, upper);
    for (TrackPlace& place : track.places)
      place.joints[joint] += shift;
  }
}

}  // namespace c4g_driver
