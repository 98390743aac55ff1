// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/path/path_display.h"

#include <OgreSceneNode.h>
#include <rviz/properties/float_property.h>

#include <algorithm>
#include <pluginlib/class_list_macros.hpp>

#include "path/path_session.h"
#include "view/cloud_frame.h"

namespace scan_cell_rviz {
namespace {

constexpr float kSize = 0.0015F;         // [m] of a waypoint; chosen
constexpr float kEditedTimes = 2;        // larger than others; chosen
constexpr std::size_t kMostChosen = 50;  // with axes: more would hide the path; chosen
const Ogre::ColourValue kPath(0.75F, 0.75F, 0.75F);
const Ogre::ColourValue kEdited(0.90F, 0.45F, 0.05F);  // orange: distinct if colour-blind
const Ogre::ColourValue kDeleted(0.35F, 0.35F, 0.35F);

void fill(rviz::PointCloud& shown, const std::vector<Eigen::Vector3d>& places, float size,
          const Ogre::ColourValue& colour) {
  std::vector<rviz::PointCloud::Point> drawn;
  drawn.reserve(places.size());
  for (const Eigen::Vector3d& place : places)
    drawn.push_back({to_ogre(place), colour});
  shown.clear();
  shown.setDimensions(size, size, size);
  if (!drawn.empty()) shown.addPoints(drawn.data(), static_cast<std::uint32_t>(drawn.size()));
}

}  // namespace

PathDisplay::PathDisplay() {
  size_ = new rviz::FloatProperty("Size", kSize, "of a waypoint [m]", this, SLOT(show()));
  size_->setMin(1e-5F);
}

PathDisplay::~PathDisplay() {
  for (const auto* const cloud : {adapted_.get(), edited_.get(), deleted_.get()})
    if (cloud != nullptr) scene_node_->detachObject(cloud->getName());
}

void PathDisplay::onInitialize() {
  const auto make = [this](const char* name, rviz::PointCloud::RenderMode mode) {
    auto cloud = std::make_unique<rviz::PointCloud>();
    cloud->setName(name);  // Ogre needs different names
    cloud->setRenderMode(mode);
    scene_node_->attachObject(cloud.get());
    return cloud;
  };
  adapted_ = make("adapted", rviz::PointCloud::RM_SPHERES);
  edited_ = make("edited", rviz::PointCloud::RM_BOXES);
  deleted_ = make("deleted", rviz::PointCloud::RM_FLAT_SQUARES);
  connect(&shared_path_session(), &PathSession::changed, this, &PathDisplay::show);
  connect(&shared_path_session(), &PathSession::selectionChanged, this, &PathDisplay::show_chosen);
  show();
}

void PathDisplay::show() {
  if (!deleted_ || !isEnabled()) return;
  const PathSession& session = shared_path_session();
  const float size = size_->getFloat();
  std::vector<Eigen::Vector3d> adapted, edited, deleted;
  for (std::size_t i = 0; i < session.waypoints().size(); ++i)
    (session.edited().origins[i].edited ? edited : adapted)
        .push_back(session.waypoints()[i].pose.translation());
  const tool_paths::Points before = session.positions_before();
  for (const std::size_t i : session.deleted())
    deleted.push_back(before[i]);
  fill(*adapted_, adapted, size, kPath);
  fill(*edited_, edited, kEditedTimes * size, kEdited);
  fill(*deleted_, deleted, size, kDeleted);
  draw_lines(size / 2);
  show_chosen();
}

/// Splits lines into pieces: rviz divides by the number of longest lines that fit into 16384
/// points, which must not be 0.
void PathDisplay::draw_lines(float width) {
  constexpr std::size_t kMost = 1000;  // points of a piece; chosen
  lines_.clear();
  for (const tool_paths::Segment& segment : shared_path_session().edited().path.segments) {
    const auto& waypoints = segment.waypoints;
    for (std::size_t begin = 0; begin + 1 < waypoints.size(); begin += kMost - 1) {
      const std::size_t end = std::min(begin + kMost, waypoints.size());
      auto line = std::make_unique<rviz::BillboardLine>(context_->getSceneManager(), scene_node_);
      line->setMaxPointsPerLine(static_cast<std::uint32_t>(end - begin));
      line->setLineWidth(width);
      for (std::size_t i = begin; i < end; ++i)
        line->addPoint(to_ogre(waypoints[i].pose.translation()), kPath);
      lines_.push_back(std::move(line));
    }
  }
}

void PathDisplay::show_chosen() {
  if (!deleted_ || !isEnabled()) return;
  chosen_.clear();
  const PathSession& session = shared_path_session();
  if (const auto& range = session.selected()) {
    const float length = 8 * size_->getFloat();
    const std::size_t last = std::min(range->last, range->first + kMostChosen - 1);
    for (std::size_t i = range->first; i <= last; ++i) {
      const Eigen::Quaterniond turn(session.waypoints()[i].pose.linear());
      auto axes = std::make_unique<rviz::Axes>(context_->getSceneManager(), scene_node_, length,
                                               length / 15);
      axes->setPosition(to_ogre(session.waypoints()[i].pose.translation()));
      axes->setOrientation(
          Ogre::Quaternion(static_cast<float>(turn.w()), static_cast<float>(turn.x()),
                           static_cast<float>(turn.y()), static_cast<float>(turn.z())));
      chosen_.push_back(std::move(axes));
    }
  }
  context_->queueRender();
}

void PathDisplay::update(float, float) {
  const PathSession& session = shared_path_session();
  if (!session.is_open()) return setStatus(rviz::StatusProperty::Ok, "Path", "none is in view");
  const auto frame = frame_in_view(*context_, session.frame());
  if (!frame)
    return setStatus(
        rviz::StatusProperty::Error, "Path",
        QString::fromStdString("frame '" + session.frame() + "' is not known to rviz"));
  scene_node_->setPosition(frame->position);
  scene_node_->setOrientation(frame->orientation);
  const auto edited =
      std::count_if(session.edited().origins.begin(), session.edited().origins.end(),
                    [](const auto& origin) { return origin.edited; });
  setStatus(rviz::StatusProperty::Ok, "Path",
            tr("%1 waypoints, %2 edited, %3 deleted")
                .arg(session.waypoints().size())
                .arg(edited)
                .arg(session.deleted().size()));
}

void PathDisplay::reset() {
  rviz::Display::reset();
  show();
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::PathDisplay, rviz::Display)
