// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/case_list.h"

#include <array>

#include "scanner_views/families.h"

namespace scanner_views {
namespace {

/// Seeds for independent draws (Steele et al. 2014, SplitMix64).
std::uint64_t scrambled(std::uint64_t seed, std::uint64_t what) {
  std::uint64_t bits = seed * 0x9E3779B97F4A7C15ULL + what;
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBULL;
  return bits ^ (bits >> 31U);
}

/// Numbers the cases of one list. Each has its own draws.
class List {
 public:
  explicit List(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t next_seed() { return scrambled(seed_, ++count_); }

  template <class Family>
  void add(Family family, const std::vector<ViewPart>& parts) {
    for (const ViewPart& part : parts)
      cases.push_back(family(part, next_seed()));
  }

  std::vector<ViewCase> cases;

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

/// Adds the cases that must not be accepted.
void add_refusals(const std::vector<ViewPart>& parts, std::uint64_t seed, List& list) {
  Draws draws(scrambled(seed, 0));
  const std::vector<ViewPart> variant = {bracket_variant(draws)};
  list.add(symmetric_case, symmetric_parts(draws));
  list.add(mirrored_case, {parts[0], parts[6], parts[7], parts[10]});
  list.add(upside_down_case, {parts[0], parts[2], parts[11]});
  list.cases.push_back(wrong_case(parts[0], variant.front(), list.next_seed()));
  for (const std::size_t other : {1, 4, 8, 13})
    list.cases.push_back(wrong_case(parts[other], parts[other + 1], list.next_seed()));
}

}  // namespace

std::vector<ViewCase> all_cases(std::uint64_t seed, const std::string& data) {
  Draws draws(scrambled(seed, 0));
  std::vector<ViewPart> parts = plate_parts(draws);
  for (const auto& more : {profile_parts(draws), curved_parts(draws)})
    parts.insert(parts.end(), more.begin(), more.end());
  List list(seed);
  for (const auto family :
       {moved_case, bent_case, scaled_case, warped_case, dented_case, scene_case})
    list.add(family, parts);
  add_refusals(parts, seed, list);
  for (const ViewPart& sheet : sanded_sheets(draws)) {
    for (const auto family : {own_path_case, bent_own_path_case})
      list.add(family, {sheet});
  }
  for (const ViewPart& part : real_parts(data)) {
    const bool own_path = !part.path.segments.empty();
    for (const auto family : own_path ? std::array{own_path_case, bent_own_path_case, moved_case}
                                      : std::array{moved_case, bent_case, scene_case})
      list.add(family, {part});
  }
  return list.cases;
}

}  // namespace scanner_views
