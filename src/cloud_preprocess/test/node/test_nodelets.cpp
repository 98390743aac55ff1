// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_common/errors/errors.h>
#include <scan_cell_common/ros/cloud_messages.h>
#include <scan_cell_msgs/ObjectClouds.h>
#include <scan_cell_msgs/PreprocessReport.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <std_srvs/Trigger.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

#include "scene.h"

using cloud_preprocess::Cloud;
using cloud_preprocess::Label;
using cloud_preprocess::Scene;
using scan_cell_msgs::PreprocessReport;
using sensor_msgs::PointCloud2;

namespace {

const char* const kStages[] = {"floor", "outliers", "isolate", "grid"};
const char* const kNodelets[] = {"floor",   "outliers",  "isolate", "grid",
                                 "ceiling", "elsewhere", "whole"};

/// The chain of nodelets.test, with everything that it published.
class Chain : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string stage : kNodelets) {
      const boost::function<void(const PointCloud2ConstPtr&)> on_cloud =
          [this, stage](const PointCloud2ConstPtr& cloud) { clouds_[stage].push_back(cloud); };
      const boost::function<void(const PreprocessReport::ConstPtr&)> on_report =
          [this, stage](const PreprocessReport::ConstPtr& report) {
            reports_[stage].push_back(report);
          };
      subscribers_.push_back(node_.subscribe<PointCloud2>(stage + "/output", 10, on_cloud));
      subscribers_.push_back(node_.subscribe<PreprocessReport>(stage + "/report", 10, on_report));
    }
    scan_ = node_.advertise<PointCloud2>("scan", 1, true);
    ++second_;
  }

  using PointCloud2ConstPtr = sensor_msgs::PointCloud2ConstPtr;

  void send(PointCloud2 message, const std::string& frame = "world") {
    message.header.frame_id = frame;
    message.header.stamp = ros::Time(second_, 5);
    scan_.publish(message);
  }

  void send(const Cloud& cloud) { send(scan_cell_common::to_message(cloud, {})); }

  template <class MessagePtr>
  MessagePtr of_this_test(const std::vector<MessagePtr>& messages) const {
    for (const MessagePtr& message : messages) {
      if (message->header.stamp.sec == second_) return message;
    }
    return {};
  }

  /// The stage's report on this test's cloud.
  PreprocessReport::ConstPtr report(const std::string& stage) {
    return wait_for([&] { return of_this_test(reports_[stage]); });
  }

  PointCloud2ConstPtr output(const std::string& stage) {
    return wait_for([&] { return of_this_test(clouds_[stage]); });
  }

  void forget(const std::string& stage) { clouds_[stage].clear(); }

  bool has_output(const std::string& stage) { return of_this_test(clouds_[stage]) != nullptr; }

 private:
  template <class Condition>
  auto wait_for(const Condition& condition) -> decltype(condition()) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(60);
    while (!condition() && ros::WallTime::now() < end) {
      ros::spinOnce();
      ros::WallDuration(0.01).sleep();
    }
    return condition();
  }

  static std::uint32_t second_;
  ros::NodeHandle node_;
  ros::Publisher scan_;
  std::vector<ros::Subscriber> subscribers_;
  std::map<std::string, std::vector<PointCloud2ConstPtr>> clouds_;
  std::map<std::string, std::vector<PreprocessReport::ConstPtr>> reports_;
};

std::uint32_t Chain::second_ = 1000;

}  // namespace

TEST_F(Chain, LeavesOneReducedObjectAndPassesTheHeaderOn) {
  const Scene::Rectangle box{0, 0, 0.06, 0.08};
  Scene scene;
  scene.add_floor({0, 0, 0.20, 0.15}, {box});
  scene.add_box(box, 0.03);
  scene.add_outliers({0, 0, 0.20, 0.15}, 0.2, 50);
  send(scene.cloud());

  const auto result = output("grid");
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->header.frame_id, "world");
  EXPECT_EQ(result->header.stamp.nsec, 5U);
  std::size_t points = scene.cloud().size();
  for (const std::string stage : kStages) {
    const auto said = report(stage);
    ASSERT_NE(said, nullptr) << stage;
    EXPECT_TRUE(said->ok) << said->message;
    EXPECT_EQ(said->stage, stage);
    EXPECT_EQ(said->header.stamp, result->header.stamp);
    EXPECT_EQ(said->points_in, points);
    points = said->points_out;
  }
  EXPECT_EQ(std::size_t{result->width} * result->height, points);
  const Cloud isolated = scan_cell_common::from_message(*output("isolate"));
  EXPECT_EQ(scene.share_in(isolated, Label::kFloor), 0.0);
  EXPECT_EQ(scene.share_in(isolated, Label::kOutlier), 0.0);
  EXPECT_GE(scene.share_in(isolated, Label::kPart), 0.9999);
}

