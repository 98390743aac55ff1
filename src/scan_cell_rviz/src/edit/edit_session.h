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
#include "cloud_preprocess/stage_trial.h"
#include "edit/picking.h"
#include "link/worker.h"

namespace scan_cell_rviz {

/// What is done with the points in a shape. The first two are edits; the others only change what is
/// in view.
enum class EditAct { kDelete, kKeepOnly, kHide, kShowOnly };

using EditShape = decltype(cloud_preprocess::CloudEdit::shape);

/// How the next edit is made.
struct EditSettings {
  EditAct act = EditAct::kDelete;
  double depth = 0.05;   //!< [m] before and behind, of a polygon
  double radius = 0.01;  //!< [m] of the brush
  double gap = 0.005;    //!< [m] that a cluster may have
};

/// What an automatic stage would take of what the edits leave.
struct StageView {
  QString name;                                   //!< floor, outliers or isolate
  cloud_preprocess::EditedCloud::Indices points;  //!< of the source
  QString words;                                  //!< how many, and what was found, or why not
};

/// A cloud under edit, as it stands.
struct EditedView {
  std::shared_ptr<const cloud_preprocess::Cloud> source;  //!< [m]
  cloud_preprocess::EditedCloud::Indices kept;            //!< points of it
  cloud_preprocess::EditedCloud::Indices shown;           //!< those of them that are not hidden
  cloud_preprocess::EditedCloud::Indices last;  //!< that the last edit took, those in view
  QStringList edits;                            //!< in force, in words
  QString yaml;                                 //!< the same, as settings have them
  std::vector<StageView> stages;                //!< none: they are not tried
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
  /// Does with the shape what the settings say.
  void apply(const EditShape& shape);
  /// An edit takes hidden points, too: it does the same headless, where nothing is hidden.
  void add(const cloud_preprocess::CloudEdit& edit);
  /// Takes out of view what the edit would take of what is in view. No edit, and not saved.
  void hide(const cloud_preprocess::CloudEdit& edit);
  void show_all();
  /// Shows from here on what the stages would take. Of calls that come faster than it can be
  /// computed only the last one counts.
  /// @param parameters none: they are no longer tried
  void try_stages(const std::optional<cloud_preprocess::CleanParameters>& parameters);
  void undo();
  void redo();
  void drop_all();

  /// @return null: no cloud was opened
  EditedViewPtr view() const;
  EditSettings settings() const;
  void set_settings(const EditSettings& settings);

  /// The point that a person sees there, in the cloud's frame.
  std::optional<Eigen::Vector3d> pick(const Ray& ray) const;

 Q_SIGNALS:
  void changed();
  void failed(QString message);

 private:
  template <class Change>
  void change(Change change);
  void show();
  void publish();
  void queue_trial();
  void try_now();
  cloud_preprocess::EditedCloud::Indices in_view(
      cloud_preprocess::EditedCloud::Indices points) const;
  cloud_preprocess::Cloud of_source(const cloud_preprocess::EditedCloud::Indices& points) const;
  bool any_hidden() const;
  bool hide_now(const cloud_preprocess::CloudEdit& edit);

  // Of the worker, up to the frame.
  cloud_preprocess::EditedCloud edited_;
  std::vector<bool> hidden_;                                 // by point of the source
  std::optional<cloud_preprocess::CleanParameters> stages_;  // that are tried
  std::unique_ptr<cloud_preprocess::StageTrial> trial_;      // null: not of the present edits
  cloud_preprocess::EditedCloud::Indices trial_points_;      // its points, of the source
  std::vector<StageView> tried_;                             // by the last trial that was done
  int asked_ = 0;                                            // trials that were to be done
  std::shared_ptr<const cloud_preprocess::Cloud> source_;
  std::string frame_;
  mutable std::mutex mutex_;  // of what follows
  EditedViewPtr view_;
  EditSettings settings_;
  Worker worker_;  // last: it uses all of the above
};

/// The one that the seat and the tools of rviz share.
EditSession& shared_edit_session();

}  // namespace scan_cell_rviz
