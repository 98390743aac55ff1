// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreSceneNode.h>
#include <rviz/ogre_helpers/axes.h>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/ogre_helpers/movable_text.h>
#include <rviz/ogre_helpers/shape.h>
#include <scan_cell_msgs/WorkPreview.h>

#include <memory>
#include <vector>

namespace scan_cell_rviz {

/// The way of the tool's tip, coloured by speed, the tool's frame at some poses, and balls where
/// the robot cannot follow.
class PreviewDrawing {
 public:
  PreviewDrawing(Ogre::SceneManager* scene, Ogre::SceneNode* node) : scene_(scene), node_(node) {}
  ~PreviewDrawing() { clear(); }
  PreviewDrawing(const PreviewDrawing&) = delete;
  PreviewDrawing& operator=(const PreviewDrawing&) = delete;

  void draw(const scan_cell_msgs::WorkPreview& preview);
  void clear();

 private:
  void draw_way(const scan_cell_msgs::WorkPreview& preview);
  void draw_frames(const scan_cell_msgs::WorkPreview& preview);
  void draw_faults(const scan_cell_msgs::WorkPreview& preview);

  Ogre::SceneManager* scene_;
  Ogre::SceneNode* node_;
  std::unique_ptr<rviz::BillboardLine> way_;
  std::vector<std::unique_ptr<rviz::Axes>> frames_;
  std::vector<std::unique_ptr<rviz::Shape>> faults_;
  Ogre::SceneNode* text_node_ = nullptr;
  std::unique_ptr<rviz::MovableText> text_;  // of the first fault
};

}  // namespace scan_cell_rviz