TEST_F(Chain, IsOneNodeletThatGivesEachObjectToo) {
  const Scene::Rectangle left{-0.06, 0, 0.06, 0.08}, right{0.06, 0, 0.08, 0.08};
  Scene scene;
  scene.add_floor({0, 0, 0.30, 0.15}, {left, right});
  scene.add_box(left, 0.03, Label::kOtherPart);
  scene.add_box(right, 0.03);
  send(scene.cloud());
  const auto result = output("whole");
  ASSERT_NE(result, nullptr);
  const Cloud part = scan_cell_common::from_message(*result);
  EXPECT_GE(scene.share_in(part, Label::kPart), 0.98);  // outliers take points off edges
  EXPECT_EQ(scene.share_in(part, Label::kOtherPart), 0.0);
  const auto objects =
      ros::topic::waitForMessage<scan_cell_msgs::ObjectClouds>("whole/objects", ros::Duration(60));
  ASSERT_NE(objects, nullptr);
  EXPECT_EQ(objects->header.stamp, result->header.stamp);
  ASSERT_EQ(objects->clouds.size(), 2U);
  const Cloud other = scan_cell_common::from_message(objects->clouds[0]);
  EXPECT_GE(scene.share_in(other, Label::kOtherPart), 0.98);
  EXPECT_EQ(objects->clouds[1].data, result->data);
}

TEST_F(Chain, CleansTheLatestCloudAnewWithOtherParameters) {
  const Scene::Rectangle box{0, 0, 0.06, 0.08};
  Scene scene;
  scene.add_floor({0, 0, 0.20, 0.15}, {box});
  scene.add_box(box, 0.03);
  send(scene.cloud());
  ASSERT_NE(output("whole"), nullptr);
  const auto apply = [] {
    std_srvs::Trigger trigger;
    EXPECT_TRUE(ros::service::call("whole/apply", trigger));
    return trigger.response;
  };
  forget("whole");
  ros::param::set("whole/floor/z_min", 0.02);
  EXPECT_TRUE(apply().success);
  const auto anew = output("whole");
  ASSERT_NE(anew, nullptr);
  for (const auto& point : scan_cell_common::from_message(*anew))
    ASSERT_GE(point.z, 0.02);

  forget("whole");
  ros::param::set("whole/floor/z_min", 5.0);  // nothing is left
  const auto nothing = apply();
  EXPECT_FALSE(nothing.success);
  EXPECT_NE(nothing.message.find("no point lies within them"), std::string::npos)
      << nothing.message;
  ros::param::del("whole/floor/z_min");
  ros::param::set("whole/floor/margin", -1.0);
  const auto refused = apply();
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("floor/margin"), std::string::npos) << refused.message;
  ros::param::set("whole/floor/margin", 0.002);
  EXPECT_TRUE(apply().success);
}

TEST_F(Chain, KeepsWhatEachPointCarries) {
  const Scene::Rectangle box{0, 0, 0.06, 0.08};
  Scene scene;
  scene.add_floor({0, 0, 0.20, 0.15}, {box});
  scene.add_box(box, 0.03);
  const PointCloud2 message = scan_cell_common::to_message(scene.cloud(), {});
  const scan_cell_common::CloudView cloud = scan_cell_common::view_of(message);
  // After x, y and z, the point's own x again, which shows where it came from.
  scan_cell_common::FieldedCloud marked{cloud.fields, cloud.step + sizeof(float), {}};
  marked.fields.push_back(
      {"mark", scan_cell_common::FieldType::kFloat32, static_cast<std::size_t>(cloud.step)});
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint8_t* const point = cloud.data + i * cloud.step;
    marked.bytes.insert(marked.bytes.end(), point, point + cloud.step);
    marked.bytes.insert(marked.bytes.end(), point, point + sizeof(float));
  }
  send(scan_cell_common::to_message(marked, {}));

  const auto result = output("grid");
  ASSERT_NE(result, nullptr);
  sensor_msgs::PointCloud2ConstIterator<float> x(*result, "x");
  sensor_msgs::PointCloud2ConstIterator<float> mark(*result, "mark");
  for (; x != x.end(); ++x, ++mark)
    ASSERT_NEAR(*x, *mark, 0.002) << "of a point in the same cell";
}

TEST_F(Chain, LooksForTheFloorWhereItsParameterUpSays) {
  const Scene::Rectangle box{0, 0, 0.06, 0.08};
  Scene scene;
  scene.add_floor({0, 0, 0.20, 0.15}, {box});
  scene.add_box(box, 0.03);
  scene.move(Eigen::Affine3f(Eigen::AngleAxisf(3.14F, Eigen::Vector3f::UnitX())));
  send(scene.cloud());
  const auto result = output("ceiling");
  ASSERT_NE(result, nullptr);
  const Cloud left = scan_cell_common::from_message(*result);
  EXPECT_EQ(scene.share_in(left, Label::kFloor), 0.0);
  EXPECT_EQ(scene.share_in(left, Label::kPart), 1.0);
  const auto said = report("floor");  // whose up is z
  ASSERT_NE(said, nullptr);
  EXPECT_FALSE(said->ok);
  EXPECT_NE(said->message.find("--up"), std::string::npos) << said->message;
}

