// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace tool_path_stretcher {

/// Calls `work` with ranges of indices, from begin to before end, that together are all below
/// `count`: on all cores that the process may use, in any order, some at once. Work that writes
/// only what belongs to its indices leaves the same bytes on any number of cores. It may call this
/// again: there are never more threads at work than cores.
/// @param grain indices that are not worth splitting
/// @throw whatever work throws; ranges not begun by then are left out
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

/// What `work` makes of each index, in their order.
template <class Result, class Work>
std::vector<Result> by_index(std::size_t count, std::size_t grain, const Work& work) {
  std::vector<Result> results(count);
  for_indices(count, grain, [&](std::size_t i) { results[i] = work(i); });
  return results;
}

/// The same without the empty ones.
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

constexpr std::size_t kSingly = 1;      // grain of what takes a millisecond or more
constexpr std::size_t kDozens = 16;     // of what takes tens of microseconds
constexpr std::size_t kHundreds = 256;  // of what takes less than one: a query of a tree

}  // namespace tool_path_stretcher
