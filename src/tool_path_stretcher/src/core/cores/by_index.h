// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace tool_path_stretcher {

/// Calls `work` with ranges of indices [begin, end) that together cover 0 .. count - 1. Runs on all
/// cores that the process may use, in any order and in parallel. Work that writes only what belongs
/// to its indices leaves the same bytes on any number of cores. Work may call this function again:
/// there are never more working threads than cores.
/// @param grain number of indices not worth splitting
/// @throw whatever work throws; ranges not yet begun are skipped
void for_ranges(std::size_t count, std::size_t grain,
                const std::function<void(std::size_t, std::size_t)>& work);

/// The same, index by index.
template <class Work>
void for_indices(std::size_t count, std::size_t grain, const Work& work) {
  for_ranges(count, grain, [&work](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      work(i);
  });
}

/// The results of `work` for each index, in order.
template <class Result, class Work>
std::vector<Result> by_index(std::size_t count, std::size_t grain, const Work& work) {
  std::vector<Result> results(count);
  for_indices(count, grain, [&](std::size_t i) { results[i] = work(i); });
  return results;
}

/// The same without empty results.
/// @tparam Work returns an optional
template <class Result, class Work>
std::vector<Result> all_of(std::size_t count, std::size_t grain, const Work& work) {
  const auto each = by_index<std::optional<Result>>(count, grain, work);
  std::vector<Result> results;
  results.reserve(count);
  for (const std::optional<Result>& one : each) {
    if (one) results.push_back(*one);
  }
  return results;
}

constexpr std::size_t kSingly = 1;      // grain for work of a millisecond or more
constexpr std::size_t kDozens = 16;     // for tens of microseconds
constexpr std::size_t kHundreds = 256;  // for less than one microsecond, such as a tree query

}  // namespace tool_path_stretcher
