// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/shift/stages_box.h"

#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "edit/stage_colours.h"
#include "scan_cell_common/parameters/each_parameter.h"
#include "widgets/labels_and_buttons.h"
#include "widgets/units_shown.h"

namespace scan_cell_rviz {
namespace {

using cloud_preprocess::CleanParameters;
using scan_cell_common::EachParameter;
using scan_cell_common::Parameter;
using scan_cell_common::ParameterValue;

std::optional<double> number_in(const ParameterValue& value) {
  if (const auto* const number = std::get_if<double>(&value)) return *number;
  if (const auto* const whole = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*whole);
  return std::nullopt;
}

/// The stage and the parameter's name within it.
std::pair<std::string, std::string> parts_of(const std::string& name) {
  const std::size_t slash = name.find('/');
  return {name.substr(0, slash), name.substr(slash + 1)};
}

QLabel* colour_label(const StageColour& colour, QWidget* parent) {
  constexpr int kSide = 12;  // [pixels]
  auto* const label = new QLabel(parent);
  label->setFixedSize(kSide, kSide);
  const QColor shown =
      QColor::fromRgbF(static_cast<qreal>(colour.red), static_cast<qreal>(colour.green),
                       static_cast<qreal>(colour.blue));
  label->setStyleSheet("background: " + shown.name());
  return label;
}

}  // namespace

StagesBox::StagesBox(QWidget* parent)
    : QGroupBox(tr("Automatic stages"), parent),
      inside_(new QWidget),
      save_(named_button("save_stages", tr("Save the &stages into the recipe"), this)) {
  setObjectName("stages");
  setCheckable(true);
  setChecked(false);
  setToolTip(tr("Shows which of the points left by the edits each stage would remove"));
  auto* const rows = new QVBoxLayout(inside_);
  for (const StageColour& colour : kStageColours) {
    auto* const head = new QHBoxLayout;
    QLabel* const words = text_label((std::string("stage_") + colour.stage).c_str(), inside_);
    head->addWidget(colour_label(colour, inside_));
    head->addWidget(words, 1);
    rows->addLayout(head);
    words_[colour.stage] = words;
    rows->addLayout(forms_[colour.stage] = new QFormLayout);
  }
  EachParameter table(
      [this](const Parameter& parameter, ParameterValue& value) { add_row(parameter, value); });
  describe(table, given_);
  show_stages({});
  auto* const scrolled = new QScrollArea(this);
  scrolled->setWidgetResizable(true);
  scrolled->setWidget(inside_);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(scrolled, 1);
  layout->addWidget(save_);
  connect(this, &QGroupBox::toggled, this, [=](bool on) {
    scrolled->setVisible(on);
    save_->setVisible(on);
    Q_EMIT changed();
  });
  scrolled->hide();
  save_->hide();
  connect(save_, &QPushButton::clicked, this, &StagesBox::saveWanted);
}

void StagesBox::add_row(const Parameter& parameter, const ParameterValue& value) {
  const auto [stage, name] = parts_of(parameter.name);
  const std::optional<double> number = number_in(value);
  const bool is_switch = std::holds_alternative<bool>(value);
  const bool is_limit = parameter.also == scan_cell_common::Also::kNone;
  if (forms_.count(stage) == 0 || is_limit || (!number && !is_switch)) return;
  if (number && !(*number > 0 && std::isfinite(*number))) return;  // no log slider for it
  Row& row = rows_[parameter.name];
  const std::string& full = parameter.name;
  const std::string widget = stage + "_" + name;
  const std::string range = range_text(parameter, value);
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  const QString meaning =
      QString::fromStdString(parameter.meaning + (range.empty() ? "" : " (" + range + unit + ")") +
                             tr("; usually %1")
                                 .arg(QString::fromStdString(default_text(parameter, value) + unit))
                                 .toStdString());
  QString label = QString::fromStdString(name);
  label.replace('_', ' ');
  if (is_switch) {
    row.box = new QCheckBox(label, inside_);
    row.box->setObjectName(QString::fromStdString(widget));
    row.box->setChecked(std::get<bool>(value));
    row.box->setToolTip(meaning);
    forms_[stage]->addRow(row.box);
    connect(row.box, &QCheckBox::toggled, this, [this, full] { touch(full); });
    return;
  }
  constexpr int kDecimals = 4;  // of numbers that are not whole; chosen
  row.factor = factor_of(parameter.unit);
  const bool whole = std::holds_alternative<std::int64_t>(value);
  row.slider = new LogSlider(*number * row.factor, parameter.min * row.factor,
                             parameter.max * row.factor, whole ? 0 : kDecimals, inside_);
  row.slider->box()->setObjectName(QString::fromStdString(widget));
  row.slider->box()->setSuffix(unit_shown(parameter.unit));
  row.slider->setToolTip(meaning);
  forms_[stage]->addRow(label, row.slider);
  connect(row.slider, &LogSlider::changed, this, [this, full] { touch(full); });
}

void StagesBox::touch(const std::string& name) {
  rows_[name].touched = true;
  if (isChecked()) Q_EMIT changed();
}

void StagesBox::set_parameters(const CleanParameters& parameters) {
  given_ = parameters;
  EachParameter table([this](const Parameter& parameter, ParameterValue& value) {
    const auto found = rows_.find(parameter.name);
    if (found == rows_.end()) return;
    Row& row = found->second;
    const QSignalBlocker quiet(row.box != nullptr ? static_cast<QObject*>(row.box) : row.slider);
    if (row.box != nullptr) row.box->setChecked(std::get<bool>(value));
    if (row.slider != nullptr) row.slider->set_value(*number_in(value) * row.factor);
    row.touched = false;
  });
  CleanParameters shown = parameters;
  describe(table, shown);
  if (isChecked()) Q_EMIT changed();
}

std::optional<CleanParameters> StagesBox::parameters() const {
  if (!isChecked()) return std::nullopt;
  CleanParameters parameters = given_;
  EachParameter table([this](const Parameter& parameter, ParameterValue& value) {
    const auto found = rows_.find(parameter.name);
    if (found == rows_.end() || !found->second.touched) return;
    const Row& row = found->second;
    if (row.box != nullptr) {
      value = row.box->isChecked();
      return;
    }
    const double number =
        std::clamp(row.slider->value() / row.factor, parameter.min, parameter.max);
    if (std::holds_alternative<double>(value))
      value = number;
    else
      value = static_cast<std::int64_t>(std::lround(number));
  });
  describe(table, parameters);
  return parameters;
}

void StagesBox::show_stages(const std::vector<StageView>& stages) {
  for (const StageColour& colour : kStageColours) {
    const auto stage = std::find_if(stages.begin(), stages.end(), [&](const StageView& view) {
      return view.name == colour.stage;
    });
    words_[colour.stage]->setText(stage == stages.end() ? tr("%1: not tried").arg(colour.stage)
                                                        : stage->words);
  }
}

}  // namespace scan_cell_rviz
