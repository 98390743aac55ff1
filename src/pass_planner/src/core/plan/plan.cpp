// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "plan/clearance.h"
#include "plan/joined.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace pass_planner {
namespace {

using scan_cell::PassLasers;
using scan_cell::ScanPass;

constexpr int kMaxLines = 5;  // of one pass; chosen
constexpr const char* kNotSeen = "no candidate sees it";
constexpr const char* kMore = "more passes are needed: raise max_passes";

/// A pass with its lasers, and what it sees.
struct Choice {
  ScanPass pass;
  std::vector<std::size_t> seen;  // indices of the places
  double quality = 0;             // sum of the cosines of the worse angle
};

bool is_better(const Choice& a, const Choice& b) {
  return a.seen.size() != b.seen.size() ? a.seen.size() > b.seen.size() : a.quality > b.quality;
}

/// Chooses one pass after another.
class Planner {
 public:
  Planner(const scan_cell_common::ScannerModel& scanner, const Surface& surface,
          const std::vector<Surface::Place>& places, const SightParameters& sight,
          const Reach& reach, const PlanParameters& parameters, const std::vector<ScanPass>& first,
          bool lines_alone)
      : scanner_(scanner),
        places_(places),
        sight_(sight),
        reach_(reach),
        parameters_(parameters),
        check_(scanner, surface, sight),
        clearance_(scanner, surface, reach, parameters),
        first_(first),
        lines_alone_(lines_alone),
        why_(places.size()) {}

  PassPlan run() {
    PassPlan plan;
    plan.left.resize(places_.size());
    std::iota(plan.left.begin(), plan.left.end(), 0);
    while (!plan.left.empty()) {
      const auto choice = best_for(plan.left, plan.passes);
      if (!choice || plan.passes.size() == static_cast<std::size_t>(parameters_.max_passes)) break;
      plan.passes.push_back(choice->pass);
      std::vector<std::size_t> left;
      std::set_difference(plan.left.begin(), plan.left.end(), choice->seen.begin(),
                          choice->seen.end(), std::back_inserter(left));
      plan.left = left;
    }
    for (const std::size_t place : plan.left)
      plan.why.push_back(why_[place]);
    return plan;
  }

  /// Why the last of these passes cannot be run: the cell does not allow it, the robot cannot move
  /// so, or something comes too near; empty: it can.
  std::string hindrance_of(const std::vector<ScanPass>& passes) const {
    try {
      check({"", passes}, scan_cell::ScanLimits());
    } catch (const scan_cell_common::Refused& error) {
      return error.what();
    }
    const std::string near = clearance_.refusal(passes);
    return near.empty() ? reach_.refusal(passes) : near;
  }

 private:
  /// The best choices of lasers for a candidate.
  std::vector<Choice> choices_of(ScanPass pass, const std::vector<std::size_t>& left,
                                 const std::vector<Surface::Place>& places) const {
    pass.lasers = PassLasers::kAlternate;
    std::vector<Choice> choices;
    std::vector<std::vector<Sighting>> of_laser;
    for (const Sweep& sweep : sweeps_of({pass})) {
      if (!scanner_.has_laser(sweep.laser)) continue;
      of_laser.push_back(check_.along(sweep, places));
      pass.lasers = static_cast<PassLasers>(sweep.laser);
      choices.push_back(choice_of(pass, left, of_laser.back()));
    }
    if (of_laser.size() < 2) return choices;
    std::vector<Sighting> both = of_laser.front();
    for (std::size_t i = 0; i < both.size(); ++i) {
      if (pass_planner::is_better(of_laser.back()[i], both[i])) both[i] = of_laser.back()[i];
    }
    pass.lasers = PassLasers::kAlternate;
    pass.rate = 2 * parameters_.rate;
    choices.push_back(choice_of(pass, left, both));
    // Both in turns only if that shows more.
    const std::size_t most = std::max(choices[0].seen.size(), choices[1].seen.size());
    if (choices.back().seen.size() <= most) choices.pop_back();
    return choices;
  }

  static Choice choice_of(const ScanPass& pass, const std::vector<std::size_t>& left,
                          const std::vector<Sighting>& sightings) {
    Choice choice = {pass, {}, 0};
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (sightings[i].sight != Sight::kSeen) continue;
      choice.seen.push_back(left[i]);
      choice.quality += std::cos(std::max(sightings[i].light_angle, sightings[i].sight_angle));
    }
    return choice;
  }

