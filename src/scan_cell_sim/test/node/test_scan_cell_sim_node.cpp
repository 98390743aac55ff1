// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <arv.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <scan_cell_msgs/LoadWorld.h>
#include <scan_cell_msgs/SetFaults.h>
#include <sys/socket.h>
#include <unistd.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <set>

#include "camera/loopback.h"
#include "node/set_faults.h"

namespace {

constexpr double kPatience = 30;  // [s]
const std::string kConfig = ros::package::getPath("scan_cell_sim") + "/config/";

template <class Message>
boost::shared_ptr<const Message> wait_for(const std::string& topic) {
  ros::NodeHandle node;
  return ros::topic::waitForMessage<Message>(topic, node, ros::Duration(kPatience));
}

bool wait_until(const std::function<bool()>& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (ros::WallTime::now() < end) {
    if (condition()) return true;
    ros::WallDuration(0.02).sleep();
  }
  return false;
}

scan_cell_msgs::LoadWorld::Response load_world(const std::string& path) {
  scan_cell_msgs::LoadWorld::Request request;
  scan_cell_msgs::LoadWorld::Response response;
  request.path = path;
  EXPECT_TRUE(ros::service::waitForService("/scan_cell_sim/load_world", 1000 * kPatience));
  EXPECT_TRUE(ros::service::call("/scan_cell_sim/load_world", request, response));
  return response;
}

/// Writes the trigger circuit's data register.
void write_circuit(std::uint8_t data) {
  const int handle = socket_to(5420);
  EXPECT_EQ(send(handle, &data, 1, 0), 1);
  close(handle);
}

/// Whether the camera can be opened, under this serial number.
bool camera_answers(const std::string& serial) {
  GError* error = nullptr;
  ArvCamera* const camera = arv_camera_new("127.0.0.1", &error);
  g_clear_error(&error);
  if (camera == nullptr) return false;
  const std::string found = arv_camera_get_device_serial_number(camera, nullptr);
  g_object_unref(camera);
  return found == serial;
}

/// A triggered client; counts rows whose brightest pixel stands out.
class Client {
 public:
  Client() : camera_(arv_camera_new("127.0.0.1", nullptr)) {
    arv_camera_set_trigger(camera_, "Line0", nullptr);
    constexpr int kPacketSize = 9000;
    arv_camera_gv_set_packet_size(camera_, kPacketSize, nullptr);
    stream_ = arv_camera_create_stream(camera_, nullptr, nullptr, nullptr);
    for (int i = 0; i < 10; ++i) {
      arv_stream_push_buffer(stream_,
                             arv_buffer_new_allocate(arv_camera_get_payload(camera_, nullptr)));
    }
    arv_camera_start_acquisition(camera_, nullptr);
  }
  ~Client() {
    arv_camera_stop_acquisition(camera_, nullptr);
    g_object_unref(stream_);
    g_object_unref(camera_);
  }

  /// Lit rows of the next frame; -1 if there is none.
  int lit_rows() {
    constexpr guint64 kWait = 100000;  // [us]
    ArvBuffer* const buffer = arv_stream_timeout_pop_buffer(stream_, kWait);
    if (buffer == nullptr) return -1;
    int rows = -1;
    if (arv_buffer_get_status(buffer) == ARV_BUFFER_STATUS_SUCCESS) rows = count(buffer);
    time_ = arv_buffer_get_timestamp(buffer);
    arv_stream_push_buffer(stream_, buffer);
    return rows;
  }

  std::uint64_t time() const { return time_; }  ///< [ns] of the last frame, by the camera

  /// Lit rows after a pulse with these laser bits.
  int pulse(std::uint8_t lasers) {
    int rows = -1;
    wait_until([&] {
      write_circuit(lasers | 1);
      write_circuit(lasers);
      rows = lit_rows();
      return rows >= 0;
    });
    write_circuit(0);
    return rows;
  }

 private:
  static int count(ArvBuffer* buffer) {
    std::size_t size = 0;
    const auto* const pixels = static_cast<const std::uint8_t*>(arv_buffer_get_data(buffer, &size));
    const int width = arv_buffer_get_image_width(buffer);
    int rows = 0;
    for (int row = 0; row < arv_buffer_get_image_height(buffer); ++row) {
      constexpr int kBright = 40;
      rows += *std::max_element(pixels + row * width, pixels + (row + 1) * width) > kBright;
    }
    return rows;
  }

