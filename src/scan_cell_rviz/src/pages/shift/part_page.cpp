// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/shift/part_page.h"

#include <QFormLayout>
#include <QIcon>
#include <QVBoxLayout>

#include "widgets/labels_and_buttons.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RecipeState;

constexpr int kPicture = 72;               // pixels
constexpr int kName = Qt::UserRole;        // of the recipe
constexpr int kMayRun = Qt::UserRole + 1;  // whether it can run

QString words_of(const RecipeState& recipe) {
  switch (recipe.state) {
    case RecipeState::PROVEN:
      return PartPage::tr("proven %1").arg(QString::fromStdString(recipe.time));
    case RecipeState::MADE:
      return PartPage::tr("never proven");
    default:
      return PartPage::tr("out of date: %1").arg(QString::fromStdString(recipe.message));
  }
}

}  // namespace

PartPage::PartPage(QWidget* parent)
    : QWidget(parent),
      recipes_(new QListWidget(this)),
      missed_(text_label("missed", this)),
      note_(new QLineEdit(this)),
      run_(new QPushButton(tr("&Scan and fit"), this)) {
  recipes_->setObjectName("recipes");
  recipes_->setIconSize(QSize(kPicture, kPicture));
  recipes_->setWordWrap(true);
  recipes_->setAccessibleName(tr("Part types"));
  note_->setObjectName("run_note");
  missed_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  note_->setToolTip(tr("Kept with the run, such as the part's serial number"));
  run_->setObjectName("run");
  run_->setToolTip(
      tr("Moves the robot: scans the part, fits the path of its type to it and writes the report"));
  auto* const refresh = new QPushButton(tr("&Refresh"), this);
  refresh->setObjectName("refresh");

  auto* const form = new QFormLayout;
  form->addRow(tr("&Note"), note_);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(recipes_);
  layout->addWidget(missed_);
  layout->addLayout(form);
  layout->addWidget(run_);
  layout->addWidget(refresh);

  connect(recipes_, &QListWidget::currentRowChanged, this, [this] { update_button(); });
  connect(refresh, &QPushButton::clicked, this, &PartPage::refreshWanted);
  connect(run_, &QPushButton::clicked, this, [this] {
    Q_EMIT runWanted(chosen(), note_->text());
    note_->clear();  // about that part only
  });
  update_button();
}

QString PartPage::chosen() const {
  const QListWidgetItem* const item = recipes_->currentItem();
  return item != nullptr ? item->data(kName).toString() : QString();
}

void PartPage::show_recipes(const std::vector<RecipeState>& recipes) {
  const QString before = chosen();
  missed_->hide();
  recipes_->clear();
  for (const RecipeState& recipe : recipes) {
    const QString name = QString::fromStdString(recipe.name);
    auto* const item = new QListWidgetItem(name + "\n" + words_of(recipe), recipes_);
    if (!recipe.picture.empty()) item->setIcon(QIcon(QString::fromStdString(recipe.picture)));
    item->setData(kName, name);
    item->setData(kMayRun, recipe.state != RecipeState::OUT_OF_DATE);
    item->setToolTip(words_of(recipe));
    if (name == before) recipes_->setCurrentItem(item);
  }
  update_button();
}

void PartPage::show_missed(const QString& why) {
  missed_->setText(why);
  missed_->show();
}

void PartPage::set_free(bool free) {
  free_ = free;
  update_button();
}

void PartPage::update_button() {
  const QListWidgetItem* const item = recipes_->currentItem();
  run_->setEnabled(free_ && item != nullptr && item->data(kMayRun).toBool());
}

}  // namespace scan_cell_rviz
