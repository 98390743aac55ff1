// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/preparation/teach_page.h"

#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "scan_cell_common/pose/units.h"
#include "widgets/labels_and_buttons.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::Jog;

constexpr int kSend = 50;      // [ms] between messages; the driver stops after 200
constexpr int kTooLate = 150;  // [ms] the window hung: a release may still be queued
constexpr double kSlow = 5;    // [%] initial; chosen

}  // namespace

TeachPage::TeachPage(TeachLink& link, QWidget* parent)
    : QWidget(parent),
      link_(link),
      kind_(new QComboBox(this)),
      speed_(new QDoubleSpinBox(this)),
      said_(text_label("jog_said", this)),
      file_(new QLineEdit(QDir::homePath() + "/poses.csv", this)),
      take_(named_button("take_pose", tr("Ta&ke the pose"), this)),
      taken_(text_label("pose_taken", this)) {
  auto* const layout = new QVBoxLayout(this);
  layout->addLayout(jog_box());
  layout->addWidget(said_);
  layout->addLayout(pose_box());
  layout->addWidget(taken_);
  layout->addStretch();
  timer_.setInterval(kSend);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &TeachPage::send);
  connect(&link_, &TeachLink::jogTold, this, &TeachPage::show_state);
  connect(&link_, &TeachLink::jointsCame, this, &TeachPage::show_joints);
  connect(&link_, &TeachLink::recorded, taken_, &QLabel::setText);
  connect(&link_, &TeachLink::failed, taken_, &QLabel::setText);
  name_axes();
  set_free(false);
}

QLayout* TeachPage::jog_box() {
  kind_->setObjectName("jog_kind");
  kind_->setToolTip(
      tr("What a button moves: one joint, or the flange along the axes of the "
         "robot's base or its own"));
  kind_->addItems({tr("Joints"), tr("Axes of the base"), tr("Axes of the flange")});
  speed_->setObjectName("jog_speed");
  speed_->setRange(1, 100);
  speed_->setValue(kSlow);
  speed_->setSuffix(tr(" %"));
  speed_->setToolTip(
      tr("Of the programmed speed (1 to 100 %); the driver refuses more than its "
         "max_jog_override"));
  connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    let_go({});
    name_axes();
  });
  auto* const form = new QFormLayout;
  form->addRow(tr("&Move"), kind_);
  form->addRow(tr("S&peed"), speed_);
  auto* const box = new QVBoxLayout;
  box->addLayout(form);
  box->addLayout(jog_buttons());
  return box;
}

QLayout* TeachPage::jog_buttons() {
  auto* const grid = new QGridLayout;
  for (int axis = 0; axis < kAxes; ++axis) {
    QLabel*& name = names_.at(static_cast<std::size_t>(axis));
    QLabel*& value = values_.at(static_cast<std::size_t>(axis));
    name = new QLabel(this);
    value = text_label(qPrintable(QString("joint_%1").arg(axis + 1)), this);
    grid->addWidget(name, axis, 0);
    grid->addWidget(value, axis, 1);
    for (const int direction : {-1, 1}) {
      const QString id = QString("jog_%1_%2").arg(direction < 0 ? "minus" : "plus").arg(axis + 1);
      auto* const button = new HoldButton(qPrintable(id), direction < 0 ? "\u2212" : "+", this);
      buttons_.push_back(button);
      grid->addWidget(button, axis, direction < 0 ? 2 : 3);
      connect(button, &HoldButton::heldChanged, this, [=](bool held) {
        if (held)
          hold(button, axis, direction);
        else if (button == held_)
          let_go({});
      });
    }
  }
  return grid;
}

