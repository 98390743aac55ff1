// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "frames/frame_log.h"

namespace pose_frame_binder {
namespace {

bool is_decided(FrameState state) {
  return state == FrameState::kBound || state == FrameState::kDropped;
}

}  // namespace

std::size_t FrameLog::add(const Frame& frame) {
  const std::size_t number = end();
  FrameRecord& record = records_.emplace_back();
  record.number = number;
  record.frame = frame;
  ++counts_[static_cast<std::size_t>(FrameState::kArrived)];
  return number;
}

std::size_t FrameLog::undecided() const {
  return records_.size() - count(FrameState::kBound) - count(FrameState::kDropped);
}

void FrameLog::set(FrameRecord& frame, FrameState state) {
  --counts_[static_cast<std::size_t>(frame.state)];
  ++counts_[static_cast<std::size_t>(state)];
  frame.state = state;
}

void FrameLog::drop(FrameRecord& frame, DropReason reason, const std::string& detail) {
  set(frame, FrameState::kDropped);
  frame.reason = reason;
  on_drop_(frame, detail);
}

FrameRecord* FrameLog::first_undecided() {
  for (; !records_.empty() && is_decided(records_.front().state); ++first_) {
    --counts_[static_cast<std::size_t>(records_.front().state)];
    records_.pop_front();
  }
  return records_.empty() ? nullptr : &records_.front();
}

}  // namespace pose_frame_binder
