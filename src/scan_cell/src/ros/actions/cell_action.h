// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/action_server.h>
#include <ros/node_handle.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "actions/cell_in_use.h"
#include "actions/state_topic.h"
#include "scan_cell_common/errors/errors.h"
#include "sequence/sequence_end.h"

namespace scan_cell {

/// An action that uses the whole cell: one goal at a time, in its own thread. A goal may name a
/// watcher, a node that subscribes to the cell's state, and is cancelled when the watcher is gone.
/// The result has the fields outcome and message, and the outcomes FINISHED, REFUSED and CANCELLED.
template <class Spec>
class CellAction {
 public:
  ACTION_DEFINITION(Spec)

  /// The work of an action.
  class Work {
   public:
    virtual ~Work() = default;
    /// Accepts the goal.
    /// @return the goal's name, for messages to clients refused because of it
    /// @throw scan_cell_common::Error if the goal is refused
    virtual std::string accept(const Goal& goal) = 0;
    virtual Result run(const WhyToCancel& why_to_cancel) = 0;
  };

  /// @param node the private node handle
  /// @param name of the action, also for refusals
  CellAction(ros::NodeHandle node, const std::string& name, CellInUse& cell,
             const StateTopic& state, Work& work)
      : name_(name),
        cell_(cell),
        state_(state),
        work_(work),
        server_(
            node, name, [this](Handle goal) { on_goal(goal); },
            [this](Handle goal) { on_cancel(goal); }, false) {}

  /// Accepts goals from here on.
  void start() { server_.start(); }

  /// Cancels a goal in progress, if any, and waits until the cell is safe.
  void end() {
    bool interrupted = false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      interrupted = running_;
      ending_ = true;
      cancel_ = true;
    }
    if (thread_.joinable()) thread_.join();
    // At shutdown, roscpp drops what it has not sent; the result holds what was captured
    if (interrupted) ros::WallDuration(0.5).sleep();
  }

  /// To be called by the work only.
  void publish(const Feedback& feedback) { goal_.publishFeedback(feedback); }

 private:
  using Server = actionlib::ActionServer<Spec>;
  using Handle = typename Server::GoalHandle;

  void on_goal(Handle goal) {
    state_.wait_for(goal.getGoal()->watcher);
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      take(*goal.getGoal());
    } catch (const std::exception& error) {  // also of a file system: no goal may end the node
      Result refusal;
      refusal.outcome = Result::REFUSED;
      refusal.message = error.what();
      goal.setRejected(refusal, refusal.message);
      return;
    }
    if (thread_.joinable()) thread_.join();
    goal.setAccepted();
    goal_ = goal;
    watcher_ = goal.getGoal()->watcher;
    running_ = true;
    cancel_ = false;
    thread_ = std::thread(&CellAction::run, this);
  }

  void take(const Goal& goal) {
    using scan_cell_common::Refused;
    if (ending_) throw Refused(name_, "the node is ending", "start it again");
    if (!state_.is_watched_by(goal.watcher)) {
      throw Refused("watcher", "'" + goal.watcher + "', which does not listen to the state",
                    "subscribe to " + state_.name() + " first, or give none");
    }
    cell_.take(name_, "a new one");  // first: running work must not see another goal
    try {
      cell_.rename(work_.accept(goal));
    } catch (...) {
      cell_.release();
      throw;
    }
  }

  void on_cancel(Handle goal) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (running_ && goal == goal_) cancel_ = true;
  }

  std::string why_to_cancel() const {
    if (cancel_) return "cancelled by the client";
    if (!state_.is_watched_by(watcher_)) return "cancelled: " + watcher_ + " is gone";
    return "";
  }

  void run() {
    const Result result = work_.run([this] { return why_to_cancel(); });
    const std::lock_guard<std::mutex> lock(mutex_);
    running_ = false;
    cell_.release();
    if (result.outcome == Result::FINISHED) {
      goal_.setSucceeded(result);
    } else if (result.outcome == Result::CANCELLED) {
      goal_.setCanceled(result, result.message);
    } else {
      goal_.setAborted(result, result.message);
    }
  }

  const std::string name_;
  CellInUse& cell_;
  const StateTopic& state_;
  Work& work_;
  std::mutex mutex_;  // guards all that follows
  bool running_ = false;
  bool ending_ = false;  // no more goals are accepted
  Handle goal_;
  std::string watcher_;  // of the goal; only changed while none is in progress
  std::thread thread_;
  std::atomic<bool> cancel_{false};
  Server server_;  // last, since its callbacks use the other members
};

}  // namespace scan_cell
