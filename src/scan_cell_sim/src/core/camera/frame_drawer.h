// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "camera/stream_packets.h"
#include "scan_cell_sim/gige_camera.h"

namespace scan_cell_sim {

/// Draws a frame in a thread of its own while the one before it is on the wire. Its methods are to
/// be called from one thread.
class FrameDrawer {
 public:
  /// @param drawn called in the drawer's thread whenever a frame can be taken
  FrameDrawer(GigeCamera::Render render, std::function<void()> drawn);
  ~FrameDrawer();

  FrameDrawer(const FrameDrawer&) = delete;
  FrameDrawer& operator=(const FrameDrawer&) = delete;

  /// Neither draws a frame nor holds one.
  bool idle() const;

  /// Begins to draw; only when idle.
  /// @param frame complete but for the values of its pixels
  void begin(const GigeCamera::Shot& shot, gige::Frame frame);

  /// The frame, once it is drawn.
  std::optional<gige::Frame> take();

  /// Drops the frame that is being drawn or held.
  /// @return whether there was one
  bool drop();

 private:
  enum class State { kIdle, kDrawing, kDrawn, kEnding };

  void run();

  const GigeCamera::Render render_;
  const std::function<void()> drawn_;
  mutable std::mutex mutex_;  // of state_, and of the next two unless drawing
  std::condition_variable changed_;
  State state_ = State::kIdle;
  GigeCamera::Shot shot_;
  gige::Frame frame_;
  std::thread thread_;
};

}  // namespace scan_cell_sim
