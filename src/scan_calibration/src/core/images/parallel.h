// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace scan_calibration {

/// Calls `work` with 0 .. count - 1, in any order, on several threads. After each it calls `done`,
/// if given, with the number finished, from one thread at a time. The first error ends it and is
/// thrown.
inline void for_each_index(int count, int threads, const std::function<void(int)>& work,
                           const std::function<void(int)>& done = {}) {
  std::atomic<int> next{0};
  std::mutex mutex;
  int finished = 0;
  std::exception_ptr failure;
  const auto run = [&] {
    for (int index = next++; index < count; index = next++) {
      try {
        work(index);
        const std::lock_guard<std::mutex> lock(mutex);
        ++finished;
        if (done) done(finished);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < std::min(threads, count); ++i)
    others.emplace_back(run);
  run();
  for (std::thread& thread : others)
    thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace scan_calibration
