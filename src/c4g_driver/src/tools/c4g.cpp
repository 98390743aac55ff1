// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The robot from the command line, over UDP: no ROS master is needed.
#include <ros/package.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "c4g_commands.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/interrupts.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using c4g_driver::Client;
using c4g_driver::ClientOptions;
using c4g_driver::WireSix;

using scan_cell_common::kDegree;
using scan_cell_common::kMillimetre;

struct Options {
  ClientOptions client;
  double patience = 3;  //!< [s] for the connection
  std::string urdf;     //!< file; empty: that of this package
  std::string base_link = "base_link";
  std::string flange_link = "flange";
  std::string operation = "manual";
};

/// The arguments of the commands.
struct Words {
  WireSix via{};
  WireSix target{};
  double camera_rate = 0;  //!< [Hz]
  std::string drives;
  bool reset = false;
  std::string name;
  std::string value;
};

struct Command {
  CLI::App* app;
  std::function<void(Client&)> carry_out;
};

/// An option of N numbers in a person's unit.
template <int N>
void add_vector(CLI::App& app, const std::string& name, Eigen::Matrix<double, N, 1>& vector,
                double unit, const std::string& description) {
  app.add_option_function<std::vector<double>>(
         name,
         [&vector, unit](const std::vector<double>& typed) {
           vector = unit * Eigen::Map<const Eigen::Matrix<double, N, 1>>(typed.data());
         },
         description)
      ->expected(N)
      ->group("Limits, as the parameters of the driver");
}

void add_connection(CLI::App& app, Options& options) {
  app.add_option("--address", options.client.address, "IPv4 address of the controller")->required();
  app.add_option("--port", options.client.port, "its UDP port")->capture_default_str();
  app.add_option("--local-address", options.client.local_address,
                 "IPv4 address of this machine's network card that leads to it")
      ->capture_default_str();
  app.add_option("--timeout", options.patience, "[s] to wait for the connection")
      ->capture_default_str();
}

void add_limits(CLI::App& app, Options& options) {
  const std::string group = "Limits, as the parameters of the driver";
  c4g_driver::RobotLimits& limits = options.client.limits;
  app.add_option("--urdf", options.urdf, "model of the robot; without: the Comau Smart5 SiX")
      ->group(group);
  app.add_option("--base-link", options.base_link, "link of the URDF that poses are given in")
      ->capture_default_str()
      ->group(group);
  app.add_option("--flange-link", options.flange_link, "link of the URDF that is moved")
      ->capture_default_str()
      ->group(group);
  app.add_option("--operation", options.operation,
                 "manual: people may be near, 250 mm/s at most; automatic: the cell is fenced")
      ->check(CLI::IsMember({"manual", "automatic"}))
      ->capture_default_str()
      ->group(group);
  scan_cell_common::refuse_renamed(app, {{"--most-linear-speed", "--max-linear-speed"}});
  app.add_option_function<double>(
         "--max-linear-speed",
         [&limits](const double& typed) { limits.max_linear_speed = typed * kMillimetre; },
         "[mm/s] along lines in automatic operation [1500]")
      ->group(group);
  add_vector(app, "--workspace-min", limits.workspace_min, kMillimetre,
             "[mm] box that the flange stays in [-1400 -1400 150]");
  add_vector(app, "--workspace-max", limits.workspace_max, kMillimetre, "[mm] [1400 1400 1900]");
  add_vector(app, "--joint-lower", limits.joint_lower, kDegree, "[deg] narrower than the URDF's");
  add_vector(app, "--joint-upper", limits.joint_upper, kDegree, "[deg]");
}

