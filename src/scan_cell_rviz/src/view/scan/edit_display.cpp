// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/scan/edit_display.h"

#include <OgreSceneNode.h>
#include <rviz/properties/float_property.h>

#include <algorithm>
#include <pluginlib/class_list_macros.hpp>

#include "edit/stage_colours.h"
#include "view/cloud_frame.h"

namespace scan_cell_rviz {
namespace {

constexpr float kPixels = 3;  // of a point; chosen
const Ogre::ColourValue kKept(0.85F, 0.85F, 0.85F);
const Ogre::ColourValue kTaken(0.90F, 0.45F, 0.05F);  // orange: told from grey by all eyes

/// Of each point of the source that stays, as long as no later edit takes it.
std::vector<Ogre::ColourValue> colours_of(const EditedView& view) {
  std::vector<Ogre::ColourValue> colours(view.source->size(), kKept);
  for (const StageView& stage : view.stages) {
    const auto* const colour =
        std::find_if(kStageColours.begin(), kStageColours.end(),
                     [&](const StageColour& known) { return stage.name == known.stage; });
    if (colour == kStageColours.end()) continue;
    for (const std::uint32_t i : stage.points)
      colours[i] = Ogre::ColourValue(colour->red, colour->green, colour->blue);
  }
  return colours;
}

/// @param colour_of a point of the source
template <class ColourOf>
void fill(rviz::PointCloud& shown, const EditedView& view,
          const cloud_preprocess::EditedCloud::Indices& points, const ColourOf& colour_of) {
  std::vector<rviz::PointCloud::Point> drawn;
  drawn.reserve(points.size());
  for (const std::uint32_t i : points) {
    const auto& point = (*view.source)[i];
    drawn.push_back({Ogre::Vector3(point.x, point.y, point.z), colour_of(i)});
  }
  shown.clear();
  if (!drawn.empty()) shown.addPoints(drawn.data(), static_cast<std::uint32_t>(drawn.size()));
}

}  // namespace

EditDisplay::EditDisplay() {
  size_ = new rviz::FloatProperty("Size", kPixels, "of a point [pixels]", this, SLOT(show()));
  size_->setMin(1);
}

EditDisplay::~EditDisplay() {
  for (const auto& cloud : {kept_.get(), taken_.get()})
    if (cloud != nullptr && scene_node_ != nullptr) scene_node_->detachObject(cloud);
}

void EditDisplay::onInitialize() {
  for (auto* const cloud : {&kept_, &taken_}) {
    *cloud = std::make_unique<rviz::PointCloud>();
    (*cloud)->setName(cloud == &kept_ ? "kept" : "taken");  // Ogre tells them apart by it
    (*cloud)->setRenderMode(rviz::PointCloud::RM_POINTS);
    scene_node_->attachObject(cloud->get());
  }
  connect(&shared_edit_session(), &EditSession::changed, this, &EditDisplay::show);
  show();
}

void EditDisplay::show() {
  if (!kept_ || !isEnabled()) return;  // millions of points that nobody sees
  view_ = shared_edit_session().view();
  for (auto* const cloud : {kept_.get(), taken_.get()})
    cloud->setDimensions(size_->getFloat(), size_->getFloat(), size_->getFloat());
  if (view_) {
    const std::vector<Ogre::ColourValue> colours = colours_of(*view_);
    fill(*kept_, *view_, view_->shown, [&](std::uint32_t i) { return colours[i]; });
    fill(*taken_, *view_, view_->last, [](std::uint32_t) { return kTaken; });
  }
  context_->queueRender();
}

void EditDisplay::update(float, float) {
  if (!view_) return setStatus(rviz::StatusProperty::Ok, "Scan", "none is in view");
  const auto frame = frame_in_view(*context_, view_->frame);
  if (!frame)
    return setStatus(rviz::StatusProperty::Error, "Scan",
                     QString::fromStdString("frame '" + view_->frame + "' is not known to rviz"));
  scene_node_->setPosition(frame->position);
  scene_node_->setOrientation(frame->orientation);
  setStatus(rviz::StatusProperty::Ok, "Scan", tr("%1 points stay").arg(view_->kept.size()));
}

void EditDisplay::reset() {
  rviz::Display::reset();
  show();
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::EditDisplay, rviz::Display)
