// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <algorithm>

namespace scan_cell_rviz {

/// How long the window's thread did not come to its next event, at the longest.
class HoldUps {
 public:
  HoldUps() {
    beat_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&beat_, &QTimer::timeout, &beat_, [this] { tick(); });
    beat_.start(kBeat);
    since_.start();
  }

  void reset() {
    longest_ = 0;
    since_.restart();
  }

  double longest() const { return longest_; }  ///< [ms] since the last reset()

 private:
  static constexpr int kBeat = 2;  // [ms]
  static constexpr double kNanoseconds = 1e6;

  void tick() {
    const double gap = static_cast<double>(since_.nsecsElapsed()) / kNanoseconds - kBeat;
    longest_ = std::max(longest_, gap);
    since_.restart();
  }

  QTimer beat_;
  QElapsedTimer since_;
  double longest_ = 0;
};

/// Serves the window until it is so, without a pause of its own.
/// @param patience [ms]
/// @return whether it came
template <class Condition>
bool serve_until(const Condition& condition, qint64 patience) {
  QElapsedTimer waited;
  waited.start();
  while (!condition()) {
    if (waited.elapsed() > patience) return false;
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return true;
}

}  // namespace scan_cell_rviz
