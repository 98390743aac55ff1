// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/stage/displays.h"

#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/visualization_manager.h>

namespace scan_cell_rviz {
namespace {

void look_at_group(rviz::DisplayGroup& group,
                   const std::function<void(rviz::Display& display)>& look) {
  for (int i = 0; i < group.numDisplays(); ++i) {
    look(*group.getDisplayAt(i));
    if (rviz::DisplayGroup* const inner = group.getGroupAt(i)) look_at_group(*inner, look);
  }
}

}  // namespace

void for_each_display(const rviz::VisualizationManager& manager,
                      const std::function<void(rviz::Display& display)>& look) {
  look_at_group(*manager.getRootDisplayGroup(), look);
}

rviz::Display& display_of(rviz::VisualizationManager& manager, const QString& type,
                          const QString& name, bool any) {
  rviz::Display* found = nullptr;
  for_each_display(manager, [&](rviz::Display& display) {
    const bool is_it = display.getClassId() == type && (any || display.getName() == name);
    if (is_it && found == nullptr) found = &display;
  });
  return found != nullptr ? *found : *manager.createDisplay(type, name, true);
}

rviz::Property* property_of(const rviz::Property& owner, const QString& name) {
  for (int i = 0; i < owner.numChildren(); ++i)
    if (owner.childAt(i)->getName() == name) return owner.childAt(i);
  return nullptr;
}

}  // namespace scan_cell_rviz
