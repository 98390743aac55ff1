// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/shift/work_page.h"

#include <QHBoxLayout>
#include <QMessageBox>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "preview/preview_view.h"
#include "widgets/labels_and_buttons.h"

namespace scan_cell_rviz {

using scan_cell_msgs::RunSummary;

WorkPage::WorkPage(QWidget* parent)
    : QWidget(parent),
      part_(text_label("work_part", this)),
      end_(text_label("work_end", this)),
      preview_(new QPushButton(tr("Pre&view"), this)),
      preview_dry_(new QPushButton(tr("Preview the dr&y run"), this)),
      pose_(new QSlider(Qt::Horizontal, this)),
      at_pose_(text_label("at_pose", this)),
      turn_(text_label("most_turned", this)),
      faults_(new QListWidget(this)),
      dry_(new QPushButton(tr("&Dry run"), this)),
      work_(new QPushButton(tr("&Work"), this)) {
  dry_->setObjectName("dry_run");
  dry_->setToolTip(tr("Moves the robot along the path: lifted, slow, with the tool off"));
  work_->setObjectName("work");
  work_->setToolTip(
      tr("Moves the robot along the path with the tool on. The cell refuses it until "
         "the path was run dry once."));
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(part_);
  layout->addWidget(dry_);
  layout->addWidget(work_);
  layout->addLayout(preview_box());  // no button below: the text may have any length
  layout->addWidget(end_);
  layout->addStretch();
  for (QPushButton* const button : {dry_, work_}) {
    connect(button, &QPushButton::clicked, this, [this, button] {
      if (button == work_ && !may_work_again()) return;
      end_->clear();  // from the last time
      Q_EMIT workWanted(QString::fromStdString(run_.id), button == dry_);
    });
  }
  show_run({});
}

QLayout* WorkPage::preview_box() {
  preview_->setObjectName("preview");
  preview_->setToolTip(
      tr("Moves nothing: shows the way, the robot at each of its poses, and where "
         "it cannot follow"));
  preview_dry_->setObjectName("preview_dry");
  preview_dry_->setToolTip(tr("The same for the dry run"));
  pose_->setObjectName("pose");
  pose_->setAccessibleName(tr("Pose of the preview"));
  pose_->setToolTip(tr("Pose of the tool's tip at which the robot's ghost stands"));
  faults_->setObjectName("faults");
  faults_->setAccessibleName(tr("What the robot cannot do"));
  faults_->setToolTip(tr("Where the robot cannot follow: the view turns there"));
  auto* const buttons = new QHBoxLayout;
  for (QPushButton* const button : {preview_, preview_dry_}) {
    buttons->addWidget(button);
    connect(button, &QPushButton::clicked, this,
            [this, button] { ask_for_preview(button == preview_dry_); });
  }
  connect(pose_, &QSlider::valueChanged, this, [this](int pose) {
    show_pose(pose);
    Q_EMIT poseChosen(pose);
  });
  connect(faults_, &QListWidget::currentRowChanged, this, &WorkPage::show_fault);
  auto* const box = new QVBoxLayout;
  box->addLayout(buttons);
  box->addWidget(pose_);
  box->addWidget(at_pose_);
  box->addWidget(turn_);
  box->addWidget(faults_);
  pose_->setEnabled(false);
  faults_->hide();
  return box;
}

void WorkPage::ask_for_preview(bool dry) {
  forget_preview();
  asked_ = true;
  update_buttons();
  Q_EMIT previewWanted(QString::fromStdString(run_.id), dry);
}

void WorkPage::forget_preview() {
  shown_.reset();
  pose_->setEnabled(false);
  at_pose_->clear();
  turn_->clear();
  faults_->clear();
  faults_->hide();
}

void WorkPage::give_up_preview() {
  asked_ = false;
  update_buttons();
}

void WorkPage::show_preview(const scan_cell_msgs::WorkPreviewConstPtr& preview) {
  came_ = preview;
  if (run_.id.empty() || !is_of_run(*preview, QString::fromStdString(run_.id))) return;
  forget_preview();
  shown_ = preview;
  const int before = pose_->value();
  {
    const QSignalBlocker nobody_chose_it(pose_);
    pose_->setMaximum(std::max(0, static_cast<int>(preview->waypoints.size()) - 1));
  }
  pose_->setEnabled(!preview->waypoints.empty());
  for (const auto& fault : preview->faults)
    faults_->addItem(QString::fromStdString(fault.message));
  faults_->setVisible(!preview->faults.empty());
  show_pose(pose_->value());
  show_turn();
  const bool was_asked = std::exchange(asked_, false);
  if (was_asked || pose_->value() != before) Q_EMIT poseChosen(pose_->value());
  update_buttons();
}

void WorkPage::set_limits(const RobotLimits& limits) {
  limits_ = limits;
  show_turn();
}

void WorkPage::show_turn() {
  const auto turn = shown_ ? most_turned(*shown_) : std::nullopt;
  turn_->setText(turn ? text_of(*turn, limits_) : QString());
}

void WorkPage::show_pose(int pose) {
  if (!shown_) return;
  const QString can = shown_->faults.empty() ? tr("The robot can follow the whole way.")
                                             : tr("The robot cannot follow it: %n fault(s).",
                                                  nullptr, static_cast<int>(shown_->faults.size()));
  at_pose_->setText((shown_->dry_run != 0 ? tr("Dry run. ") : tr("Work. ")) + can + "\n" +
                    text_at(*shown_, static_cast<std::size_t>(pose)));
}

/// Moves the ghost to the fault's waypoint, and the view to its exact place.
void WorkPage::show_fault(int row) {
  if (!shown_ || row < 0 || row >= static_cast<int>(shown_->faults.size())) return;
  const auto& fault = shown_->faults[static_cast<std::size_t>(row)];
  pose_->setValue(static_cast<int>(fault.waypoint));
  const auto& place = fault.tip.position;
  Q_EMIT placeChosen(place.x, place.y, place.z, QString::fromStdString(shown_->header.frame_id));
}

/// Asks first: a part that was worked before may not stand it twice.
bool WorkPage::may_work_again() {
  if (works_ == 0) return true;
  return QMessageBox::question(this, tr("Work it again?"),
                               tr("The part of this run was worked already (%1).").arg(works_) +
                                   "\n" + tr("Work it again?"),
                               QMessageBox::Yes | QMessageBox::No,
                               QMessageBox::No) == QMessageBox::Yes;
}

QString WorkPage::words_of_works(const scan_cell_msgs::DescribeRunResponse& run) {
  QString words = tr("Dry runs: %1. Worked: %2.").arg(run.dry_runs).arg(run.works);
  if (run.works > 0 && run.last_finished == 0)
    words += tr(" The last one ended early, after %1 waypoints.").arg(run.last_passed);
  return words;
}

void WorkPage::show_run(const scan_cell_msgs::DescribeRunResponse& described) {
  const RunSummary& run = described.run;
  works_ = described.works;
  const bool is_another = run.id != run_.id;
  if (is_another) {
    end_->clear();
    forget_preview();
    asked_ = false;  // the request was for the run that was in view
  }
  run_ = run;
  const QString name = QString::fromStdString(run.recipe + ", " + run.id);
  if (run.id.empty())
    part_->setText(tr("Scan a part first."));
  else if (run.decision == RunSummary::APPROVED_BY)
    part_->setText(tr("%1: approved by %2").arg(name, QString::fromStdString(run.decided_by)) +
                   "\n" + words_of_works(described));
  else if (run.state != RunSummary::ACCEPTED)
    part_->setText(tr("%1: its path was not accepted").arg(name));
  else if (run.decision == RunSummary::REFUSED_BY)
    part_->setText(tr("%1: refused by %2").arg(name, QString::fromStdString(run.decided_by)));
  else
    part_->setText(tr("%1: approve it first").arg(name));
  update_buttons();
  if (is_another && came_) show_preview(came_);  // drawn in the view, too, if it is of this run
}

void WorkPage::show_end(const QString& message) {
  end_->setText(message);
}

void WorkPage::set_free(bool free) {
  free_ = free;
  update_buttons();
}

void WorkPage::update_buttons() {
  const bool looked_at = free_ && !asked_ && run_.state == RunSummary::ACCEPTED && !run_.id.empty();
  preview_->setEnabled(looked_at);
  preview_dry_->setEnabled(looked_at);
  const bool may =
      free_ && run_.state == RunSummary::ACCEPTED && run_.decision == RunSummary::APPROVED_BY;
  dry_->setEnabled(may);
  work_->setEnabled(may);
}

}  // namespace scan_cell_rviz
