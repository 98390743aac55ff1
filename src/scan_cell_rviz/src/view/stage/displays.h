// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <functional>

namespace rviz {
class Display;
class Property;
class VisualizationManager;
}  // namespace rviz

namespace scan_cell_rviz {

/// Displays that the seat creates if the settings of rviz have none.
namespace display_names {
constexpr const char* kBox = "box of the seat";
constexpr const char* kWaypoint = "waypoint of the seat";
constexpr const char* kPoses = "poses of the pass";
constexpr const char* kPasses = "passes of the scan";
constexpr const char* kDesignReference = "new path, reference";
constexpr const char* kDesignPicks = "new path, picks";
constexpr const char* kDesign = "new path";
}  // namespace display_names

/// Visits all displays, also those in groups.
void for_each_display(const rviz::VisualizationManager& manager,
                      const std::function<void(rviz::Display& display)>& look);

/// The existing display, or a new one, switched on.
/// @param type its class
/// @param name of a new one
/// @param any accepts a display of the type with any name
rviz::Display& display_of(rviz::VisualizationManager& manager, const QString& type,
                          const QString& name, bool any = false);

/// @return null: no such property
rviz::Property* property_of(const rviz::Property& owner, const QString& name);

}  // namespace scan_cell_rviz
