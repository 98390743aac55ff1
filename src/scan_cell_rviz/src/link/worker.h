// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace scan_cell_rviz {

/// Runs tasks one after another, outside the window's thread.
class Worker {
 public:
  Worker();
  /// Waits for the running task; waiting tasks are dropped.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void add(std::function<void()> task);

  /// @param failed receives what the task throws, in the worker's thread
  void add(std::function<void()> task, std::function<void(QString message)> failed);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace scan_cell_rviz
