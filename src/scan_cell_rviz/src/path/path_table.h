// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractTableModel>

#include "path/path_session.h"

namespace scan_cell_rviz {

/// Table model of the waypoints of the edited path; a row is made when it is shown.
class PathTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit PathTable(PathSession& session, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString text(std::size_t waypoint, int column) const;

  PathSession& session_;
};

}  // namespace scan_cell_rviz
