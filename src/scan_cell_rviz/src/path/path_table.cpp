// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/path_table.h"

#include <array>
#include <cmath>

#include "scan_cell_common/pose/units.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_common::kMillimetres;

enum Column { kSegment, kMark, kX, kY, kZ, kExpected, kFirstValue };

}  // namespace

PathTable::PathTable(PathSession& session, QObject* parent)
    : QAbstractTableModel(parent), session_(session) {
  connect(&session_, &PathSession::changed, this, [this] {
    beginResetModel();
    endResetModel();
  });
}

int PathTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(session_.waypoints().size());
}

int PathTable::columnCount(const QModelIndex& parent) const {
  if (parent.isValid()) return 0;
  return kFirstValue + static_cast<int>(session_.edited().path.process_names.size());
}

QString PathTable::text(std::size_t waypoint, int column) const {
  const tool_paths::Waypoint& shown = session_.waypoints()[waypoint];
  switch (column) {
    case kSegment:
      return session_.segment_of(waypoint);
    case kMark: {
      const tool_paths::WaypointOrigin& origin = session_.edited().origins[waypoint];
      if (origin.added) return tr("added");
      return origin.edited ? tr("edited") : QString();
    }
    case kX:
    case kY:
    case kZ:
      return QString::number(shown.pose.translation()[column - kX] * kMillimetres, 'f', 2);
    case kExpected: {
      const double expected = session_.expected_of(waypoint);
      return std::isnan(expected) ? tr("not known")
                                  : QString::number(expected * kMillimetres, 'f', 3);
    }
    default:
      return QString::number(shown.process_values[static_cast<std::size_t>(column - kFirstValue)]);
  }
}

QVariant PathTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || role != Qt::DisplayRole) return {};
  return text(static_cast<std::size_t>(index.row()), index.column());
}

QVariant PathTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section;  // from 0, as in reports
  if (section >= kFirstValue)
    return QString::fromStdString(
        session_.edited().path.process_names[static_cast<std::size_t>(section - kFirstValue)]);
  const std::array<QString, kFirstValue> names = {tr("Segment"), tr("By hand"), tr("x [mm]"),
                                                  tr("y [mm]"),  tr("z [mm]"),  tr("Off by [mm]")};
  return names.at(static_cast<std::size_t>(section));
}

}  // namespace scan_cell_rviz
