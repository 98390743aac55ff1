// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "edit/edit_session.h"
#include "view/handle_server.h"

namespace scan_cell_rviz {

/// A box in the view that a person moves, turns and resizes by its faces: an interactive marker on
/// the topic ~box of this node. rviz serves its callbacks.
class BoxHandles : public QObject {
  Q_OBJECT

 public:
  explicit BoxHandles(EditSession& session);

  /// Puts a box in the middle of the scan in view; does nothing without a scan.
  void show();
  void hide();
  bool shown() const { return !frame_.empty(); }
  const std::string& topic() const { return server_.topic(); }  //!< of the interactive markers

  /// Deletes the points in the box, or all others, as set on the page.
  void apply();

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void draw();
  void on_box(const Feedback& feedback);
  void on_face(int face, const Feedback& feedback);

  EditSession& session_;
  std::string frame_;  // of the scan; empty: no box is shown
  cloud_preprocess::BoxShape box_;
  HandleServer server_;
};

}  // namespace scan_cell_rviz
