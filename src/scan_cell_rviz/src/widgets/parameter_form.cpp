// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/parameter_form.h"

#include <algorithm>

#include "widgets/units_shown.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::ToolParameter;

/// Multiplies each number in a text; other words stay.
QString scaled(const QString& text, double factor) {
  constexpr int kDigits = 12;  // so that 0.0001 m is 0.1 mm
  if (factor == 1) return text.simplified();
  QStringList words;
  for (const QString& word : text.simplified().split(' ', Qt::SkipEmptyParts)) {
    bool is_number = false;
    const double number = word.toDouble(&is_number);
    words.append(is_number ? QString::number(number * factor, 'g', kDigits) : word);
  }
  return words.join(' ');
}

QString shown(const ToolParameter& parameter) {
  return scaled(QString::fromStdString(parameter.value), factor_of(parameter.unit));
}

}  // namespace

ParameterForm::ParameterForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {}

void ParameterForm::show_parameters(const std::vector<ToolParameter>& parameters) {
  const auto same = [](const Line& line, const ToolParameter& parameter) {
    return line.parameter.name == parameter.name && line.parameter.value == parameter.value;
  };
  if (std::equal(lines_.begin(), lines_.end(), parameters.begin(), parameters.end(), same)) return;
  std::map<std::string, QString> before;
  for (const Line& line : lines_) {
    const QString text = line.edit != nullptr ? line.edit->text() : line.choice->currentText();
    if (text != shown(line.parameter)) before[line.parameter.name] = text;
  }
  lines_.clear();
  while (form_->rowCount() > 0)
    form_->removeRow(0);
  for (const ToolParameter& parameter : parameters) {
    const auto kept = before.find(parameter.name);
    add(parameter, kept == before.end() ? shown(parameter) : kept->second);
  }
}

void ParameterForm::add(const ToolParameter& parameter, const QString& text) {
  Line line;
  line.parameter = parameter;
  QWidget* widget = nullptr;
  if (parameter.words.empty()) {
    widget = line.edit = new QLineEdit(text, this);
  } else {
    widget = line.choice = new QComboBox(this);
    for (const std::string& word : parameter.words)
      line.choice->addItem(QString::fromStdString(word));
    line.choice->setCurrentText(text);
  }
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  const std::string range = parameter.range.empty() ? "" : " (" + parameter.range + unit + ")";
  widget->setObjectName(QString::fromStdString("parameter_" + parameter.name));
  widget->setToolTip(QString::fromStdString(parameter.meaning + range));
  QString label = QString::fromStdString(parameter.name);
  label.replace('_', ' ');
  const QString shown_unit = unit_shown(parameter.unit);
  form_->addRow(shown_unit.isEmpty() ? label : label + " [" + shown_unit.trimmed() + "]", widget);
  lines_.push_back(line);
}

std::map<std::string, std::string> ParameterForm::given() const {
  std::map<std::string, std::string> values;
  for (const Line& line : lines_) {
    const QString text =
        line.edit != nullptr ? line.edit->text().simplified() : line.choice->currentText();
    if (text == shown(line.parameter)) continue;
    values[line.parameter.name] = scaled(text, 1 / factor_of(line.parameter.unit)).toStdString();
  }
  return values;
}

}  // namespace scan_cell_rviz
