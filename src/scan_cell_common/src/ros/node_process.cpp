// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/node_process.h"

#include <fmt/format.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpc.h>

#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <utility>

namespace scan_cell_common {
namespace {

/// Host and port of a node, from the master.
std::optional<std::pair<std::string, std::uint32_t>> address_of(const std::string& node) {
  XmlRpc::XmlRpcValue request, response, uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, uri, false)) return std::nullopt;
  std::pair<std::string, std::uint32_t> address;
  if (!ros::network::splitURI(uri, address.first, address.second)) return std::nullopt;
  return address;
}

}  // namespace

bool listens(const std::string& host, std::uint32_t port) {
  constexpr std::chrono::seconds kPatience(1);  // chosen: an answer takes milliseconds
  boost::asio::ip::tcp::iostream there;
  there.expires_after(kPatience);
  there.connect(host, fmt::format("{}", port));
  return static_cast<bool>(there);
}

std::optional<bool> is_published(const std::string& topic) {
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) return std::nullopt;
  XmlRpc::XmlRpcValue& topics = state[0];  // each with the nodes that publish it
  for (int i = 0; i < topics.size(); ++i) {
    if (static_cast<std::string>(topics[i][0]) != topic) continue;
    XmlRpc::XmlRpcValue& nodes = topics[i][1];
    for (int k = 0; k < nodes.size(); ++k) {
      const auto address = address_of(nodes[k]);
      if (address && listens(address->first, address->second)) return true;
    }
  }
  return false;
}

std::optional<pid_t> process_of(const std::string& node) {
  const auto address = address_of(node);
  if (!address) return std::nullopt;
  const auto& [host, port] = *address;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue name, answer;
  name[0] = ros::this_node::getName();
  constexpr int kProcess = 2;  // of [code, message, process]
  if (!client.execute("getPid", name, answer) || client.isFault() || answer.size() <= kProcess)
    return std::nullopt;
  return static_cast<int>(answer[kProcess]);
}

}  // namespace scan_cell_common
