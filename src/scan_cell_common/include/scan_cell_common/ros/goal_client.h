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

/// A client of an action that has one goal at a time, for any number of threads, of which one at a
/// time sends.
/// actionlib's SimpleActionClient does not bear an answer that another thread receives before its
/// sendGoal() has put down which goal it is: that corrupts memory. Here each piece of news carries
/// its own goal.
/// The node's callbacks must be served by another thread than the one that waits
/// (ros::AsyncSpinner).
template <class Action>
class GoalClient {
 public:
  ACTION_DEFINITION(Action)

  /// How a goal ended.
  struct End {
    actionlib::TerminalState state;  //!< with the server's text
    ResultConstPtr result;           //!< null where the server has lost the goal
  };

  using OnEnd = std::function<void(const End& end)>;
  using OnFeedback = std::function<void(const Feedback& feedback)>;

  GoalClient(const ros::NodeHandle& node, const std::string& name)
      : name_(name), client_(node, name) {}
  ~GoalClient() { take_handle(nullptr, begin()); }  // while client_ is there

  GoalClient(const GoalClient&) = delete;
  GoalClient& operator=(const GoalClient&) = delete;

  bool is_connected() const { return client_.isServerConnected(); }

  /// @return false if there is no server within `timeout` [s]
  bool wait_for_server(double timeout) const {
    return wait_until([this] { return is_connected(); }, timeout);
  }

  /// The goal before is no longer followed: nothing is told of it from here on, and it goes on.
  /// Both functions are called by the thread that serves the node's callbacks.
  void send(const Goal& goal, const OnEnd& on_end = {}, const OnFeedback& on_feedback = {}) {
    const std::uint64_t number = begin();
    auto handle = std::make_shared<Handle>(client_.sendGoal(
        goal, [=](Handle news) { on_transition(number, news, on_end); },
        [=](const Handle&, const FeedbackConstPtr& feedback) {
          if (on_feedback && is_followed(number) && !end()) on_feedback(*feedback);
        }));
    take_handle(handle, number);
  }

  /// The goal that was sent last; does nothing where there is none under way.
  void cancel() {
    if (const auto handle = this->handle(); handle && !end()) handle->cancel();
  }
  void cancel_all() { client_.cancelAllGoals(); }  //!< of all clients
  /// Those of all clients that were sent until then.
  void cancel_until(const ros::Time& time) { client_.cancelGoalsAtAndBeforeTime(time); }

  /// Whether the server has begun with the goal, or refused it.
  bool is_taken() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return taken_;
  }

  /// @return none while it is under way
  std::optional<End> end() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return end_;
  }

  /// @return none if it is still under way after `timeout` [s]
  std::optional<End> wait_for_end(double timeout) const {
    wait_until([this] { return end().has_value(); }, timeout);
    return end();
  }

  /// A server that ends as the goal comes loses it, and the one that is started in its place never
  /// says a word of it: such a goal is cancelled, in case it is still there.
  /// @throw ConnectionError if the server does not take the goal within `timeout` [s]
  void wait_until_taken(double timeout) {
    if (!wait_until([this] { return is_taken(); }, timeout)) give_up(timeout);
  }

  /// @throw ConnectionError always: the goal was not taken within `timeout` [s]
  [[noreturn]] void give_up(double timeout) {
    cancel();
    throw ConnectionError(name_, fmt::format("did not take the goal within {:g} s", timeout),
                          "wait until it has nothing else to do; look at the cell's log");
  }

 private:
  using Handle = typename actionlib::ActionClient<Action>::GoalHandle;

  template <class Condition>
  static bool wait_until(const Condition& condition, double timeout) {
    constexpr double kLook = 0.01;  // [s] between two looks; chosen
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

  /// actionlib calls with its own mutex locked, and locks that where a handle goes: handles go
  /// while ours is free.
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
  std::uint64_t number_ = 0;        // of the goal that is followed; 0: none yet
  std::shared_ptr<Handle> handle_;  // null: none
  bool taken_ = false;
  std::optional<End> end_;
  mutable actionlib::ActionClient<Action> client_;  // last: its callbacks use all the rest
};

}  // namespace scan_cell_common
