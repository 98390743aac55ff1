// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/shift/fit_page.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "scan_cell_common/pose/units.h"
#include "widgets/labels_and_buttons.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_common::kMillimetres;
using scan_cell_msgs::RunSummary;

/// A label whose text can be copied.
QLabel* selectable_label(const char* name, QWidget* parent) {
  QLabel* const label = text_label(name, parent);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

QString verdict_of(const RunSummary& run) {
  switch (run.state) {
    case RunSummary::ACCEPTED:
      return FitPage::tr("\u2714 Accepted");
    case RunSummary::REFUSED:
      return FitPage::tr("\u2716 Refused: %1").arg(QString::fromStdString(run.reason));
    default:
      return FitPage::tr("! Unusable: %1").arg(QString::fromStdString(run.reason));
  }
}

QString decision_of(const RunSummary& run) {
  if (run.decision == RunSummary::OPEN) return FitPage::tr("Nobody has decided yet.");
  const QString words = run.decision == RunSummary::APPROVED_BY ? FitPage::tr("Approved by %1")
                                                                : FitPage::tr("Refused by %1");
  const QString note = QString::fromStdString(run.decision_note);
  return words.arg(QString::fromStdString(run.decided_by)) + (note.isEmpty() ? "" : ": " + note);
}

}  // namespace

FitPage::FitPage(QWidget* parent)
    : QWidget(parent),
      verdict_(selectable_label("verdict", this)),
      message_(selectable_label("message", this)),
      figures_(new QTableWidget(0, 3, this)),
      waypoints_(new QListWidget(this)),
      decision_(selectable_label("decision", this)),
      person_(new QLineEdit(this)),
      note_(new QLineEdit(this)),
      approve_(new QPushButton(tr("&Approve"), this)),
      refuse_(new QPushButton(tr("Re&fuse"), this)),
      report_(new QPushButton(tr("Open re&port"), this)) {
  QFont large = verdict_->font();
  large.setPointSizeF(large.pointSizeF() * 1.5);
  verdict_->setFont(large);
  figures_->setObjectName("figures");
  figures_->setHorizontalHeaderLabels({tr("Figure"), tr("Value"), tr("Limit")});
  figures_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  figures_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  figures_->verticalHeader()->hide();
  figures_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  waypoints_->setObjectName("waypoints");
  waypoints_->setAccessibleName(tr("Waypoints that the verdict is about"));
  waypoints_->setToolTip(tr("What the verdict is about; the view turns to the chosen one"));
  person_->setObjectName("person");
  person_->setToolTip(tr("Who decides; kept with the run"));
  note_->setObjectName("decision_note");
  note_->setToolTip(tr("Why; kept with the run"));
  approve_->setToolTip(tr("The path may be worked; type your name first"));
  refuse_->setToolTip(tr("The path may not be worked; type your name first"));
  approve_->setObjectName("approve");
  refuse_->setObjectName("refuse");
  report_->setObjectName("report");
  lay_out();
  connect(waypoints_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row < 0) return;
    const geometry_msgs::Point& at = run_.waypoint_positions.at(static_cast<std::size_t>(row));
    Q_EMIT placeChosen(at.x, at.y, at.z, QString::fromStdString(run_.frame));
  });
  connect(person_, &QLineEdit::textChanged, this, [this] { update_buttons(); });
  connect(approve_, &QPushButton::clicked, this, [this] { decide(true); });
  connect(refuse_, &QPushButton::clicked, this, [this] { decide(false); });
  connect(report_, &QPushButton::clicked, this,
          [this] { Q_EMIT reportWanted(QString::fromStdString(run_.report)); });
  message_->setText(tr("No part was scanned yet."));
  show_waypoints();
  update_buttons();
}

void FitPage::lay_out() {
  auto* const form = new QFormLayout;
  form->addRow(tr("Your &name"), person_);
  form->addRow(tr("N&ote"), note_);
  auto* const buttons = new QHBoxLayout;
  for (QPushButton* const button : {approve_, refuse_, report_})
    buttons->addWidget(button);
  auto* const layout = new QVBoxLayout(this);
  for (QWidget* const widget : {static_cast<QWidget*>(verdict_), static_cast<QWidget*>(message_),
                                static_cast<QWidget*>(waypoints_), static_cast<QWidget*>(figures_),
                                static_cast<QWidget*>(decision_)})
    layout->addWidget(widget);
  layout->addLayout(form);
  layout->addLayout(buttons);
}

void FitPage::show_run(const scan_cell_msgs::DescribeRunResponse& run) {
  run_ = run;
  verdict_->setText(verdict_of(run.run));
  message_->setText(QString::fromStdString(run.run.message));
  show_waypoints();
  const auto rows = static_cast<int>(std::min(run.figure_names.size(), run.figure_values.size()));
  figures_->setRowCount(rows);
  for (int row = 0; row < rows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    const QString name = QString::fromStdString(run.figure_names[i]).replace('_', ' ');
    figures_->setItem(row, 0, new QTableWidgetItem(name));
    figures_->setItem(row, 1, new QTableWidgetItem(QString::fromStdString(run.figure_values[i])));
    const QString limit =
        i < run.figure_limits.size() ? QString::fromStdString(run.figure_limits[i]) : QString();
    auto* const judged_by = new QTableWidgetItem(limit);
    judged_by->setToolTip(limit);
    figures_->setItem(row, 2, judged_by);
  }
  decision_->setText(decision_of(run.run));
  update_buttons();
}

void FitPage::show_waypoints() {
  waypoints_->clear();
  const std::size_t count =
      std::min(run_.waypoints_concerned.size(), run_.waypoint_positions.size());
  for (std::size_t i = 0; i < count; ++i) {
    const geometry_msgs::Point& at = run_.waypoint_positions[i];
    waypoints_->addItem(tr("waypoint %1 at %2, %3, %4 mm")
                            .arg(run_.waypoints_concerned[i])
                            .arg(at.x * kMillimetres, 0, 'f', 1)
                            .arg(at.y * kMillimetres, 0, 'f', 1)
                            .arg(at.z * kMillimetres, 0, 'f', 1));
  }
  waypoints_->setVisible(count > 0);
}

QString FitPage::person() const {
  return person_->text().trimmed();
}

void FitPage::set_person(const QString& name) {
  person_->setText(name);
}

void FitPage::decide(bool approved) {
  Q_EMIT decisionWanted(QString::fromStdString(run_.run.id), approved, person(), note_->text());
  note_->clear();
}

void FitPage::update_buttons() {
  const bool can_decide = !run_.run.id.empty() && !person().isEmpty();
  approve_->setEnabled(can_decide && run_.run.state == RunSummary::ACCEPTED);
  refuse_->setEnabled(can_decide);
  report_->setEnabled(!run_.report.empty());
}

}  // namespace scan_cell_rviz
