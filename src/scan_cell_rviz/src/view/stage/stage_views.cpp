// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/stage/stage_views.h"

#include <OgreQuaternion.h>
#include <OgreVector3.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/frame_manager.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "view/cloud_frame.h"

namespace scan_cell_rviz {
namespace {

/// A display of the cell's settings by its name, or of this package by its class.
struct Known {
  const char* display;
  std::vector<Page> pages;  // whose it is; on the first one rviz's own settings hold
};

const std::array<Known, 22> kKnown = {{
    {"board", {Page::kTeach}},
    {"robot", {Page::kWork, Page::kTeach, Page::kPasses}},
    {"frames", {Page::kTeach}},
    {"sheets of light", {Page::kTeach, Page::kPasses}},
    {"growing cloud", {}},
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
}};

void for_each_display(rviz::DisplayGroup& group,
                      const std::function<void(rviz::Display& display)>& look) {
  for (int i = 0; i < group.numDisplays(); ++i) {
    look(*group.getDisplayAt(i));
    if (rviz::DisplayGroup* const inner = group.getGroupAt(i)) for_each_display(*inner, look);
  }
}

/// Null: it has none.
rviz::Property* property_of(const rviz::Property& owner, const QString& name) {
  for (int i = 0; i < owner.numChildren(); ++i)
    if (owner.childAt(i)->getName() == name) return owner.childAt(i);
  return nullptr;
}

}  // namespace

void StageViews::show(Page page) {
  if (page_ == page) return;
  if (page_) stages_[*page_] = seen();
  const bool is_first = !page_;
  page_ = page;
  has_view_ = is_first || stages_.contains(page);
  if (stages_.contains(page)) return restore(stages_[page]);
  if (!is_first) show_first(page);
}

StageViews::Stage StageViews::seen() const {
  Stage stage;
  for_each_display(*manager_.getRootDisplayGroup(), [&stage](const rviz::Display& display) {
    stage.enabled[display.getName()] = display.isEnabled();
  });
  manager_.getViewManager()->getCurrent()->save(stage.view);
  return stage;
}

void StageViews::restore(const Stage& stage) {
  for_each_display(*manager_.getRootDisplayGroup(), [&stage](rviz::Display& display) {
    const auto kept = stage.enabled.find(display.getName());
    if (kept != stage.enabled.end()) display.setEnabled(*kept);
  });
  rviz::ViewManager& views = *manager_.getViewManager();
  QString type;
  if (!stage.view.mapGetString("Class", &type)) return;
  if (views.getCurrent()->getClassId() != type) views.setCurrentViewControllerType(type);
  views.getCurrent()->load(stage.view);
}

void StageViews::show_first(Page page) {
  for_each_display(*manager_.getRootDisplayGroup(), [page](rviz::Display& display) {
    const auto known = std::find_if(kKnown.begin(), kKnown.end(), [&display](const Known& each) {
      return display.getName() == each.display || display.getClassId() == each.display;
    });
    if (known == kKnown.end()) return;
    const std::vector<Page>& pages = known->pages;
    display.setEnabled(std::find(pages.begin(), pages.end(), page) != pages.end());
  });
}

bool StageViews::fit(const PlaceInView& place) {
  const auto pose = frame_in_view(manager_, place.frame.toStdString());
  if (!pose) return false;
  rviz::ViewController& view = *manager_.getViewManager()->getCurrent();
  std::array<std::pair<rviz::Property*, QVariant>, 2> kept;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i].first = property_of(view, i == 0 ? "Yaw" : "Pitch");
    if (kept[i].first != nullptr) kept[i].second = kept[i].first->getValue();
  }
  view.lookAt(pose->position + pose->orientation * to_ogre(place.middle));  // from where it was
  for (const auto& [property, value] : kept)
    if (property != nullptr) property->setValue(value);
  const rviz::RenderPanel& panel = *manager_.getRenderPanel();
  const double narrower = std::min(1.0, static_cast<double>(panel.width()) / panel.height());
  constexpr double kHalfHeight = M_PI / 8;  // [rad] that the camera sees; Ogre's default
  const double half_sight = std::atan(narrower * std::tan(kHalfHeight));
  if (rviz::Property* const distance = property_of(view, "Distance"))
    distance->setValue(place.radius / std::sin(half_sight));
  if (rviz::Property* const scale = property_of(view, "Scale"))  // [pixels/m]
    scale->setValue(std::min(panel.width(), panel.height()) / (2 * place.radius));
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
    const rviz::Config enabled = kept.mapGetChild("Displays");
    for (auto each = enabled.mapIterator(); each.isValid(); each.advance())
      stage.enabled[each.currentKey()] = each.currentChild().getValue().toBool();
    stage.view.copy(kept.mapGetChild("View"));
  }
}

void StageViews::save(rviz::Config config) const {
  QMap<Page, Stage> all = stages_;
  if (page_) all[*page_] = seen();
  for (auto each = all.begin(); each != all.end(); ++each) {
    rviz::Config kept = config.listAppendNew();
    kept.mapSetValue("Page", static_cast<int>(each.key()));
    rviz::Config enabled = kept.mapMakeChild("Displays");
    for (auto display = each->enabled.begin(); display != each->enabled.end(); ++display)
      enabled.mapSetValue(display.key(), display.value());
    kept.mapMakeChild("View").copy(each->view);
  }
}

}  // namespace scan_cell_rviz
