// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/preparation/passes_page.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "scan_cell_common/pose/units.h"
#include "widgets/labels_and_buttons.h"
#include "widgets/recipe_box.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::ScanPass;

enum Column { kPass, kPose, kX, kY, kZ, kReach, kColumns };

QString name_of(const ScanPass& pass, std::size_t number) {
  return pass.name.empty() ? QString::number(number + 1) : QString::fromStdString(pass.name);
}

QString millimetres(double metres) {
  return QString::number(metres * scan_cell_common::kMillimetres, 'f', 1);
}

QString mark_of(Reach reach) {
  if (reach == Reach::kReachable) return PassesPage::tr("yes");
  return reach == Reach::kNot ? PassesPage::tr("NO") : PassesPage::tr("not known");
}

}  // namespace

PassesPage::PassesPage(PassSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      recipe_(new QComboBox(this)),
      poses_(new QTableWidget(0, kColumns, this)),
      view_(named_button("drag_poses", tr("&Drag in the view"), this)),
      undo_(named_button("undo_pass", tr("&Undo"), this)),
      redo_(named_button("redo_pass", tr("R&edo"), this)),
      check_(named_button("check_passes", tr("&Can the robot do it?"), this)),
      save_(named_button("save_passes", tr("&Save into the recipe"), this)),
      reach_(text_label("pass_reach", this)),
      end_(text_label("pass_end", this)) {
  recipe_->setObjectName("pass_recipe");
  recipe_->setToolTip(tr("Whose scan program it is"));
  poses_->setObjectName("pass_poses");
  poses_->setAccessibleName(tr("Poses of the flange in each pass"));
  poses_->setToolTip(tr("Choose one: its pass can be dragged, and the view turns there"));
  poses_->setHorizontalHeaderLabels(
      {tr("Pass"), tr("Pose"), tr("x [mm]"), tr("y [mm]"), tr("z [mm]"), tr("Reachable")});
  poses_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  poses_->verticalHeader()->hide();
  poses_->setSelectionBehavior(QAbstractItemView::SelectRows);
  poses_->setSelectionMode(QAbstractItemView::SingleSelection);
  poses_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setToolTip(tr("Arrows and rings at the poses of the pass that is chosen; nothing moves"));
  check_->setToolTip(tr("Asks the cell again, from where the robot stands now"));
  save_->setToolTip(tr("The recipe then counts as made anew, not proven"));
  lay_out();
  connect(recipe_, qOverload<int>(&QComboBox::activated), this,
          [this] { Q_EMIT programWanted(recipe_->currentText()); });
  connect(poses_, &QTableWidget::itemSelectionChanged, this, &PassesPage::take_selection);
  connect(view_, &QPushButton::clicked, this, [this] { Q_EMIT toolWanted("passes"); });
  connect(undo_, &QPushButton::clicked, &session_, &PassSession::undo);
  connect(redo_, &QPushButton::clicked, &session_, &PassSession::redo);
  connect(check_, &QPushButton::clicked, this, &PassesPage::check);
  connect(save_, &QPushButton::clicked, this,
          [this] { Q_EMIT saveWanted(recipe_->currentText()); });
  connect(&session_, &PassSession::changed, this, &PassesPage::fill);
  connect(&session_, &PassSession::changed, this, &PassesPage::check);
  connect(&session_, &PassSession::reachChanged, this, &PassesPage::show_reach);
  connect(&session_, &PassSession::selectionChanged, this, &PassesPage::show_selection);
  update_buttons();
}

void PassesPage::lay_out() {
  auto* const head = new QFormLayout;
  head->addRow(tr("&Recipe"), recipe_);
  auto* const buttons = new QHBoxLayout;
  for (QPushButton* const button : {view_, undo_, redo_, check_})
    buttons->addWidget(button);
  auto* const layout = new QVBoxLayout(this);
  layout->addLayout(head);
  layout->addWidget(poses_, 1);
  layout->addLayout(buttons);
  layout->addWidget(reach_);
  layout->addWidget(save_);
  layout->addWidget(end_);
}

void PassesPage::show_recipes(const std::vector<scan_cell_msgs::RecipeState>& recipes) {
  if (list_recipes(recipes, *recipe_)) session_.open("", {});
  update_buttons();
}

void PassesPage::suggest(const QString& recipe) {
  if (choose_in_empty(*recipe_, recipe)) Q_EMIT programWanted(recipe);
}

void PassesPage::show_program(const QString& recipe,
                              const scan_cell_msgs::EditProgramResponse& program) {
  if (recipe != recipe_->currentText()) return;
  session_.open(program.frame, program.passes);
  show_end(program.passes.empty() ? tr("%1 has no scan program.").arg(recipe) : QString());
}

void PassesPage::check() {
  to_be_checked_ = !free_;
  if (free_) {
    Q_EMIT checkWanted();
    return;
  }
  const PassReach unknown{Reach::kUnknown, tr("asked once nothing is under way")};
  session_.show_reach(std::vector<PassReach>(session_.passes().size(), unknown));
}

void PassesPage::set_free(bool free) {
  free_ = free;
  if (free_ && to_be_checked_) check();
}

void PassesPage::show_checked(const std::vector<scan_cell_msgs::CheckProgramResponse>& answers) {
  std::vector<PassReach> reach;
  for (const auto& answer : answers) {
    const Reach found = answer.success != 0     ? Reach::kReachable
                        : answer.link_lost != 0 ? Reach::kUnknown
                                                : Reach::kNot;
    reach.push_back({found, QString::fromStdString(answer.message)});
  }
  session_.show_reach(reach);
}

void PassesPage::fill() {
  showing_ = true;
  rows_.clear();
  poses_->setRowCount(0);
  for (std::size_t i = 0; i < session_.passes().size(); ++i) {
    const ScanPass& pass = session_.passes()[i];
    for (std::size_t k = 0; k < pass.poses.size(); ++k) {
      const auto& at = pass.poses[k].position;
      const QString texts[] = {name_of(pass, i),  pose_name(pass, k), millimetres(at.x),
                               millimetres(at.y), millimetres(at.z),  QString()};
      const int row = static_cast<int>(rows_.size());
      poses_->setRowCount(row + 1);
      for (int column = 0; column < kColumns; ++column)
        poses_->setItem(row, column, new QTableWidgetItem(texts[column]));
      rows_.push_back({i, k});
    }
  }
  showing_ = false;
  show_reach();
  show_selection();
}

void PassesPage::show_reach() {
  QString why;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const PassReach& reach = session_.reach()[rows_[row].pass];
    poses_->item(static_cast<int>(row), kReach)->setText(mark_of(reach.reach));
    if (rows_[row].pose == 0 && !reach.why.isEmpty())
      why += (why.isEmpty() ? "" : "\n") +
             name_of(session_.passes()[rows_[row].pass], rows_[row].pass) + ": " + reach.why;
  }
  reach_->setText(why);
  update_buttons();
}

