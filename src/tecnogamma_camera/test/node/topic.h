// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <mutex>
#include <string>
#include <vector>

/// All that arrived on one topic.
template <class Message>
class Topic {
 public:
  explicit Topic(const std::string& name)
      : subscriber_(ros::NodeHandle().subscribe(name, 10000, &Topic::take, this)) {}
  void forget() {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.clear();
  }
  std::vector<Message> messages() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }
  std::size_t count() { return messages().size(); }
  bool has_publisher() { return subscriber_.getNumPublishers() > 0; }

 private:
  void take(const typename Message::ConstPtr& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.push_back(*message);
  }
  std::mutex mutex_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
};
