// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/single_subscriber_publisher.h>

#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace scan_cell_common {

/// The nodes connected to one of our topics. The kernel closes the connections of a node that ends,
/// however it ends: milliseconds later it is no longer a listener.
class Listeners {
 public:
  /// Called for a node whose last connection has ended, when contains() already says so.
  using OnGone = std::function<void(const std::string& node)>;

  explicit Listeners(OnGone on_gone = nullptr);

  /// As ros::NodeHandle::advertise(). The publisher must not outlive this object.
  template <class Message>
  ros::Publisher advertise(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue,
                           bool latch = false) {
    using Peer = ros::SingleSubscriberPublisher;
    return node.advertise<Message>(
        topic, queue, [this](const Peer& peer) { come(peer.getSubscriberName()); },
        [this](const Peer& peer) { go(peer.getSubscriberName()); }, ros::VoidConstPtr(), latch);
  }

  bool contains(const std::string& node) const;

 private:
  void come(const std::string& node);
  void go(const std::string& node);
  int count(const std::string& node, int change);

  const OnGone on_gone_;
  mutable std::mutex mutex_;
  // connections; below zero if an end is reported first: callbacks may overtake one another
  std::map<std::string, int> nodes_;
};

}  // namespace scan_cell_common