void PassesPage::show_selection() {
  showing_ = true;
  poses_->clearSelection();
  const auto& chosen = session_.selected();
  for (std::size_t row = 0; chosen && row < rows_.size(); ++row)
    if (rows_[row].pass == chosen->pass && rows_[row].pose == chosen->pose)
      poses_->selectRow(static_cast<int>(row));
  showing_ = false;
  update_buttons();
}

void PassesPage::take_selection() {
  const auto rows = poses_->selectionModel()->selectedRows();
  if (showing_ || rows.isEmpty()) return;
  const PassPose at = rows_.at(static_cast<std::size_t>(rows.first().row()));
  session_.select(at);
  const auto& place = session_.passes()[at.pass].poses[at.pose].position;
  Q_EMIT placeChosen(place.x, place.y, place.z, QString::fromStdString(session_.frame()));
}

void PassesPage::show_end(const QString& message) {
  end_->setText(message);
}

void PassesPage::update_buttons() {
  const bool is_open = !session_.passes().empty();
  view_->setEnabled(is_open);
  check_->setEnabled(is_open);
  undo_->setEnabled(session_.can_undo());
  redo_->setEnabled(session_.can_redo());
  save_->setEnabled(session_.can_undo() && !recipe_->currentText().isEmpty());
}

}  // namespace scan_cell_rviz
