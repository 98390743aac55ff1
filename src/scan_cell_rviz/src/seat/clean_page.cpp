// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "seat/clean_page.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "scan_cell_common/pose/units.h"
#include "seat/widgets.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_common::kMillimetres;

}  // namespace

CleanPage::CleanPage(EditSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      count_(text_label("clean_count", this)),
      what_(new QComboBox(this)),
      edits_(new QListWidget(this)),
      undo_(named_button("undo", tr("&Undo"), this)),
      redo_(named_button("redo", tr("R&edo"), this)),
      drop_(named_button("drop_edits", tr("Dr&op all"), this)),
      save_(named_button("save_edits", tr("Save into the &recipe"), this)),
      end_(text_label("clean_end", this)) {
  const EditSettings settings;
  what_->setObjectName("edit_what");
  what_->addItems({tr("Delete what is in the shape"), tr("Keep only what is in the shape")});
  depth_ =
      length_box("edit_depth", settings.depth,
                 tr("How far a polygon goes before and behind the first place (0.1 to 10000 mm)"));
  radius_ = length_box("edit_radius", settings.radius, tr("Of the brush (0.1 to 10000 mm)"));
  gap_ = length_box("edit_gap", settings.gap,
                    tr("Points farther apart are two clusters (0.1 to 10000 mm)"));
  edits_->setObjectName("edits");
  edits_->setAccessibleName(tr("Edits in force"));
  lay_out();
  connect(what_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this] { take_settings(); });
  for (QDoubleSpinBox* const box : {depth_, radius_, gap_})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this] { take_settings(); });
  connect(undo_, &QPushButton::clicked, &session_, &EditSession::undo);
  connect(redo_, &QPushButton::clicked, &session_, &EditSession::redo);
  connect(drop_, &QPushButton::clicked, &session_, &EditSession::drop_all);
  connect(save_, &QPushButton::clicked, this, [this] {
    if (const EditedViewPtr view = session_.view()) Q_EMIT saveWanted(recipe_, view->yaml);
  });
  connect(&session_, &EditSession::changed, this, &CleanPage::show_view);
  connect(&session_, &EditSession::failed, this, &CleanPage::show_end);
  take_settings();
  show_view();
}

QDoubleSpinBox* CleanPage::length_box(const char* name, double metres, const QString& meaning) {
  auto* const box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setRange(0.1, 10000);
  box->setDecimals(1);
  box->setSuffix(tr(" mm"));
  box->setValue(metres * kMillimetres);
  box->setToolTip(meaning);
  return box;
}

void CleanPage::lay_out() {
  auto* const tools = new QHBoxLayout;
  const std::pair<const char*, QString> names[] = {
      {"box", tr("Bo&x")},     {"polygon", tr("&Polygon")}, {"plane", tr("P&lane")},
      {"brush", tr("&Brush")}, {"cluster", tr("Clus&ter")}, {"view", tr("&View")}};
  for (const auto& [name, text] : names) {
    QPushButton* const button = named_button((std::string("tool_") + name).c_str(), text, this);
    tools->addWidget(button);
    connect(button, &QPushButton::clicked, this,
            [this, wanted = QString(name)] { Q_EMIT toolWanted(wanted); });
  }
  QPushButton* const apply = named_button("apply_box", tr("&Apply the box"), this);
  apply->setToolTip(tr("Drag its arrows, rings and faces in the view before"));
  connect(apply, &QPushButton::clicked, this, &CleanPage::boxWanted);
  auto* const form = new QFormLayout;
  form->addRow(tr("&Depth"), depth_);
  form->addRow(tr("Br&ush radius"), radius_);
  form->addRow(tr("Cluster &gap"), gap_);
  form->addRow(apply);
  auto* const buttons = new QHBoxLayout;
  for (QPushButton* const button : {undo_, redo_, drop_})
    buttons->addWidget(button);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(count_);
  layout->addWidget(what_);
  layout->addLayout(tools);
  layout->addLayout(form);
  layout->addWidget(edits_, 1);
  layout->addLayout(buttons);
  layout->addWidget(save_);
  layout->addWidget(end_);
}

void CleanPage::set_recipe(const QString& recipe) {
  recipe_ = recipe;
  show_view();
}

void CleanPage::show_view() {
  EditedViewPtr view = session_.view();
  if (view && view->source->empty()) view = nullptr;  // the run has no scan
  end_->clear();
  edits_->clear();
  if (view) edits_->addItems(view->edits);
  count_->setText(view
                      ? tr("%1 of %2 points stay.").arg(view->kept.size()).arg(view->source->size())
                      : tr("No scan is in view: scan a part, or choose a run."));
  undo_->setEnabled(view && !view->edits.isEmpty());
  drop_->setEnabled(undo_->isEnabled());
  redo_->setEnabled(view && view->can_redo);
  save_->setEnabled(view && !recipe_.isEmpty());
}

void CleanPage::take_settings() {
  EditSettings settings;
  settings.keep = what_->currentIndex() == 1;
  settings.depth = depth_->value() / kMillimetres;
  settings.radius = radius_->value() / kMillimetres;
  settings.gap = gap_->value() / kMillimetres;
  session_.set_settings(settings);
}

void CleanPage::show_end(const QString& message) {
  end_->setText(message);
}

}  // namespace scan_cell_rviz
