// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/shift/history_page.h"

#include <QHeaderView>
#include <QPushButton>
#include <QVBoxLayout>

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RunSummary;

QString verdict_words(const RunSummary& run) {
  switch (run.state) {
    case RunSummary::ACCEPTED:
      return HistoryPage::tr("accepted");
    case RunSummary::REFUSED:
      return HistoryPage::tr("refused: %1").arg(QString::fromStdString(run.reason));
    default:
      return HistoryPage::tr("unusable: %1").arg(QString::fromStdString(run.reason));
  }
}

QString mark_of(const RunSummary& run) {
  if (run.decision == RunSummary::OPEN) return QString();
  return (run.decision == RunSummary::APPROVED_BY ? "\u2714 " : "\u2716 ") +
         QString::fromStdString(run.decided_by);
}

}  // namespace

HistoryPage::HistoryPage(QWidget* parent) : QWidget(parent), runs_(new QTableWidget(0, 4, this)) {
  runs_->setObjectName("runs");
  runs_->setHorizontalHeaderLabels(
      {tr("Started (UTC)"), tr("Part"), tr("Verdict"), tr("Decision")});
  runs_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  runs_->verticalHeader()->hide();
  runs_->setSelectionBehavior(QAbstractItemView::SelectRows);
  runs_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  auto* const refresh = new QPushButton(tr("&Refresh"), this);
  refresh->setObjectName("refresh_runs");
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(runs_);
  layout->addWidget(refresh);
  connect(refresh, &QPushButton::clicked, this, &HistoryPage::refreshWanted);
  connect(runs_, &QTableWidget::cellActivated, this, [this](int row) {
    Q_EMIT runChosen(runs_->item(row, 0)->data(Qt::UserRole).toString());
  });
}

void HistoryPage::show_runs(const std::vector<RunSummary>& runs) {
  runs_->setRowCount(static_cast<int>(runs.size()));
  int row = 0;
  for (const RunSummary& run : runs) {
    constexpr int kToSeconds = 19;  // characters of 2026-11-25T12:13:14
    auto* const started =
        new QTableWidgetItem(QString::fromStdString(run.started).left(kToSeconds));
    started->setData(Qt::UserRole, QString::fromStdString(run.id));
    runs_->setItem(row, 0, started);
    runs_->setItem(row, 1, new QTableWidgetItem(QString::fromStdString(run.recipe)));
    runs_->setItem(row, 2, new QTableWidgetItem(verdict_words(run)));
    runs_->setItem(row, 3, new QTableWidgetItem(mark_of(run)));
    ++row;
  }
}

}  // namespace scan_cell_rviz
