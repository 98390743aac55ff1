// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <mutex>
#include <optional>

#include "cloud_preprocess/edited_cloud.h"
#include "edit/picking.h"
#include "link/worker.h"

namespace scan_cell_rviz {

/// How the next edit is made.
struct EditSettings {
  bool keep = false;     //!< what is in the shape, alone; false: it is deleted
  double depth = 0.05;   //!< [m] before and behind, of a polygon
  double radius = 0.01;  //!< [m] of the brush
  double gap = 0.005;    //!< [m] that a cluster may have
};

/// A cloud under edit, as it stands.
struct EditedView {
  std::shared_ptr<const cloud_preprocess::Cloud> source;  //!< [m]
  cloud_preprocess::EditedCloud::Indices kept;            //!< points of it
  cloud_preprocess::EditedCloud::Indices last;            //!< that the last edit took
  QStringList edits;                                      //!< in force, in words
  QString yaml;                                           //!< the same, as settings have them
  bool can_redo = false;
  std::string frame;
};
using EditedViewPtr = std::shared_ptr<const EditedView>;

/// A cloud that a person cleans by hand. The work is done aside, one edit after the other; each
/// ends with changed(), or failed() where it could not be done.
class EditSession : public QObject {
  Q_OBJECT

 public:
  EditSession();
  ~EditSession() override;

  /// Another cloud, without edits.
  void open(std::shared_ptr<const cloud_preprocess::Cloud> cloud, const std::string& frame);
  void add(const cloud_preprocess::CloudEdit& edit);
  void undo();
  void redo();
  void drop_all();

  /// @return null: no cloud was opened
  EditedViewPtr view() const;
  EditSettings settings() const;
  void set_settings(const EditSettings& settings);

  /// The point of what is kept that a person sees there, in the cloud's frame.
  std::optional<Eigen::Vector3d> pick(const Ray& ray) const;

 Q_SIGNALS:
  void changed();
  void failed(QString message);

 private:
  template <class Change>
  void change(Change change);
  void show();

  cloud_preprocess::EditedCloud edited_;  // of the worker
  std::shared_ptr<const cloud_preprocess::Cloud> source_;
  std::string frame_;
  mutable std::mutex mutex_;  // of what follows
  EditedViewPtr view_;
  EditSettings settings_;
  std::unique_ptr<Worker> worker_ = std::make_unique<Worker>();
};

/// The one that the seat and the tools of rviz share.
EditSession& shared_edit_session();

}  // namespace scan_cell_rviz
