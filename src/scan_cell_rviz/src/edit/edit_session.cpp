// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edit/edit_session.h"

namespace scan_cell_rviz {

using cloud_preprocess::Cloud;
using cloud_preprocess::CloudEdit;
using cloud_preprocess::EditedCloud;

namespace {

QString words_of(const CloudEdit& edit, std::size_t took) {
  const QString words = edit.keep ? EditSession::tr("keep only %1: %2 points went")
                                  : EditSession::tr("delete %1: %2 points went");
  return words.arg(cloud_preprocess::name_of(edit)).arg(took);
}

}  // namespace

EditSession::EditSession() = default;

EditSession::~EditSession() {
  worker_.reset();  // while there still is somebody whose signals it emits
}

template <class Change>
void EditSession::change(Change change) {
  worker_->add([this, change] {
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
    source_ = cloud;
    frame_ = frame;
    return true;
  });
}

void EditSession::add(const CloudEdit& edit) {
  change([this, edit] {
    if (!source_) return false;
    edited_.add(edit);
    return true;
  });
}

void EditSession::undo() {
  change([this] { return edited_.undo(); });
}

void EditSession::redo() {
  change([this] { return edited_.redo(); });
}

void EditSession::drop_all() {
  change([this] {
    bool any = false;
    while (edited_.undo())
      any = true;
    return any;
  });
}

void EditSession::show() {
  auto view = std::make_shared<EditedView>();
  view->source = source_;
  view->frame = frame_;
  view->kept = edited_.kept();
  const std::vector<CloudEdit>& edits = edited_.edits();
  const std::vector<std::size_t> counts = edited_.counts();
  for (std::size_t i = 0; i < edits.size(); ++i)
    view->edits.append(words_of(edits[i], counts[i]));
  if (!edits.empty()) {
    view->last = edited_.taken_by(edits.size() - 1);
    view->yaml = QString::fromStdString(cloud_preprocess::to_yaml(edits));
  }
  view->can_redo = !edited_.undone().empty();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    view_ = view;
  }
  Q_EMIT changed();
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
  return picked(*view->source, view->kept, ray);
}

EditSession& shared_edit_session() {
  static EditSession session;
  return session;
}

}  // namespace scan_cell_rviz