TEST_F(Chain, BringsACloudOfAnotherFrameIntoTheTargetFrame) {
  const Scene::Rectangle box{0, 0, 0.06, 0.08};
  Scene scene;
  scene.add_floor({0, 0, 0.20, 0.15}, {box});
  scene.add_box(box, 0.03);
  const Eigen::Affine3f table = Eigen::Translation3f(0.1F, 0.2F, 0.3F) *
                                Eigen::Quaternionf(0, 0, 0, 1);  // as in nodelets.test
  scene.move(table.inverse());
  send(scan_cell_common::to_message(scene.cloud(), {}), "table");
  const auto result = output("elsewhere");
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->header.frame_id, "world");
  const auto said = report("elsewhere");
  ASSERT_NE(said, nullptr);
  EXPECT_TRUE(said->ok) << said->message;
  EXPECT_EQ(said->header.frame_id, "world");
  float lowest = 1, highest = 0;
  for (const auto& point : scan_cell_common::from_message(*result)) {
    lowest = std::min(lowest, point.z);
    highest = std::max(highest, point.z);
  }
  EXPECT_GT(lowest, 0);
  EXPECT_NEAR(highest, 0.03, 1e-3);         // ten times the noise
  const auto as_it_came = output("floor");  // which has no target frame
  ASSERT_NE(as_it_came, nullptr);
  EXPECT_EQ(as_it_came->header.frame_id, "table");
}

TEST_F(Chain, ReportsFramesThatNothingLinksToTheTargetFrame) {
  Scene scene;
  scene.add_box({0, 0, 0.01, 0.01}, 0.01);
  send(scan_cell_common::to_message(scene.cloud(), {}), "nowhere");
  const auto said = report("elsewhere");
  ASSERT_NE(said, nullptr);
  EXPECT_FALSE(said->ok);
  EXPECT_EQ(said->points_out, 0U);
  EXPECT_NE(said->message.find("cloud in frame 'nowhere': no transform to 'world' within 0.3 s"),
            std::string::npos)
      << said->message;
  EXPECT_FALSE(has_output("elsewhere"));
}

TEST_F(Chain, ReportsWhyAndSendsNoCloudWhereNothingIsLeft) {
  Scene scene;
  scene.add_floor({0, 0, 0.20, 0.15});
  send(scene.cloud());
  const auto said = report("floor");
  ASSERT_NE(said, nullptr);
  EXPECT_FALSE(said->ok);
  EXPECT_EQ(said->points_in, scene.cloud().size());
  EXPECT_EQ(said->points_out, 0U);
  EXPECT_NE(said->message.find("nothing is left"), std::string::npos) << said->message;
  EXPECT_FALSE(has_output("floor"));
}

TEST_F(Chain, ReportsCloudsWithoutAFinitePoint) {
  Cloud cloud;
  cloud.push_back({0, std::numeric_limits<float>::quiet_NaN(), 0});
  send(cloud);
  const auto said = report("floor");
  ASSERT_NE(said, nullptr);
  EXPECT_FALSE(said->ok);
  EXPECT_NE(said->message.find("no finite point"), std::string::npos) << said->message;
  EXPECT_FALSE(has_output("floor"));
}

TEST_F(Chain, ReportsMessagesWithoutXyz) {
  Scene scene;
  scene.add_box({0, 0, 0.01, 0.01}, 0.01);
  PointCloud2 message = scan_cell_common::to_message(scene.cloud(), {});
  message.fields[2].name = "height";
  send(message);
  const auto said = report("floor");
  ASSERT_NE(said, nullptr);
  EXPECT_FALSE(said->ok);
  EXPECT_NE(said->message.find("field z"), std::string::npos) << said->message;
}

TEST(Nodelets, RefuseToStartOnABadParameterByItsName) {
  const std::string log =
      (std::filesystem::temp_directory_path() / ("nodelet_" + std::to_string(getpid()) + ".txt"))
          .string();
  const auto said_by = [&log](const std::string& nodelet) {
    const std::string command =
        "rosrun nodelet nodelet standalone cloud_preprocess/" + nodelet + " > " + log + " 2>&1";
    EXPECT_NE(std::system(command.c_str()), 0) << nodelet;
    std::ifstream file(log);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_NE(said_by("Floor __name:=bad_floor _margin:=-1").find("/bad_floor/margin"),
            std::string::npos);
  ros::param::set("/lost_floor/up",
                  std::vector<double>{0, 0, 0});  // a command line cannot give a list
  EXPECT_NE(said_by("Floor __name:=lost_floor").find("up: (0, 0, 0)"), std::string::npos);
  EXPECT_NE(said_by("Outliers __name:=bad_outliers _neighbors:=4").find("/bad_outliers/neighbors"),
            std::string::npos);
  EXPECT_NE(said_by("Isolate __name:=bad_isolate _select:=best").find("/bad_isolate/select"),
            std::string::npos);
  ros::param::set("/bad_grid/leaf", std::vector<double>{0.1, 0.1});
  EXPECT_NE(said_by("Grid __name:=bad_grid").find("leaf"), std::string::npos);
  std::filesystem::remove(log);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_nodelets");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
