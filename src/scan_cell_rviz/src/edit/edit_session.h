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

/// What to do with the points in a shape. The first two are edits; the others change only the view.
enum class EditAct { kDelete, kKeepOnly, kHide, kShowOnly };

using EditShape = decltype(cloud_preprocess::CloudEdit::shape);

/// How the next edit is made.
struct EditSettings {
  EditAct act = EditAct::kDelete;
  double depth = 0.05;   //!< [m] of a polygon, before and behind it
  double radius = 0.01;  //!< [m] of the brush
  double gap = 0.005;    //!< [m] largest gap within a cluster
};

/// What an automatic stage would remove from what the edits leave.
struct StageView {
  QString name;                                   //!< floor, outliers or isolate
  cloud_preprocess::EditedCloud::Indices points;  //!< indices in the source
  QString words;                                  //!< how many, what was found, or the error
};

/// The current state of a cloud under edit.
struct EditedView {
  std::shared_ptr<const cloud_preprocess::Cloud> source;  //!< [m]
  cloud_preprocess::EditedCloud::Indices kept;            //!< indices in `source`
  cloud_preprocess::EditedCloud::Indices shown;           //!< those of `kept` that are not hidden
  cloud_preprocess::EditedCloud::Indices last;            //!< taken by the last edit and in view
  QStringList edits;                                      //!< in force, in words
  QString yaml;                                           //!< the same edits as in settings files
  std::vector<StageView> stages;                          //!< empty: stages are not tried
  bool can_redo = false;
  std::string frame;
};
using EditedViewPtr = std::shared_ptr<const EditedView>;

/// A cloud that a person cleans by hand. A worker does the edits one after the other; each ends
/// with changed(), or with failed().
class EditSession : public QObject {
  Q_OBJECT

 public:
  EditSession();
  ~EditSession() override;

  /// Opens another cloud, without edits.
  void open(std::shared_ptr<const cloud_preprocess::Cloud> cloud, const std::string& frame);
  /// Applies the shape as set by the settings.
  void apply(const EditShape& shape);
  /// An edit also takes hidden points: run headless, where nothing is hidden, it does the same.
  void add(const cloud_preprocess::CloudEdit& edit);
  /// Hides those points in view that the edit would take. This is no edit and is not saved.
  void hide(const cloud_preprocess::CloudEdit& edit);
  void show_all();
  /// Shows from now on what the stages would remove. If calls come faster than they are computed,
  /// only the last one counts.
  /// @param parameters none: stop trying the stages
  void try_stages(const std::optional<cloud_preprocess::CleanParameters>& parameters);
  void undo();
  void redo();
  void drop_all();

  /// @return null: no cloud is open
  EditedViewPtr view() const;
  EditSettings settings() const;
  void set_settings(const EditSettings& settings);

  /// The visible point under the ray, in the cloud's frame.
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

  // Used by the worker, down to the frame.
  cloud_preprocess::EditedCloud edited_;
  std::vector<bool> hidden_;                                 // per point of the source
  std::optional<cloud_preprocess::CleanParameters> stages_;  // to be tried
  std::unique_ptr<cloud_preprocess::StageTrial> trial_;      // null: not for the present edits
  cloud_preprocess::EditedCloud::Indices trial_points_;      // indices of its points in the source
  std::vector<StageView> tried_;                             // by the last finished trial
  int asked_ = 0;                                            // number of trials requested
  std::shared_ptr<const cloud_preprocess::Cloud> source_;
  std::string frame_;
  mutable std::mutex mutex_;  // guards what follows
  EditedViewPtr view_;
  EditSettings settings_;
  Worker worker_;  // last: it uses all of the above
};

/// The session that the seat and rviz's tools share.
EditSession& shared_edit_session();

}  // namespace scan_cell_rviz