std::vector<Command> add_motions(CLI::App& app, Words& words) {
  CLI::App* const move =
      app.add_subcommand("move", "Moves the robot and waits for the end; Ctrl-C stops it");
  move->require_subcommand(1)->fallthrough();
  CLI::App* const cartesian =
      move->add_subcommand("cartesian", "To a pose of the flange, along a line");
  cartesian->add_option("pose", words.target, "x y z [mm] A E R [deg]")->required();
  CLI::App* const circular =
      move->add_subcommand("circular", "To a pose of the flange, along the circle through another");
  circular->add_option("via", words.via, "x y z [mm] A E R [deg] on the way")->required();
  circular->add_option("pose", words.target, "x y z [mm] A E R [deg] at the end")->required();
  CLI::App* const joint = move->add_subcommand("joint", "All axes together");
  joint->add_option("joints", words.target, "J1 .. J6 [deg]")->required();
  move->add_option("--camera-rate", words.camera_rate,
                   "[Hz] that the controller keeps during the motion")
      ->capture_default_str();
  CLI::App* const stop =
      app.add_subcommand("stop", "Stops the robot, and waits until it stands still");
  return {{cartesian,
           [&words](Client& client) { move_to_pose(client, words.target, words.camera_rate); }},
          {circular,
           [&words](Client& client) {
             move_along_arc(client, words.via, words.target, words.camera_rate);
           }},
          {joint,
           [&words](Client& client) { move_to_joints(client, words.target, words.camera_rate); }},
          {stop, c4g_driver::stop}};
}

std::vector<Command> add_questions(CLI::App& app, Words& words) {
  CLI::App* const status =
      app.add_subcommand("status", "Shows where the robot is, and its condition");
  CLI::App* const drives = app.add_subcommand("drives", "Switches the drives on or off");
  drives->add_option("state", words.drives, "on or off")
      ->required()
      ->check(CLI::IsMember({"on", "off"}));
  CLI::App* const alarms = app.add_subcommand("alarms", "Lists the pending alarms");
  alarms->add_flag("--reset", words.reset, "resets them first");
  CLI::App* const read = app.add_subcommand("read", "Shows a parameter of the controller");
  CLI::App* const write =
      app.add_subcommand("write", "Sets a parameter of the controller, and shows it");
  for (CLI::App* command : {read, write})
    command->add_option("name", words.name, "such as motion_type; c4g_protocol.md lists them")
        ->required();
  write
      ->add_option("value", words.value, "a number, a word or JSON: 250, joint, [0, 0, 0, 0, 0, 0]")
      ->required();
  return {{status, c4g_driver::show_state},
          {drives,
           [&words](Client& client) {
             client.set_drives(words.drives == "on");
             std::printf("drives %s\n", words.drives.c_str());
           }},
          {alarms,
           [&words](Client& client) {
             if (words.reset) client.reset_alarms();
             show_alarms(client);
           }},
          {read, [&words](Client& client) { show_parameter(client, words.name); }},
          {write, [&words](Client& client) { write_parameter(client, words.name, words.value); }}};
}

ClientOptions client_options(const Options& options) {
  const std::string file = options.urdf.empty()
                               ? ros::package::getPath("c4g_driver") + "/urdf/smart5_six.urdf"
                               : options.urdf;
  ClientOptions client = options.client;
  client.robot = std::make_shared<c4g_driver::RobotModel>(scan_cell_common::read_file(file),
                                                          options.base_link, options.flange_link);
  client.limits.operation = options.operation == "automatic" ? c4g_driver::Operation::kAutomatic
                                                             : c4g_driver::Operation::kManual;
  return client;
}

}  // namespace

/// Exits with 0 if done, 2 if robot, limits or a signal refused or ended it, 1 otherwise.
int main(int argc, char** argv) {
  Options options;
  Words words;
  CLI::App app(
      "Speaks C4G with a robot controller (c4g_protocol.md). It is the controller's only "
      "client: the driver must not run.");
  app.require_subcommand(1);
  add_connection(app, options);
  add_limits(app, options);
  std::vector<Command> commands = add_motions(app, words);
  for (const Command& command : add_questions(app, words))
    commands.push_back(command);
  for (const Command& command : commands)
    command.app->fallthrough();
  return scan_cell_common::tool_main(
      "c4g", app, argc, argv,
      [&] {
        const scan_cell_common::CatchInterrupts catch_interrupts;
        Client client(client_options(options), nullptr);
        wait_for_link(client, options.patience);
        for (const Command& command : commands) {
          if (command.app->parsed()) command.carry_out(client);
        }
        return 0;
      },
      scan_cell_common::kRefused);
}