QLayout* TeachPage::pose_box() {
  file_->setObjectName("pose_file");
  file_->setToolTip(
      tr("File of taught poses (CSV) on the cell's computer: made where there is "
         "none. Calibration, tool and world read such files."));
  take_->setToolTip(tr("Appends the flange's pose to the file. The robot must stand still."));
  auto* const browse = named_button("choose_pose_file", tr("C&hoose..."), this);
  connect(file_, &QLineEdit::textChanged, this, &TeachPage::fileChanged);
  connect(browse, &QPushButton::clicked, this, &TeachPage::choose_file);
  connect(take_, &QPushButton::clicked, this, &TeachPage::take_pose);
  auto* const line = new QHBoxLayout;
  line->addWidget(file_, 1);
  line->addWidget(browse);
  auto* const form = new QFormLayout;
  form->addRow(tr("Poses"), line);
  form->addRow(take_);
  return form;
}

void TeachPage::name_axes() {
  const QString cartesian[kAxes] = {tr("X"),       tr("Y"),       tr("Z"),
                                    tr("about X"), tr("about Y"), tr("about Z")};
  for (int axis = 0; axis < kAxes; ++axis) {
    const bool is_joint = kind_->currentIndex() == Jog::JOINT;
    const QString name = is_joint ? tr("J%1").arg(axis + 1) : cartesian[axis];
    names_.at(static_cast<std::size_t>(axis))->setText(name);
    values_.at(static_cast<std::size_t>(axis))->setVisible(is_joint);
    for (const int side : {0, 1}) {
      HoldButton* const button = buttons_.at(static_cast<std::size_t>(2 * axis + side));
      button->setAccessibleName(name + (side == 0 ? " \u2212" : " +"));
      button->setToolTip(tr("The robot moves while it is held, by the mouse or the space bar"));
    }
  }
}

void TeachPage::show_joints(const std::vector<double>& positions) {
  for (std::size_t axis = 0; axis < std::min(positions.size(), values_.size()); ++axis)
    values_.at(axis)->setText(
        tr("%1\u00b0").arg(positions[axis] * scan_cell_common::kDegrees, 0, 'f', 2));
}

void TeachPage::show_state(const scan_cell_msgs::JogState& state) {
  if (state.moving != 0)
    said_->setText(tr("The robot moves."));
  else if (!state.message.empty())
    said_->setText(QString::fromStdString(state.message));
  else if (held_ == nullptr)
    said_->clear();
}

void TeachPage::set_free(bool free) {
  for (HoldButton* const button : buttons_)
    button->setEnabled(free);
  take_->setEnabled(free);
}

void TeachPage::hold(HoldButton* button, int axis, int direction) {
  held_ = button;
  jog_.kind = static_cast<std::uint8_t>(kind_->currentIndex());
  jog_.axis = static_cast<std::uint8_t>(axis);
  jog_.direction = static_cast<std::int8_t>(direction);
  jog_.override = speed_->value();
  said_->clear();
  link_.jog(Jog());  // the driver needs a released button first
  since_sent_.start();
  timer_.start();
  send();
}

/// While the window hangs nothing is sent and the driver stops. The button must then be pressed
/// again, because a release meanwhile has not been processed yet.
void TeachPage::send() {
  if (held_ == nullptr || !held_->is_held()) return let_go({});
  if (!link_.has_driver()) return let_go(tr("The robot's driver is not running."));
  if (since_sent_.restart() > kTooLate)
    return let_go(tr("This window did not answer for a moment: press the button again."));
  link_.jog(jog_);
}

void TeachPage::let_go(const QString& why) {
  if (HoldButton* const button = std::exchange(held_, nullptr)) {
    timer_.stop();
    button->let_go();
    link_.jog(Jog());
  }
  if (!why.isEmpty()) said_->setText(why);
}

void TeachPage::choose_file() {
  const QString file =
      QFileDialog::getSaveFileName(this, tr("File of taught poses"), file_->text(),
                                   tr("CSV (*.csv)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (!file.isEmpty()) file_->setText(file);
}

void TeachPage::take_pose() {
  taken_->clear();
  link_.record(file_->text());
}

}  // namespace scan_cell_rviz
