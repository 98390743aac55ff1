// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/node_main.h"

#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/node_process.h"
#include "scan_cell_common/ros/shutdown_request.h"

namespace scan_cell_common {
namespace {

/// tool_main() with the words that are not for ROS.
int plain_main(const std::string& name, CLI::App& options, int argc, char** argv,
               const std::function<int()>& body, int refused, const Outputs& outputs) {
  std::vector<std::string> words;
  ros::removeROSArgs(argc, argv, words);
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  return tool_main(name, options, static_cast<int>(arguments.size()), arguments.data(), body,
                   refused, outputs);
}

/// Without this, a tool would wait for the master for ever, whatever its timeout.
void wait_for_master() {
  constexpr double kPatience = 10;  // [s] it may be starting; chosen like the tools' own timeout
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!listens(ros::master::getHost(), ros::master::getPort())) {
    if (ros::WallTime::now() > end)
      throw ConnectionError("ROS master", ros::master::getURI() + " does not answer",
                            "start the cell (roslaunch), or set ROS_MASTER_URI");
    ros::WallDuration(0.1).sleep();
  }
}

}  // namespace

int node_main(int argc, char** argv, const std::string& name, const std::string& description,
              const std::function<void()>& body, const std::function<void()>& before_threads,
              const std::string& parameters) {
  CLI::App options(description + "\nA node: its parameters come from a launch file or as " +
                   "_NAME:=VALUE; the package's config folder and docs/ list them.");
  bool list = false;
  if (!parameters.empty())
    options.add_flag("--parameters", list, "Print the parameters as a table, as in docs/");
  const auto run = [&] {
    if (list) {
      std::fputs(parameters.c_str(), stdout);
      return 0;
    }
    if (before_threads) before_threads();
    ros::init(argc, argv, name);
    // Destroying the last handle ends the console: without this one, the line below would not be
    // printed.
    const ros::NodeHandle keep_console;
    set_up_process();
    try {
      body();
      return 0;
    } catch (const std::exception& error) {
      ROS_FATAL("%s: %s", name.c_str(), error.what());
      return 1;
    }
  };
  return plain_main(name, options, argc, argv, run, kUnusable, {});
}

int ros_tool_main(const std::string& name, CLI::App& options, int argc, char** argv,
                  const std::function<int()>& body, int refused, const Outputs& outputs) {
  const auto run = [&] {
    ros::init(argc, argv, name, ros::init_options::AnonymousName);
    wait_for_master();
    constexpr int kThreads = 2;
    ros::AsyncSpinner spinner(kThreads);
    spinner.start();
    set_up_process();
    return body();
  };
  return plain_main(name, options, argc, argv, run, refused, outputs);
}

}  // namespace scan_cell_common
