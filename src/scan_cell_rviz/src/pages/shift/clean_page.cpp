// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/shift/clean_page.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/pose/units.h"
#include "widgets/labels_and_buttons.h"

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
      show_(named_button("show_hidden", tr("Sho&w hidden"), this)),
      take_over_(named_button("take_over_edits", "", this)),
      save_(named_button("save_edits", tr("Save into the &recipe"), this)),
      stages_(new StagesBox(this)),
      end_(text_label("clean_end", this)) {
  const EditSettings settings;
  what_->setObjectName("edit_what");
  what_->addItem(tr("Delete what is in the shape"), QVariant::fromValue(EditAct::kDelete));
  what_->addItem(tr("Keep only what is in the shape"), QVariant::fromValue(EditAct::kKeepOnly));
  what_->addItem(tr("Hide what is in the shape"), QVariant::fromValue(EditAct::kHide));
  what_->addItem(tr("Show only what is in the shape"), QVariant::fromValue(EditAct::kShowOnly));
  what_->setToolTip(tr(
      "Hidden points are out of view, and out of the way of brush, clicks and clusters. They are "
      "still part of the scan: an edit whose shape they are in takes them, too"));
  depth_ =
      length_box("edit_depth", settings.depth,
                 tr("How far a polygon goes before and behind the first place (0.1 to 10000 mm)"));
  radius_ = length_box("edit_radius", settings.radius, tr("Of the brush (0.1 to 10000 mm)"));
  gap_ = length_box("edit_gap", settings.gap,
                    tr("Points farther apart are two clusters (0.1 to 10000 mm)"));
  edits_->setObjectName("edits");
  edits_->setAccessibleName(tr("Edits in force"));
  lay_out();
  connect_widgets();
  session_.try_stages(std::nullopt);  // another page may have tried them
  take_settings();
  show_view();
}

void CleanPage::connect_widgets() {
  connect(what_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this] { take_settings(); });
  for (QDoubleSpinBox* const box : {depth_, radius_, gap_})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this] { take_settings(); });
  connect(undo_, &QPushButton::clicked, &session_, &EditSession::undo);
  connect(redo_, &QPushButton::clicked, &session_, &EditSession::redo);
  connect(drop_, &QPushButton::clicked, &session_, &EditSession::drop_all);
  connect(show_, &QPushButton::clicked, &session_, &EditSession::show_all);
  connect(take_over_, &QPushButton::clicked, this, [this] {
    for (const cloud_preprocess::CloudEdit& edit : given_.edits)
      session_.add(edit);
  });
  connect(save_, &QPushButton::clicked, this, [this] {
    if (const EditedViewPtr view = session_.view()) Q_EMIT saveWanted(recipe_, view->yaml);
  });
  connect(stages_, &StagesBox::changed, this,
          [this] { session_.try_stages(stages_->parameters()); });
  connect(stages_, &StagesBox::saveWanted, this, [this] {
    if (const auto stages = stages_->parameters())
      Q_EMIT stagesSaveWanted(recipe_, QString::fromStdString(stages_yaml(*stages)));
  });
  connect(&session_, &EditSession::changed, this, &CleanPage::show_view);
  connect(&session_, &EditSession::failed, this, &CleanPage::show_end);
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
      {"brush", tr("&Brush")}, {"cluster", tr("&Cluster")}, {"view", tr("&View")}};
  for (const auto& [name, text] : names) {
    QPushButton* const button = named_button((std::string("tool_") + name).c_str(), text, this);
    tools->addWidget(button);
    connect(button, &QPushButton::clicked, this,
            [this, wanted = QString(name)] { Q_EMIT toolWanted(wanted); });
  }
  QPushButton* const apply = named_button("apply_box", tr("&Apply the box"), this);
  apply->setToolTip(tr("First drag its arrows, rings and faces in the view"));
  connect(apply, &QPushButton::clicked, this, &CleanPage::boxWanted);
  auto* const form = new QFormLayout;
  form->addRow(tr("&Depth"), depth_);
  form->addRow(tr("Brus&h radius"), radius_);
  form->addRow(tr("Cluster &gap"), gap_);
  form->addRow(apply);
  auto* const buttons = new QHBoxLayout;
  for (QPushButton* const button : {undo_, redo_, drop_, show_})
    buttons->addWidget(button);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(count_);
  layout->addWidget(what_);
  layout->addLayout(tools);
  layout->addLayout(form);
  layout->addWidget(edits_, 1);
  layout->addLayout(buttons);
  layout->addWidget(save_);
  layout->addWidget(take_over_);
  layout->addWidget(stages_);
  connect(stages_, &QGroupBox::toggled, this,
          [=](bool on) { layout->setStretchFactor(stages_, on ? 2 : 0); });
  layout->addWidget(end_);
}

void CleanPage::set_recipe(const QString& recipe, const QString& cleaning) {
  using scan_cell_common::YamlEntry;
  cloud_preprocess::CleanParameters given;
  QString fault;
  try {
    given = cloud_preprocess::read_clean_parameters(
        YamlEntry::parse(cleaning.toStdString(), "cleaning settings of the recipe"));
  } catch (const scan_cell_common::Error& error) {
    fault = QString::fromStdString(error.what());
  }
  const bool are_others = recipe != recipe_ || stages_yaml(given) != stages_yaml(given_);
  recipe_ = recipe;
  given_ = given;
  if (are_others) stages_->set_parameters(given);  // else a person's settings stay
  show_view();
  if (!fault.isEmpty()) show_end(fault);
}

QString CleanPage::count_text(const EditedView& view) {
  const std::size_t hidden = view.kept.size() - view.shown.size();
  const QString stay = tr("%1 of %2 points stay.").arg(view.kept.size()).arg(view.source->size());
  return hidden > 0 ? stay + tr(" %1 of them are hidden.").arg(hidden) : stay;
}

void CleanPage::show_view() {
  EditedViewPtr view = session_.view();
  if (view && view->source->empty()) view = nullptr;  // the run has no scan
  const QStringList edits = view ? view->edits : QStringList();
  if (edits != shown_edits_) end_->clear();  // it was about earlier edits
  shown_edits_ = edits;
  edits_->clear();
  edits_->addItems(edits);
  count_->setText(view ? count_text(*view)
                       : tr("No scan is in view: scan a part, or choose a run."));
  undo_->setEnabled(view && !view->edits.isEmpty());
  drop_->setEnabled(undo_->isEnabled());
  redo_->setEnabled(view && view->can_redo);
  show_->setEnabled(view && view->shown.size() < view->kept.size());
  save_->setEnabled(view && !recipe_.isEmpty());
  const bool can_take_over = view && edits.isEmpty() && !given_.edits.empty();
  take_over_->setVisible(can_take_over);
  take_over_->setText(tr("Ta&ke over the recipe's edits (%1)").arg(given_.edits.size()));
  stages_->show_stages(view ? view->stages : std::vector<StageView>());
  stages_->set_savable(save_->isEnabled());
}

void CleanPage::take_settings() {
  EditSettings settings;
  settings.act = what_->currentData().value<EditAct>();
  settings.depth = depth_->value() / kMillimetres;
  settings.radius = radius_->value() / kMillimetres;
  settings.gap = gap_->value() / kMillimetres;
  session_.set_settings(settings);
}

void CleanPage::show_end(const QString& message) {
  end_->setText(message);
}

}  // namespace scan_cell_rviz
