// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscriber.h>
#include <rviz/display.h>
#include <rviz/robot/robot.h>
#include <scan_cell_msgs/WorkPreview.h>

#include <memory>
#include <optional>

#include "preview/link_poses.h"
#include "view/preview/preview_drawing.h"

namespace rviz {
class FloatProperty;
class IntProperty;
class RosTopicProperty;
class StringProperty;
}  // namespace rviz

namespace scan_cell_rviz {

/// What the robot would do with a path: the way, and a ghost of the robot at the pose with the
/// index "Pose".
class PreviewDisplay : public rviz::Display {
  Q_OBJECT

 public:
  PreviewDisplay();
  ~PreviewDisplay() override;

  void update(float wall_dt, float ros_dt) override;
  void reset() override;

  /// Position of a link of the ghost in the view [m]. @return none: it is not shown
  std::optional<Eigen::Vector3d> ghost(const std::string& link) const;

 protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;

 private Q_SLOTS:
  void subscribe();
  void place_ghost();
  void load_robot();

 private:
  void show(const scan_cell_msgs::WorkPreviewConstPtr& preview);
  void forget();
  std::string place_links(const std::map<std::string, double>& joints);

  rviz::RosTopicProperty* topic_;
  rviz::StringProperty* description_;
  rviz::StringProperty* run_;
  rviz::IntProperty* pose_;
  rviz::FloatProperty* alpha_;
  ros::Subscriber subscriber_;
  scan_cell_msgs::WorkPreviewConstPtr preview_;
  QString left_out_;  // path of the last preview of another run
  std::unique_ptr<PreviewDrawing> drawing_;
  std::unique_ptr<rviz::Robot> robot_;
  std::unique_ptr<LinkPoses> model_;
  std::map<std::string, Eigen::Isometry3d> links_;  // of the ghost; empty: hidden
  bool in_frame_ = true;                            // rviz knows the preview's frame
};

}  // namespace scan_cell_rviz