  /// The best pass that can be run after those before; none if no pass sees any of the places.
  std::optional<Choice> best_for(const std::vector<std::size_t>& left,
                                 const std::vector<ScanPass>& before) {
    std::vector<Surface::Place> places;
    for (const std::size_t place : left)
      places.push_back(places_[place]);
    std::vector<Choice> choices;
    for (const ScanPass& pass : candidate_passes(places, scanner_, sight_, parameters_)) {
      if (lines_alone_ && pass.kind != scan_cell::PassKind::kLine) continue;
      for (Choice& choice : choices_of(pass, left, places)) {
        if (!choice.seen.empty()) choices.push_back(std::move(choice));
      }
    }
    for (const std::size_t place : left)
      why_[place] = kNotSeen;
    for (const Choice& choice : choices) {
      for (const std::size_t place : choice.seen)
        why_[place] = kMore;
    }
    std::stable_sort(choices.begin(), choices.end(), is_better);
    std::vector<ScanPass> passes = first_;
    passes.insert(passes.end(), before.begin(), before.end());
    passes.emplace_back();
    for (const Choice& choice : choices) {
      passes.back() = choice.pass;
      const std::string hindrance = hindrance_of(passes);
      if (hindrance.empty()) return choice;
      for (const std::size_t place : choice.seen) {
        if (why_[place] == kMore)
          why_[place] = "seen only by passes that cannot be run: " + hindrance;
      }
    }
    return std::nullopt;
  }

  const scan_cell_common::ScannerModel& scanner_;
  const std::vector<Surface::Place>& places_;
  const SightParameters sight_;
  const Reach& reach_;
  const PlanParameters parameters_;
  const SightCheck check_;
  const Clearance clearance_;
  const std::vector<ScanPass> first_;
  const bool lines_alone_;
  std::vector<std::string> why_;  // why a place is not seen
};

/// Narrower limits: light gets weaker with distance, and the part may not lie exactly as assumed.
SightParameters on_the_safe_side(SightParameters sight) {
  constexpr double kMargin = 0.1;  // [rad] chosen
  constexpr double kLeast = 0.1;   // [rad] of the parameters' range
  sight.max_light_angle = std::max(kLeast, sight.max_light_angle - kMargin);
  sight.max_sight_angle = std::max(kLeast, sight.max_sight_angle - kMargin);
  return sight;
}

SightParameters at_good_angles(SightParameters sight, const PlanParameters& parameters) {
  sight.max_light_angle = std::min(sight.max_light_angle, parameters.good_angle);
  sight.max_sight_angle = std::min(sight.max_sight_angle, parameters.good_angle);
  return sight;
}

/// Candidates have as many lanes as the places are wide: for a part in another unit, planning would
/// never end.
void check_size(const std::vector<Surface::Place>& places) {
  const double largest = 5 * scan_cell::ScanLimits().max_length;  // [m] factor chosen
  Eigen::AlignedBox3d box;
  for (const Surface::Place& place : places)
    box.extend(place.point);
  if (places.empty() || box.diagonal().norm() <= largest) return;
  throw scan_cell_common::UnusableInput(
      "path", fmt::format("its waypoints are {:g} m apart", box.diagonal().norm()),
      fmt::format("check the units of part and path: passes are planned for up to {:g} m",
                  largest));
}

}  // namespace

PassPlan plan_passes(const scan_cell_common::ScannerModel& scanner, const Surface& surface,
                     const std::vector<Surface::Place>& places, const SightParameters& sight,
                     const Reach& reach, const PlanParameters& parameters,
                     const std::vector<ScanPass>& first) {
  scan_cell_common::check(parameters);
  check_size(places);
  PassPlan best;
  const SightParameters safe = on_the_safe_side(sight);
  for (const SightParameters& limits : {at_good_angles(safe, parameters), safe}) {
    const PassPlan plan =
        Planner(scanner, surface, places, limits, reach, parameters, first, false).run();
    if (plan.left.empty()) return plan;
    if (best.passes.empty() || plan.left.size() < best.left.size()) best = plan;
    if (parameters.max_passes > 1) continue;
    // Only lines that one pass can go through.
    PlanParameters some = parameters;
    some.max_passes = kMaxLines;
    Planner planner(scanner, surface, places, limits, reach, some, first, true);
    const PassPlan lines = planner.run();
    if (!lines.left.empty()) continue;
    std::vector<ScanPass> passes = first;
    passes.push_back(joined(lines.passes, parameters.rate));
    if (planner.hindrance_of(passes).empty()) return {{passes.back()}, {}, {}};
  }
  return best;
}

}  // namespace pass_planner
