// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/scan/edit_display.h"

#include <OgreRoot.h>
#include <OgreSceneNode.h>
#include <rviz/properties/float_property.h>

#include <algorithm>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>

#include "edit/stage_colours.h"
#include "view/cloud_frame.h"

namespace scan_cell_rviz {
namespace {

constexpr float kPixels = 3;  // of a point; chosen
const Ogre::ColourValue kKept(0.95F, 0.95F, 0.95F);
const Ogre::ColourValue kTaken(0.90F, 0.45F, 0.05F);  // orange: distinct if colour-blind

// In the order of colours().
enum Look : std::uint8_t { kNotDrawn, kStays, kWasTaken, kFirstStage };

std::vector<Ogre::ColourValue> colours() {
  std::vector<Ogre::ColourValue> all = {kKept, kTaken};
  for (const StageColour& colour : kStageColours)
    all.emplace_back(colour.red, colour.green, colour.blue);
  return all;
}

/// The look of each point of the source. What a stage would remove is marked until a later edit
/// takes it.
CloudPieces::Looks looks_of(const EditedView& view) {
  CloudPieces::Looks looks(view.source->size(), kNotDrawn);
  for (const std::uint32_t i : view.shown)
    looks[i] = kStays;
  std::uint8_t look = kFirstStage;
  for (const StageColour& colour : kStageColours) {
    for (const StageView& stage : view.stages) {
      if (stage.name != colour.stage) continue;
      for (const std::uint32_t i : stage.points)
        if (looks[i] != kNotDrawn) looks[i] = look;
    }
    ++look;
  }
  for (const std::uint32_t i : view.last)
    looks[i] = kWasTaken;
  return looks;
}

}  // namespace

EditDisplay::EditDisplay() {
  size_ = new rviz::FloatProperty("Size", kPixels, "of a point [pixels]", this, SLOT(show()));
  size_->setMin(1);
}

EditDisplay::~EditDisplay() {
  if (pieces_) Ogre::Root::getSingleton().removeFrameListener(this);
}

void EditDisplay::onInitialize() {
  pieces_ = std::make_unique<CloudPieces>(*scene_node_, colours());
  Ogre::Root::getSingleton().addFrameListener(this);
  connect(&shared_edit_session(), &EditSession::changed, this, &EditDisplay::show);
  show();
}

void EditDisplay::show() {
  if (!pieces_ || !isEnabled()) return;  // nobody sees the points
  const EditedViewPtr view = shared_edit_session().view();
  if (view) pieces_->show(view->source, looks_of(*view));
  view_ = view;
  is_drawn_ = false;
}

void EditDisplay::update(float, float) {
  if (!view_) return setStatus(rviz::StatusProperty::Ok, "Scan", "none is in view");
  const auto frame = frame_in_view(*context_, view_->frame);
  if (!frame)
    return setStatus(rviz::StatusProperty::Error, "Scan",
                     QString::fromStdString("frame '" + view_->frame + "' is not known to rviz"));
  scene_node_->setPosition(frame->position);
  scene_node_->setOrientation(frame->orientation);
  constexpr double kLargest = 2;  // times the size, to keep a thinned surface closed; chosen
  const double larger = std::min(kLargest, std::sqrt(1 / pieces_->share()));
  pieces_->set_size(std::round(size_->getFloat() * static_cast<float>(larger)));
  is_drawn_ = pieces_->draw();
  if (!is_drawn_) return setStatus(rviz::StatusProperty::Ok, "Scan", tr("being drawn"));
  QString words = tr("%1 points stay").arg(view_->kept.size());
  constexpr double kPercent = 100;
  if (pieces_->share() < 1)
    words += tr("; %1 % of all are drawn, as many as this computer draws in time")
                 .arg(kPercent * pieces_->share(), 0, 'f', 0);
  setStatus(rviz::StatusProperty::Ok, "Scan", words);
}

bool EditDisplay::frameStarted(const Ogre::FrameEvent&) {
  picture_began_ = std::chrono::steady_clock::now();
  return true;
}

bool EditDisplay::frameEnded(const Ogre::FrameEvent&) {
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - picture_began_;
  if (isEnabled()) pieces_->follow(took.count());
  return true;
}

void EditDisplay::reset() {
  rviz::Display::reset();
  show();
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::EditDisplay, rviz::Display)