  ArvCamera* camera_;
  ArvStream* stream_ = nullptr;
  std::uint64_t time_ = 0;
};

TEST(SimulatorNode, ServesACameraThatShowsTheLaserThatIsOn) {
  ASSERT_TRUE(set_faults().success);
  ASSERT_TRUE(camera_answers("ROSTEST"));
  Client client;
  EXPECT_GT(client.pulse(0b010), 400);
  EXPECT_EQ(client.pulse(0b000), 0);
  EXPECT_GT(client.pulse(0b100), 400);
}

TEST(SimulatorNode, SaysWhichPulsesTheCameraCouldNotTake) {
  ASSERT_TRUE(set_faults().success);
  std::string said;
  ros::NodeHandle node;
  const boost::function<void(const rosgraph_msgs::Log&)> listen =
      [&said](const rosgraph_msgs::Log& line) {
        if (line.name == "/scan_cell_sim") said += line.msg + "\n";
      };
  const auto subscriber = node.subscribe<rosgraph_msgs::Log>("/rosout", 100, listen);
  ASSERT_TRUE(wait_until([&] { return subscriber.getNumPublishers() > 0; }));
  Client client;
  ASSERT_GT(client.pulse(0b010), 400);
  ros::spinOnce();
  EXPECT_EQ(said.find("pulses lost"), std::string::npos) << said;
  EXPECT_TRUE(wait_until([&] {
    for (int i = 0; i < 4; ++i)
      write_circuit(i % 2);  // two pulses within camera/min_period
    ros::spinOnce();
    return said.find("pulses lost; less than 0.002 s after") != std::string::npos;
  })) << said;
  EXPECT_EQ(said.find("camera/max_pending"), std::string::npos) << said;
}

TEST(SimulatorNode, UnplugsTheCameraAndPlugsItInAgain) {
  scan_cell_msgs::SetFaults::Request faults;
  faults.camera_off = true;
  ASSERT_TRUE(set_faults(faults).success);
  EXPECT_FALSE(camera_answers("ROSTEST"));
  ASSERT_TRUE(set_faults().success);
  EXPECT_TRUE(camera_answers("ROSTEST"));
}

TEST(SimulatorNode, LosesTheTriggerCircuitAndFindsItAgain) {
  ASSERT_TRUE(set_faults().success);
  Client client;
  EXPECT_GT(client.pulse(0b010), 400);
  scan_cell_msgs::SetFaults::Request faults;
  faults.trigger_circuit_lost = true;
  ASSERT_TRUE(set_faults(faults).success);
  write_circuit(0b011);
  EXPECT_EQ(client.lit_rows(), -1);
  ASSERT_TRUE(set_faults().success);
  EXPECT_GT(client.pulse(0b010), 400);
}

TEST(SimulatorNode, RefusesFaultsThatMakeNoSense) {
  scan_cell_msgs::SetFaults::Request faults;
  faults.camera_lost_frames = 1.5;
  const auto response = set_faults(faults);
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("camera_lost_frames"), std::string::npos);
}

TEST(SimulatorNode, LoadsAnotherWorldAndShowsItsParts) {
  const auto names = [] {
    std::set<std::string> found;
    const auto markers = wait_for<visualization_msgs::MarkerArray>("/scan_cell_sim/parts");
    if (!markers) return found;
    for (const visualization_msgs::Marker& marker : markers->markers) {
      if (!marker.points.empty()) found.insert(marker.ns);
    }
    return found;
  };
  EXPECT_EQ(names(), (std::set<std::string>{"frame"}));
  ASSERT_TRUE(load_world(kConfig + "two_boxes.yaml").success);
  EXPECT_TRUE(wait_until([&] {
    return names() == std::set<std::string>{"large_box", "small_box"};
  }));
  const auto refused = load_world("/nowhere.yaml");
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("/nowhere.yaml"), std::string::npos);
  EXPECT_TRUE(load_world(kConfig + "reference_frame.yaml").success);
}

TEST(SimulatorNode, RefusesToStartWithABadParameterAndNamesIt) {
  for (const std::string name :
       {"camera/wire_rate", "trigger/port", "optics/shot_noise", "controller/stream_period",
        "controller/mode", "controller/to_client/lost", "controller/from_client/delay",
        "true_flange_rate", "misspelt"}) {
    const std::string command =
        "rosrun scan_cell_sim scan_cell_sim_node __name:=bad_simulator _" + name + ":=-5 2>&1";
    FILE* const pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::string output;
    char buffer[256];
    while (fgets(buffer, sizeof buffer, pipe))
      output += buffer;
    EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 1) << output;
    EXPECT_NE(output.find("/bad_simulator/" + name), std::string::npos) << output;
    ros::param::del("/bad_simulator");
  }
}

TEST(SimulatorNode, TellsTheTrueFlange) {
  const auto flange = wait_for<geometry_msgs::PoseStamped>("/scan_cell_sim/true_flange");
  ASSERT_TRUE(flange);
  EXPECT_EQ(flange->header.frame_id, "base_link");
  EXPECT_NEAR(flange->pose.position.x, 0.80, 1e-3);  // the controller's start posture
  EXPECT_NEAR(flange->pose.position.z, 0.60, 1e-3);
}

TEST(SimulatorNode, TellsTheTruePoseOfEachFrame) {
  ASSERT_TRUE(set_faults().success);
  std::map<std::uint64_t, geometry_msgs::PoseStamped> exposures;
  ros::NodeHandle node;
  const boost::function<void(const geometry_msgs::PoseStamped&)> keep =
      [&exposures](const geometry_msgs::PoseStamped& exposure) {
        exposures[exposure.header.stamp.toNSec()] = exposure;
      };
  const auto subscriber =
      node.subscribe<geometry_msgs::PoseStamped>("/scan_cell_sim/true_exposures", 100, keep);
  ASSERT_TRUE(wait_until([&] { return subscriber.getNumPublishers() > 0; }));
  Client client;
  ASSERT_GT(client.pulse(0b010), 400);
  ASSERT_TRUE(wait_until([&] {
    ros::spinOnce();
    return exposures.count(client.time()) > 0;
  }));
  EXPECT_EQ(exposures[client.time()].header.frame_id, "base_link");
  EXPECT_NEAR(exposures[client.time()].pose.position.x, 0.80, 1e-3);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_scan_cell_sim_node");
  ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
