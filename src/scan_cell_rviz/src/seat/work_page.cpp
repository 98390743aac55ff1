// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "seat/work_page.h"

#include <QVBoxLayout>

#include "seat/text_label.h"

namespace scan_cell_rviz {

using scan_cell_msgs::RunSummary;

WorkPage::WorkPage(QWidget* parent)
    : QWidget(parent),
      part_(text_label("work_part", this)),
      end_(text_label("work_end", this)),
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
  layout->addWidget(end_);
  layout->addStretch();
  for (QPushButton* const button : {dry_, work_}) {
    connect(button, &QPushButton::clicked, this, [this, button] {
      end_->clear();  // it told of the last time
      Q_EMIT workWanted(QString::fromStdString(run_.id), button == dry_);
    });
  }
  show_run({});
}

void WorkPage::show_run(const RunSummary& run) {
  if (run.id != run_.id) end_->clear();
  run_ = run;
  const QString name = QString::fromStdString(run.recipe + ", " + run.id);
  if (run.id.empty())
    part_->setText(tr("Scan a part first."));
  else if (run.decision == RunSummary::APPROVED_BY)
    part_->setText(tr("%1: approved by %2").arg(name, QString::fromStdString(run.decided_by)));
  else
    part_->setText(tr("%1: approve it first").arg(name));
  update_buttons();
}

void WorkPage::show_end(const QString& message) {
  end_->setText(message);
}

void WorkPage::set_free(bool free) {
  free_ = free;
  update_buttons();
}

void WorkPage::update_buttons() {
  const bool may =
      free_ && run_.state == RunSummary::ACCEPTED && run_.decision == RunSummary::APPROVED_BY;
  dry_->setEnabled(may);
  work_->setEnabled(may);
}

}  // namespace scan_cell_rviz
