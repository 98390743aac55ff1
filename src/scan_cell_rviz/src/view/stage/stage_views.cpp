// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/stage/stage_views.h"

#include <OgreCamera.h>
#include <OgreQuaternion.h>
#include <OgreVector3.h>
#include <rviz/display.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <rviz/yaml_config_writer.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "view/cloud_frame.h"
#include "view/stage/displays.h"

namespace scan_cell_rviz {
namespace {

constexpr const char* kGrowing = "growing cloud";

/// A display of the cell's settings or of the seat, by name, or of this package, by class.
struct Known {
  const char* display;
  std::vector<Page> pages;     // where it is shown; on the first page rviz's settings apply
  const char* part = nullptr;  // property switched instead of the display, which takes long to load
};

const std::vector<Known>& known() {
  using namespace display_names;  // NOLINT
  static const std::vector<Known> all = {
      {"board", {Page::kTeach}},
      {"robot", {Page::kWork, Page::kTeach, Page::kPasses}, "Visual Enabled"},
      {"frames", {Page::kTeach}},
      {"sheets of light", {Page::kTeach, Page::kPasses}},
      {kGrowing, {}},
      {"clean cloud", {}},
      {"reference", {}},
      {"object", {}},
      {"reference as mapped onto the object", {}},
      {"path on the reference", {}},
      {"adapted path", {}},
      {"correspondences, expected errors, refused waypoints", {}},
      {"run, object by its deviation", {Page::kFit, Page::kPath, Page::kWork, Page::kHistory}},
      {"run, proven path where the part lies", {Page::kFit, Page::kHistory}},
      {"run, adapted path", {Page::kFit, Page::kPath, Page::kHistory}},
      {"run, waypoints that the verdict is about", {Page::kFit, Page::kPath, Page::kHistory}},
      {"run, how far off the adapted path may be, tool", {Page::kFit, Page::kHistory}},
      {"run, verdict and scale of the deviations", {Page::kFit, Page::kHistory}},
      {"run, waypoints that the scan could not see", {Page::kFit, Page::kHistory}},
      {"scan_cell_rviz/EditedScan", {Page::kClean}},
      {"scan_cell_rviz/WorkPreview", {Page::kWork}},
      {"scan_cell_rviz/EditedPath", {Page::kPath}},
      {kBox, {Page::kClean}},
      {kWaypoint, {Page::kPath}},
      {kPoses, {Page::kPasses}},
      {kPasses, {Page::kPasses}},
      {kDesignReference, {Page::kDesign}},
      {kDesignPicks, {Page::kDesign}},
      {kDesign, {Page::kDesign}}};
  return all;
}

/// @return null: a person's own display
const Known* known_of(const QString& name) {
  const auto found = std::find_if(known().begin(), known().end(),
                                  [&name](const Known& each) { return name == each.display; });
  return found == known().end() ? nullptr : &*found;
}

bool is_of(const Known& display, Page page) {
  return std::find(display.pages.begin(), display.pages.end(), page) != display.pages.end();
}

QString written(const rviz::ViewController& view) {
  rviz::Config config;
  view.save(config);
  return rviz::YamlConfigWriter().writeString(config);
}

void load_view(rviz::VisualizationManager& manager, const rviz::Config& view) {
  QString type;
  if (!view.mapGetString("Class", &type)) return;
  rviz::ViewManager& views = *manager.getViewManager();
  if (views.getCurrent()->getClassId() != type) views.setCurrentViewControllerType(type);
  views.getCurrent()->load(view);
}

}  // namespace

/// Displays of this package are identified by class: there is one of each. Of displays with the
/// same name, all but the first get a number.
void StageViews::for_each_switch(
    const std::function<void(const QString& name, rviz::Property& shown)>& look) const {
  QMap<QString, int> times;
  for_each_display(manager_, [&](rviz::Display& display) {
    const bool is_ours = known_of(display.getClassId()) != nullptr;
    QString name = is_ours ? display.getClassId() : display.getName();
    const Known* const known = known_of(name);
    if (const int before = times[name]++; before > 0) name += QString(" #%1").arg(before + 1);
    rviz::Property* const part =
        known != nullptr && known->part != nullptr ? property_of(display, known->part) : nullptr;
    look(name, part != nullptr ? *part : display);
  });
}

QStringList StageViews::known_displays() {
  QStringList names;
  for (const Known& each : known())
    if (!QString(each.display).startsWith("scan_cell_rviz/")) names.append(each.display);
  return names;
}

void StageViews::show(Page page, bool scanning) {
  if (page_ == page) return;
  const bool is_first = !page_;
  if (page_) stages_[*page_] = seen();
  page_ = page;
  scanning_ = scanning;
  const bool was_left = stages_.contains(page);
  if (was_left || !is_first) restore(stages_.value(page));
  if (!was_left && page == Page::kTeach) load_view(manager_, stages_.value(Page::kPart).view);
  has_view_ = stages_.value(page).has_view;
  view_when_came_ = written(*manager_.getViewManager()->getCurrent());
}

bool StageViews::has_view() const {
  return has_view_ || written(*manager_.getViewManager()->getCurrent()) != view_when_came_;
}

StageViews::Stage StageViews::seen() const {
  Stage stage;
  for_each_switch([&](const QString& name, const rviz::Property& shown) {
    if (!scanning_ || name != kGrowing) stage.shown[name] = shown.getValue().toBool();
  });
  manager_.getViewManager()->getCurrent()->save(stage.view);
  stage.has_view = has_view();
  return stage;
}

/// Displays that did not exist when a person left the page are shown if they belong to it.
void StageViews::restore(const Stage& stage) {
  for_each_switch([&](const QString& name, rviz::Property& shown) {
    if (scanning_ && name == kGrowing) return;
    const Known* const display = known_of(name);
    if (stage.shown.contains(name))
      shown.setValue(stage.shown[name]);
    else if (display != nullptr)
      shown.setValue(is_of(*display, *page_));
  });
  load_view(manager_, stage.view);
}

bool StageViews::fit(const PlaceInView& place) {
  const auto pose = frame_in_view(manager_, place.frame.toStdString());
  if (!pose) return false;
  constexpr double kNearest = 0.02;  // [m] radius of a place: a path may be one point; chosen
  const double radius = std::max(place.radius, kNearest);
  rviz::ViewController& view = *manager_.getViewManager()->getCurrent();
  rviz::Property* const distance =
      property_of(view, "Distance");  // of a view that turns about a point
  const QVariant yaw = distance != nullptr ? view.subProp("Yaw")->getValue() : QVariant();
  const QVariant pitch = distance != nullptr ? view.subProp("Pitch")->getValue() : QVariant();
  view.lookAt(pose->position + pose->orientation * to_ogre(place.middle));  // keeps the direction
  const rviz::RenderPanel& panel = *manager_.getRenderPanel();
  const int width = std::max(1, panel.width()), height = std::max(1, panel.height());
  if (distance != nullptr) {
    view.subProp("Yaw")->setValue(yaw);
    view.subProp("Pitch")->setValue(pitch);
    const double half_height = view.getCamera()->getFOVy().valueRadians() / 2;
    const double narrower = std::min(1.0, static_cast<double>(width) / height);
    distance->setValue(radius / std::sin(std::atan(narrower * std::tan(half_height))));
  }
  if (rviz::Property* const scale = property_of(view, "Scale"))  // [pixels/m]
    scale->setValue(std::min(width, height) / (2 * radius));
  has_view_ = true;
  return true;
}

void StageViews::load(const rviz::Config& config) {
  stages_.clear();
  page_.reset();
  for (int i = 0; i < config.listLength(); ++i) {
    const rviz::Config kept = config.listChildAt(i);
    int page = 0;
    if (!kept.mapGetInt("Page", &page) || page < 0 || page > static_cast<int>(Page::kPasses))
      continue;
    Stage& stage = stages_[static_cast<Page>(page)];
    kept.mapGetBool("Chosen", &stage.has_view);
    const rviz::Config shown = kept.mapGetChild("Displays");
    for (auto each = shown.mapIterator(); each.isValid(); each.advance())
      stage.shown[each.currentKey()] = each.currentChild().getValue().toBool();
    stage.view.copy(kept.mapGetChild("View"));
  }
}

void StageViews::save(rviz::Config config) const {
  QMap<Page, Stage> all = stages_;
  if (page_) all[*page_] = seen();
  for (auto each = all.begin(); each != all.end(); ++each) {
    rviz::Config kept = config.listAppendNew();
    kept.mapSetValue("Page", static_cast<int>(each.key()));
    kept.mapSetValue("Chosen", each->has_view);
    rviz::Config shown = kept.mapMakeChild("Displays");
    for (auto display = each->shown.begin(); display != each->shown.end(); ++display)
      shown.mapSetValue(display.key(), display.value());
    kept.mapMakeChild("View").copy(each->view);
  }
}

}  // namespace scan_cell_rviz
