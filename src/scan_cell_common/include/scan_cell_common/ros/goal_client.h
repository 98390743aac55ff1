// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/action_client.h>
#include <fmt/format.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

/// A client of an action that has one goal at a time. Any number of threads may use it, but only
/// one at a time may send. actionlib's SimpleActionClient corrupts memory if another thread
/// receives an answer before its sendGoal() has stored the goal. Here each transition carries its
/// own goal. The node's callbacks must be served by a thread other than the one that waits
/// (ros::AsyncSpinner).
template <class Action>
class GoalClient {
 public:
  ACTION_DEFINITION(Action)

  /// How a goal ended.
  struct End {
    actionlib::TerminalState state;  //!< with the server's text
    ResultConstPtr result;           //!< null if the server has lost the goal
  };

  using OnEnd = std::function<void(const End& end)>;
  using OnFeedback = std::function<void(const Feedback& feedback)>;

  GoalClient(const ros::NodeHandle& node, const std::string& name)
      : name_(name), client_(node, name) {}
  ~GoalClient() { take_handle(nullptr, begin()); }  // while client_ exists

  GoalClient(const GoalClient&) = delete;
  GoalClient& operator=(const GoalClient&) = delete;

  bool is_connected() const { return client_.isServerConnected(); }

  /// @return false if there is no server within `timeout` [s]
  bool wait_for_server(double timeout) const {
    return wait_until([this] { return is_connected(); }, timeout);
  }

  /// Sends a goal. The goal before it is no longer followed: it goes on, but nothing more is
  /// reported about it. Both functions are called by the thread that serves the node's callbacks.
  void send(const Goal& goal, const OnEnd& on_end = {}, const OnFeedback& on_feedback = {}) {
    const std::uint64_t number = begin();
    auto handle = std::make_shared<Handle>(client_.sendGoal(
        goal, [=](Handle news) { on_transition(number, news, on_end); },
        [=](const Handle&, const FeedbackConstPtr& feedback) {
          if (on_feedback && is_followed(number) && !end()) on_feedback(*feedback);
        }));
    take_handle(handle, number);
  }

  /// Cancels the goal sent last; does nothing if none is in progress.
  void cancel() {
    if (const auto handle = this->handle(); handle && !end()) handle->cancel();
  }
  void cancel_all() { client_.cancelAllGoals(); }  //!< of all clients
  /// Cancels the goals of all clients sent up to that time.
  void cancel_until(const ros::Time& time) { client_.cancelGoalsAtAndBeforeTime(time); }

  /// Whether the server has begun the goal or refused it.
  bool is_taken() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return taken_;
  }

  /// @return none while the goal is in progress
  std::optional<End> end() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return end_;
  }

  /// @return none if the goal is still in progress after `timeout` [s]
  std::optional<End> wait_for_end(double timeout) const {
    wait_until([this] { return end().has_value(); }, timeout);
    return end();
  }

  /// A server that ends as the goal arrives loses it, and its replacement never reports on it. Such
  /// a goal is cancelled, in case it still exists.
  /// @throw ConnectionError if the server does not take the goal within `timeout` [s]
  void wait_until_taken(double timeout) {
    if (!wait_until([this] { return is_taken(); }, timeout)) give_up(timeout);
  }

  /// @throw ConnectionError always: the goal was not taken within `timeout` [s]
  [[noreturn]] void give_up(double timeout) {
    cancel();
    throw ConnectionError(name_, fmt::format("did not accept the goal within {:g} s", timeout),
                          "wait until it is idle; see the cell's log");
  }

 private:
  using Handle = typename actionlib::ActionClient<Action>::GoalHandle;

  template <class Condition>
  static bool wait_until(const Condition& condition, double timeout) {
    constexpr double kLook = 0.01;  // [s] between two checks; chosen
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
    while (!condition()) {
      if (ros::WallTime::now() > deadline || !ros::ok()) return condition();
      ros::WallDuration(kLook).sleep();
    }
    return true;
  }

  std::uint64_t begin() {
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_ = false;
    end_.reset();
    return ++number_;
  }

  bool is_followed(std::uint64_t number) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return number == number_;
  }

  std::shared_ptr<Handle> handle() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return handle_;
  }

  /// actionlib calls back with its own mutex locked, and locks it to destroy a handle. So handles
  /// are destroyed while our mutex is free.
  void take_handle(std::shared_ptr<Handle> handle, std::uint64_t number) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (number == number_) handle_.swap(handle);
  }

  void on_transition(std::uint64_t number, const Handle& news, const OnEnd& on_end) {
    using actionlib::CommState;
    const CommState state = news.getCommState();
    const bool taken =
        state == CommState::ACTIVE || state == CommState::PREEMPTING || state == CommState::DONE;
    std::optional<End> end;
    if (state == CommState::DONE) end = End{news.getTerminalState(), news.getResult()};
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (number != number_) return;
      taken_ = taken_ || taken;
      end_ = end;
    }
    if (end && on_end) on_end(*end);
  }

  const std::string name_;
  mutable std::mutex mutex_;
  std::uint64_t number_ = 0;        // of the goal being followed; 0: none yet
  std::shared_ptr<Handle> handle_;  // null: none
  bool taken_ = false;
  std::optional<End> end_;
  mutable actionlib::ActionClient<Action> client_;  // last: its callbacks use the others
};

}  // namespace scan_cell_common
