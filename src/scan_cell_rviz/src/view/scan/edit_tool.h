// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/tool.h>

#include <memory>
#include <optional>
#include <vector>

#include "edit/edit_session.h"

namespace scan_cell_rviz {

/// A tool that edits the cloud in view with the left button; the other buttons move the view as
/// usual. Escape starts over.
class EditTool : public rviz::Tool {
  Q_OBJECT

 public:
  void activate() override;
  void deactivate() override;
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;
  int processKeyEvent(QKeyEvent* event, rviz::RenderPanel* panel) override;

 protected:
  void onInitialize() override;

  virtual QString help() const = 0;  ///< what to do, for the status line
  virtual void press(const Ray& ray) = 0;
  virtual void drag(const Ray&) {}
  virtual void release() {}
  virtual void finish() {}  ///< Return or a double click
  virtual void begin_anew() = 0;

  /// Draws lines between places in the cloud's frame.
  void draw(const std::vector<Eigen::Vector3d>& places, bool closed);
  /// Deletes, keeps, hides ... as set on the page.
  void edit(const EditShape& shape);

 private:
  template <typename Act>  // lupdate would take `class Act` for a class
  void attempt(const Act& act);
  std::optional<Ray> ray_of(const rviz::ViewportMouseEvent& event);

  std::unique_ptr<rviz::BillboardLine> line_;
};

/// Clicks set the corners; Return or a double click closes the polygon.
class PolygonTool : public EditTool {
  Q_OBJECT

 public:
  PolygonTool() { shortcut_key_ = 'p'; }

 private:
  QString help() const override;
  void press(const Ray& ray) override;
  void finish() override;
  void begin_anew() override;

  static constexpr std::size_t kLeastCorners = 3;

  std::vector<Ray> corners_;
  std::optional<Eigen::Vector3d> place_;  // gives the depth
};

/// Three clicks on the cloud.
class PlaneTool : public EditTool {
  Q_OBJECT

 public:
  PlaneTool() { shortcut_key_ = 'l'; }

 private:
  QString help() const override;
  void press(const Ray& ray) override;
  void begin_anew() override;

  std::vector<Eigen::Vector3d> places_;
};

/// Takes points while the button is held.
class BrushTool : public EditTool {
  Q_OBJECT

 public:
  BrushTool() { shortcut_key_ = 'b'; }

 private:
  QString help() const override;
  void press(const Ray& ray) override;
  void drag(const Ray& ray) override;
  void release() override;
  void begin_anew() override;

  cloud_preprocess::BrushShape stroke_;
};

/// One click.
class ClusterTool : public EditTool {
  Q_OBJECT

 public:
  ClusterTool() { shortcut_key_ = 'u'; }

 private:
  QString help() const override;
  void press(const Ray& ray) override;
  void begin_anew() override {}
};

}  // namespace scan_cell_rviz
