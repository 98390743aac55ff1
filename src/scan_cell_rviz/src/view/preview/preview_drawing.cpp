// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/preview/preview_drawing.h"

#include <OgreSceneManager.h>

#include <algorithm>

#include "preview/preview_view.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::WorkPreview;

constexpr float kWidth = 0.0015F;        // [m] of the line; chosen
constexpr float kFrameLength = 0.012F;   // [m] chosen
constexpr float kFrameRadius = 0.0006F;  // [m] chosen
constexpr float kBall = 0.008F;          // [m] across; chosen
constexpr float kLetters = 0.012F;       // [m] high; chosen
constexpr std::size_t kFrames = 24;      // at most; chosen
constexpr std::size_t kFaults = 200;     // at most: the list beside it has them all; chosen
const Ogre::ColourValue kAway(0.6F, 0.6F, 0.6F);      // to the path and away from it
const Ogre::ColourValue kFault(0.90F, 0.45F, 0.05F);  // orange: distinct from all speed colours

Ogre::Vector3 place_of(const geometry_msgs::Pose& pose) {
  return Ogre::Vector3(static_cast<float>(pose.position.x), static_cast<float>(pose.position.y),
                       static_cast<float>(pose.position.z));
}

Ogre::Quaternion turn_of(const geometry_msgs::Pose& pose) {
  const auto& turn = pose.orientation;
  return Ogre::Quaternion(static_cast<float>(turn.w), static_cast<float>(turn.x),
                          static_cast<float>(turn.y), static_cast<float>(turn.z));
}

}  // namespace

void PreviewDrawing::clear() {
  way_.reset();
  frames_.clear();
  faults_.clear();
  if (text_node_ != nullptr) {
    text_node_->detachAllObjects();
    scene_->destroySceneNode(text_node_);
    text_node_ = nullptr;
  }
  text_.reset();
}

void PreviewDrawing::draw(const WorkPreview& preview) {
  clear();
  draw_way(preview);
  draw_frames(preview);
  draw_faults(preview);
}

void PreviewDrawing::draw_way(const WorkPreview& preview) {
  if (preview.waypoints.size() < 2) return;
  const SpeedRange range = speeds_of(preview);
  way_ = std::make_unique<rviz::BillboardLine>(scene_, node_);
  way_->setMaxPointsPerLine(static_cast<std::uint32_t>(2 * preview.waypoints.size()));
  way_->setLineWidth(kWidth);
  for (std::size_t i = 1; i < preview.waypoints.size(); ++i) {
    Ogre::ColourValue colour = kAway;
    if (is_along_path(preview, i)) {
      const auto rgb = colour_of(preview.waypoints[i].speed, range);
      colour = Ogre::ColourValue(rgb[0], rgb[1], rgb[2]);
    }
    way_->addPoint(place_of(preview.waypoints[i - 1].tip), colour);
    way_->addPoint(place_of(preview.waypoints[i].tip), colour);
  }
}

void PreviewDrawing::draw_frames(const WorkPreview& preview) {
  const std::size_t step = (preview.waypoints.size() + kFrames - 1) / kFrames;
  for (std::size_t i = 0; i < preview.waypoints.size(); i += step) {
    auto frame = std::make_unique<rviz::Axes>(scene_, node_, kFrameLength, kFrameRadius);
    frame->setPosition(place_of(preview.waypoints[i].tip));
    frame->setOrientation(turn_of(preview.waypoints[i].tip));
    frames_.push_back(std::move(frame));
  }
}

void PreviewDrawing::draw_faults(const WorkPreview& preview) {
  for (std::size_t i = 0; i < std::min(preview.faults.size(), kFaults); ++i) {
    auto ball = std::make_unique<rviz::Shape>(rviz::Shape::Sphere, scene_, node_);
    ball->setPosition(place_of(preview.faults[i].tip));
    ball->setScale(Ogre::Vector3(kBall, kBall, kBall));
    ball->setColor(kFault);
    faults_.push_back(std::move(ball));
  }
  if (preview.faults.empty()) return;
  text_ = std::make_unique<rviz::MovableText>(preview.faults.front().message, "Liberation Sans",
                                              kLetters, kFault);
  text_->setTextAlignment(rviz::MovableText::H_CENTER, rviz::MovableText::V_ABOVE);
  text_node_ = node_->createChildSceneNode(place_of(preview.faults.front().tip) +
                                           Ogre::Vector3(0, 0, kBall));
  text_node_->attachObject(text_.get());
}

}  // namespace scan_cell_rviz
