// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edit/edit_session.h"

#include <algorithm>
#include <utility>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_rviz {

using cloud_preprocess::CleanParameters;
using cloud_preprocess::Cloud;
using cloud_preprocess::CloudEdit;
using cloud_preprocess::EditedCloud;

namespace {

QString words_of(const CloudEdit& edit, std::size_t took, std::size_t unseen) {
  const QString words = edit.keep ? EditSession::tr("keep only %1: %2 points went")
                                  : EditSession::tr("delete %1: %2 points went");
  const QString hidden = unseen > 0 ? EditSession::tr(", %1 of them hidden").arg(unseen) : "";
  return words.arg(cloud_preprocess::name_of(edit)).arg(took) + hidden;
}

}  // namespace

EditSession::EditSession() = default;

EditSession::~EditSession() = default;

template <class Change>
void EditSession::change(Change change) {
  worker_.add([this, change] {
    try {
      if (!change()) return;
      show();
    } catch (const std::exception& error) {
      Q_EMIT failed(QString::fromStdString(error.what()));
    }
  });
}

void EditSession::open(std::shared_ptr<const Cloud> cloud, const std::string& frame) {
  change([this, cloud, frame] {
    edited_ = EditedCloud(*cloud);
    hidden_.assign(cloud->size(), false);
    trial_.reset();
    tried_.clear();
    source_ = cloud;
    frame_ = frame;
    return true;
  });
}

void EditSession::apply(const EditShape& shape) {
  const EditAct act = settings().act;
  const bool only = act == EditAct::kKeepOnly || act == EditAct::kShowOnly;
  const bool is_edit = act == EditAct::kDelete || act == EditAct::kKeepOnly;
  is_edit ? add({only, shape}) : hide({only, shape});
}

void EditSession::hide(const CloudEdit& edit) {
  change([this, edit] { return source_ && hide_now(edit); });
}

void EditSession::show_all() {
  change([this] {
    const bool any = any_hidden();
    hidden_.assign(hidden_.size(), false);
    return any;
  });
}

bool EditSession::any_hidden() const {
  return std::find(hidden_.begin(), hidden_.end(), true) != hidden_.end();
}

EditedCloud::Indices EditSession::in_view(EditedCloud::Indices points) const {
  points.erase(
      std::remove_if(points.begin(), points.end(), [this](std::uint32_t i) { return hidden_[i]; }),
      points.end());
  return points;
}

Cloud EditSession::of_source(const EditedCloud::Indices& points) const {
  Cloud cloud;
  cloud.reserve(points.size());
  for (const std::uint32_t i : points)
    cloud.push_back((*source_)[i]);
  return cloud;
}

/// Uses only the points in view, so that hidden points do not connect a cluster.
bool EditSession::hide_now(const CloudEdit& edit) {
  const EditedCloud::Indices points = in_view(edited_.kept());
  const EditedCloud::Indices taken = EditedCloud(of_source(points)).would_take(edit);
  if (taken.size() == points.size())
    throw scan_cell_common::UnusableInput("hiding", "would leave nothing in view",
                                          "choose another shape");
  for (const std::uint32_t i : taken)
    hidden_[points[i]] = true;
  return true;
}

void EditSession::add(const CloudEdit& edit) {
  change([this, edit] {
    if (!source_) return false;
    edited_.add(edit);
    trial_.reset();
    return true;
  });
}

void EditSession::undo() {
  change([this] {
    trial_.reset();
    return edited_.undo();
  });
}

void EditSession::redo() {
  change([this] {
    trial_.reset();
    return edited_.redo();
  });
}

void EditSession::drop_all() {
  change([this] {
    bool any = false;
    while (edited_.undo())
      any = true;
    trial_.reset();
    return any;
  });
}

/// The stages are tried afterwards, so that an edit is shown without waiting for them.
void EditSession::show() {
  publish();
  queue_trial();
}

void EditSession::publish() {
  auto view = std::make_shared<EditedView>();
  view->source = source_;
  view->frame = frame_;
  view->kept = edited_.kept();
  view->shown = in_view(view->kept);
  const std::vector<CloudEdit>& edits = edited_.edits();
  const std::vector<std::size_t> counts = edited_.counts();
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const std::size_t unseen = any_hidden() ? counts[i] - in_view(edited_.taken_by(i)).size() : 0;
    view->edits.append(words_of(edits[i], counts[i], unseen));
  }
  if (!edits.empty()) {
    view->last = in_view(edited_.taken_by(edits.size() - 1));
    view->yaml = QString::fromStdString(cloud_preprocess::to_yaml(edits));
  }
  view->stages = tried_;
  view->can_redo = !edited_.undone().empty();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    view_ = view;
  }
  Q_EMIT changed();
}

void EditSession::try_stages(const std::optional<CleanParameters>& parameters) {
  worker_.add([this, parameters] {
    stages_ = parameters;
    if (stages_) return queue_trial();
    trial_.reset();
    tried_.clear();
    if (source_) publish();
  });
}

/// Queues a trial; only the last one queued counts.
void EditSession::queue_trial() {
  if (!stages_ || !source_) return;
  worker_.add([this, number = ++asked_] {
    if (number != asked_ || !stages_) return;
    try {
      try_now();
      publish();
    } catch (const std::exception& error) {
      Q_EMIT failed(QString::fromStdString(error.what()));
    }
  });
}

void EditSession::try_now() {
  if (!trial_) {
    trial_points_ = edited_.kept();
    trial_ = std::make_unique<cloud_preprocess::StageTrial>(of_source(trial_points_));
  }
  tried_.clear();
  for (const cloud_preprocess::StageTaking& taking : trial_->run(*stages_)) {
    StageView& view = tried_.emplace_back();
    view.name = QString::fromStdString(taking.report.stage);
    for (const std::uint32_t i : taking.points)
      view.points.push_back(trial_points_[i]);
    view.words = taking.error.empty() ? tr("%1: %2 points would go; %3")
                                            .arg(view.name)
                                            .arg(taking.points.size())
                                            .arg(QString::fromStdString(taking.report.message))
                                      : QString::fromStdString(taking.error);
  }
}

EditedViewPtr EditSession::view() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return view_;
}

EditSettings EditSession::settings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return settings_;
}

void EditSession::set_settings(const EditSettings& settings) {
  const std::lock_guard<std::mutex> lock(mutex_);
  settings_ = settings;
}

std::optional<Eigen::Vector3d> EditSession::pick(const Ray& ray) const {
  const EditedViewPtr view = this->view();
  if (!view) return std::nullopt;
  return picked(*view->source, view->shown, ray);
}

EditSession& shared_edit_session() {
  static EditSession session;
  return session;
}

}  // namespace scan_cell_rviz
