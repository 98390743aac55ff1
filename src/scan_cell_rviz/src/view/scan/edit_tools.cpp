// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pluginlib/class_list_macros.hpp>

#include "view/scan/edit_tool.h"

namespace scan_cell_rviz {

QString PolygonTool::help() const {
  return tr(
      "Polygon: click its corners, the first on the cloud; Return or a double click closes "
      "it, Escape starts again.");
}

void PolygonTool::press(const Ray& ray) {
  if (!place_) place_ = shared_edit_session().pick(ray);
  if (!place_) return setStatus(tr("No point is there. ") + help());
  corners_.push_back(ray);
  if (corners_.size() < kLeastCorners) return draw({*place_}, false);
  draw(prism_behind(corners_, *place_, shared_edit_session().settings().depth).corners, true);
}

void PolygonTool::finish() {
  if (!place_ || corners_.size() < kLeastCorners) return setStatus(help());
  edit(prism_behind(corners_, *place_, shared_edit_session().settings().depth));
}

void PolygonTool::begin_anew() {
  corners_.clear();
  place_.reset();
}

QString PlaneTool::help() const {
  return tr("Plane: click three points. The viewer's side is deleted, or alone is kept.");
}

void PlaneTool::press(const Ray& ray) {
  const auto place = shared_edit_session().pick(ray);
  if (!place) return setStatus(tr("No point is there. ") + help());
  places_.push_back(*place);
  draw(places_, false);
  constexpr std::size_t kThree = 3;
  if (places_.size() == kThree) edit(side_towards(places_, ray.origin));
}

void PlaneTool::begin_anew() {
  places_.clear();
}

QString BrushTool::help() const {
  return tr("Brush: hold the left button and go over the points.");
}

void BrushTool::press(const Ray& ray) {
  stroke_.radius = shared_edit_session().settings().radius;
  drag(ray);
}

void BrushTool::drag(const Ray& ray) {
  constexpr double kApart = 0.25;  // of the radius; chosen
  const auto place = shared_edit_session().pick(ray);
  if (!place) return;
  if (!stroke_.places.empty() && (*place - stroke_.places.back()).norm() < kApart * stroke_.radius)
    return;
  stroke_.places.push_back(*place);
  draw(stroke_.places, false);
}

void BrushTool::release() {
  if (!stroke_.places.empty()) edit(stroke_);
}

void BrushTool::begin_anew() {
  stroke_.places.clear();
}

QString ClusterTool::help() const {
  return tr("Cluster: click a point; everything connected to it is deleted, or alone is kept.");
}

void ClusterTool::press(const Ray& ray) {
  const auto place = shared_edit_session().pick(ray);
  if (!place) return setStatus(tr("No point is there. ") + help());
  cloud_preprocess::ClusterShape cluster;
  cluster.place = *place;
  cluster.gap = shared_edit_session().settings().gap;
  edit(cluster);
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::PolygonTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::PlaneTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::BrushTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::ClusterTool, rviz::Tool)
