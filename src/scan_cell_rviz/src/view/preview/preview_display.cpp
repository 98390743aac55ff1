// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/preview/preview_display.h"

#include <rviz/display_context.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/int_property.h>
#include <rviz/properties/ros_topic_property.h>
#include <rviz/properties/string_property.h>
#include <rviz/robot/robot_link.h>
#include <urdf/model.h>

#include <pluginlib/class_list_macros.hpp>

#include "preview/preview_view.h"
#include "scan_cell_common/errors/errors.h"
#include "view/cloud_frame.h"

namespace scan_cell_rviz {
namespace {

using rviz::StatusProperty;
using scan_cell_msgs::WorkPreview;

constexpr float kAlpha = 0.5F;  // the robot itself stays visible; chosen

void place(rviz::Robot& robot, const std::map<std::string, Eigen::Isometry3d>& poses) {
  for (const auto& [name, link] : robot.getLinks()) {
    const auto found = poses.find(name);
    if (found == poses.end()) continue;
    const Eigen::Quaternionf turn(found->second.linear().cast<float>());
    const Ogre::Vector3 position = to_ogre(found->second.translation());
    const Ogre::Quaternion orientation(turn.w(), turn.x(), turn.y(), turn.z());
    link->setTransforms(position, orientation, position, orientation);
  }
}

QString said_of(const WorkPreview& preview) {
  const SpeedRange range = speeds_of(preview);
  return QObject::tr("%1 poses%2; %3 (dark) to %4 mm/s (yellow), to the path and away grey")
      .arg(preview.waypoints.size())
      .arg(preview.dry_run != 0 ? QObject::tr(" of the dry run") : QString())
      .arg(range.least * 1e3)
      .arg(range.most * 1e3);
}

}  // namespace

PreviewDisplay::PreviewDisplay() {
  topic_ = new rviz::RosTopicProperty(
      "Topic", "/scan_cell/work_preview",
      QString::fromStdString(ros::message_traits::datatype<WorkPreview>()),
      "what the cell would do with a path", this, SLOT(subscribe()));
  description_ =
      new rviz::StringProperty("Robot Description", "robot_description",
                               "parameter with the robot's URDF", this, SLOT(load_robot()));
  run_ = new rviz::StringProperty("Run", "",
                                  "whose preview alone is drawn, its id; empty: that of any", this,
                                  SLOT(subscribe()));
  run_->setShouldBeSaved(false);  // the seat sets it
  pose_ = new rviz::IntProperty("Pose", 0, "of the tip, counted from 0, where the ghost stands",
                                this, SLOT(place_ghost()));
  pose_->setMin(0);
  alpha_ = new rviz::FloatProperty("Alpha", kAlpha, "of the ghost: 0 hides it", this,
                                   SLOT(place_ghost()));
  alpha_->setMin(0);
  alpha_->setMax(1);
}

PreviewDisplay::~PreviewDisplay() {
  subscriber_.shutdown();
}

void PreviewDisplay::onInitialize() {
  drawing_ = std::make_unique<PreviewDrawing>(context_->getSceneManager(), scene_node_);
  robot_ = std::make_unique<rviz::Robot>(scene_node_, context_, "Ghost", this);
  robot_->setVisualVisible(true);
  robot_->setCollisionVisible(false);
  robot_->setVisible(false);
}

void PreviewDisplay::onEnable() {
  load_robot();
  subscribe();
}

void PreviewDisplay::onDisable() {
  forget();
}

/// What came on another topic, of another run, or before hiding, is no longer valid.
void PreviewDisplay::forget() {
  subscriber_.shutdown();
  preview_.reset();
  left_out_.clear();
  drawing_->clear();
  place_ghost();
}

void PreviewDisplay::subscribe() {
  if (!isEnabled()) return;
  forget();
  try {
    subscriber_ = update_nh_.subscribe(topic_->getTopicStd(), 10, &PreviewDisplay::show, this);
    deleteStatus("Topic");
  } catch (const ros::Exception& error) {  // an invalid name
    setStatus(StatusProperty::Error, "Topic", error.what());
  }
}

void PreviewDisplay::load_robot() {
  if (!isEnabled()) return;
  robot_->clear();
  model_.reset();
  try {
    std::string text;
    urdf::Model urdf;
    if (update_nh_.getParam(description_->getStdString(), text) && urdf.initString(text)) {
      model_ = std::make_unique<LinkPoses>(text);
      robot_->load(urdf, true, false);
    }
  } catch (const ros::Exception&) {  // an invalid name
  } catch (const scan_cell_common::Error&) {
  }
  place_ghost();
}

void PreviewDisplay::show(const scan_cell_msgs::WorkPreviewConstPtr& preview) {
  const QString run = run_->getString();
  if (!run.isEmpty() && !is_of_run(*preview, run)) {
    left_out_ = QString::fromStdString(preview->path);
    return;
  }
  preview_ = preview;
  drawing_->draw(*preview);
  if (preview->faults.empty())
    setStatus(StatusProperty::Ok, "Way", said_of(*preview));
  else
    setStatus(StatusProperty::Error, "Way", QString::fromStdString(preview->message));
  place_ghost();
}

void PreviewDisplay::place_ghost() {
  if (!robot_) return;
  links_.clear();
  if (preview_ && isEnabled()) {
    const auto at = static_cast<std::size_t>(pose_->getInt());
    const std::string hidden = place_links(joints_at(*preview_, at));
    const QString said = hidden.empty() ? text_at(*preview_, at) : QString::fromStdString(hidden);
    setStatus(links_.empty() ? StatusProperty::Warn : StatusProperty::Ok, "Ghost", said);
  }
  robot_->setVisible(in_frame_ && !links_.empty() && alpha_->getFloat() > 0);
  robot_->setAlpha(alpha_->getFloat());
  place(*robot_, links_);
  context_->queueRender();
}

/// @return why the links have no poses; empty: they have
std::string PreviewDisplay::place_links(const std::map<std::string, double>& joints) {
  if (!model_) return description_->getStdString() + " is not a URDF: no ghost";
  if (joints.empty()) return "the robot does not get there, or there is no such pose";
  try {
    links_ = model_->at(preview_->header.frame_id, joints);
    return "";
  } catch (const scan_cell_common::Error& error) {
    return error.what();
  }
}

std::optional<Eigen::Vector3d> PreviewDisplay::ghost(const std::string& link) const {
  rviz::RobotLink* const shown = robot_->getLink(link);
  if (shown == nullptr || !robot_->isVisible()) return std::nullopt;
  const Ogre::Vector3 place = shown->getVisualNode()->_getDerivedPosition();
  return Eigen::Vector3d(place.x, place.y, place.z);
}

void PreviewDisplay::update(float, float) {
  if (!preview_)
    return setStatus(StatusProperty::Ok, "Way",
                     left_out_.isEmpty()
                         ? QObject::tr("none was asked for")
                         : QObject::tr("one came of %1, not of this run").arg(left_out_));
  const auto frame = frame_in_view(*context_, preview_->header.frame_id);
  if (frame.has_value() != in_frame_) {  // it would be drawn in the wrong place
    in_frame_ = frame.has_value();
    scene_node_->setVisible(in_frame_);
    place_ghost();
  }
  if (!frame) {
    return setStatus(
        StatusProperty::Error, "Frame",
        QString::fromStdString("'" + preview_->header.frame_id + "' is not known to rviz"));
  }
  deleteStatus("Frame");
  scene_node_->setPosition(frame->position);
  scene_node_->setOrientation(frame->orientation);
}

void PreviewDisplay::reset() {
  rviz::Display::reset();
  load_robot();
  subscribe();  // the topic is latched
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::PreviewDisplay, rviz::Display)
