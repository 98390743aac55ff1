// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/frame_drawer.h"

#include <utility>

namespace scan_cell_sim {

FrameDrawer::FrameDrawer(GigeCamera::Render render, std::function<void()> drawn)
    : render_(std::move(render)), drawn_(std::move(drawn)), thread_(&FrameDrawer::run, this) {}

FrameDrawer::~FrameDrawer() {
  drop();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    state_ = State::kEnding;
  }
  changed_.notify_all();
  thread_.join();
}

bool FrameDrawer::idle() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_ == State::kIdle;
}

void FrameDrawer::begin(const GigeCamera::Shot& shot, gige::Frame frame) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shot_ = shot;
    frame_ = std::move(frame);
    state_ = State::kDrawing;
  }
  changed_.notify_all();
}

std::optional<gige::Frame> FrameDrawer::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ != State::kDrawn) return std::nullopt;
  state_ = State::kIdle;
  return std::move(frame_);
}

bool FrameDrawer::drop() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return state_ != State::kDrawing; });
  return std::exchange(state_, State::kIdle) == State::kDrawn;
}

void FrameDrawer::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return state_ == State::kDrawing || state_ == State::kEnding; });
    if (state_ == State::kEnding) return;
    lock.unlock();
    render_(shot_, frame_.region, frame_.pixels.data());
    lock.lock();
    state_ = State::kDrawn;
    changed_.notify_all();
    drawn_();
  }
}

}  // namespace scan_cell_sim
