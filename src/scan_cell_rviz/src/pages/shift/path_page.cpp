// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/shift/path_page.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QVBoxLayout>
#include <algorithm>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "tool_path_stretcher/ros/conversions.h"
#include "widgets/labels_and_buttons.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_common::kDegree;
using scan_cell_common::kMillimetre;
using tool_paths::EditFrame;

constexpr double kFarthest = 1000;  // [mm] of a move; chosen

}  // namespace

PathPage::PathPage(PathSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      count_(text_label("path_count", this)),
      table_(new PathTable(session, this)),
      waypoints_(new QTableView(this)),
      frame_(new QComboBox(this)),
      move_(named_button("move_waypoints", tr("&Move"), this)),
      axis_(new QComboBox(this)),
      turn_(named_button("turn_waypoints", tr("Tu&rn"), this)),
      name_(new QComboBox(this)),
      set_(named_button("set_value", tr("&Set"), this)),
      add_(named_button("add_waypoint", tr("&Add after"), this)),
      delete_(named_button("delete_waypoints", tr("&Delete"), this)),
      edits_(new QListWidget(this)),
      undo_(named_button("undo_path", tr("&Undo"), this)),
      redo_(named_button("redo_path", tr("R&edo"), this)),
      drop_(named_button("drop_path_edits", tr("Dr&op all"), this)),
      note_(new QLineEdit(this)),
      save_(named_button("save_path", tr("Make it a run of its o&wn"), this)),
      end_(text_label("path_end", this)) {
  waypoints_->setObjectName("path_waypoints");
  waypoints_->setAccessibleName(tr("Waypoints of the adapted path"));
  waypoints_->setToolTip(tr("Choose one, or a row of them with Shift; the view turns there"));
  waypoints_->setModel(table_);
  waypoints_->setSelectionBehavior(QAbstractItemView::SelectRows);
  waypoints_->setSelectionMode(QAbstractItemView::ContiguousSelection);
  waypoints_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  edits_->setObjectName("path_edits");
  edits_->setAccessibleName(tr("Edits of the path in force"));
  note_->setObjectName("path_note");
  note_->setToolTip(tr("Why; kept with the run"));
  save_->setToolTip(
      tr("Adapts the part again from its files, does the edits, and makes programs and report: "
         "a new run, which needs a dry run of its own"));
  add_->setToolTip(tr("Half way to the next one of its segment; after the last one, where it is"));
  lay_out();
  connect(waypoints_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { take_selection(); });
  connect(move_, &QPushButton::clicked, this, &PathPage::move);
  connect(turn_, &QPushButton::clicked, this, &PathPage::turn);
  connect(set_, &QPushButton::clicked, this, &PathPage::set_value);
  connect(add_, &QPushButton::clicked, this, [this] {
    const std::size_t after = session_.selected()->last;
    session_.add(tool_paths::AddEdit{after});
    session_.select(tool_paths::WaypointRange{after + 1, after + 1});
  });
  connect(delete_, &QPushButton::clicked, this,
          [this] { session_.add(tool_paths::DeleteEdit{*session_.selected()}); });
  connect(undo_, &QPushButton::clicked, &session_, &PathSession::undo);
  connect(redo_, &QPushButton::clicked, &session_, &PathSession::redo);
  connect(drop_, &QPushButton::clicked, &session_, &PathSession::drop_all);
  connect(save_, &QPushButton::clicked, this,
          [this] { Q_EMIT saveWanted(run_, session_.yaml(), note_->text()); });
  connect(&session_, &PathSession::changed, this, &PathPage::show_session);
  connect(&session_, &PathSession::selectionChanged, this, &PathPage::show_selection);
  connect(&session_, &PathSession::failed, this, &PathPage::show_end);
  show_session();
}

QDoubleSpinBox* PathPage::number_box(const char* name, double range, int decimals,
                                     const QString& unit, const QString& meaning) {
  auto* const box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setRange(-range, range);
  box->setDecimals(decimals);
  box->setSuffix(unit);
  box->setToolTip(meaning);
  return box;
}

QLayout* PathPage::move_row() {
  auto* const row = new QHBoxLayout;
  for (std::size_t axis = 0; axis < by_.size(); ++axis) {
    const char letter = static_cast<char>('x' + axis);
    const std::string name = std::string("move_") + letter;
    by_[axis] = number_box(name.c_str(), kFarthest, 2, tr(" mm"),
                           tr("Along %1 (-1000 to 1000 mm)").arg(letter));
    row->addWidget(by_[axis]);
  }
  row->addWidget(move_);
  return row;
}

QLayout* PathPage::turn_row() {
  axis_->setObjectName("turn_axis");
  for (const char* axis : {"x", "y", "z"})
    axis_->addItem(tr("about %1").arg(axis));
  angle_ = number_box("turn_angle", 180, 2, tr("\u00b0"), tr("Right-handed (-180 to 180 degrees)"));
  auto* const row = new QHBoxLayout;
  for (QWidget* const widget :
       {static_cast<QWidget*>(axis_), static_cast<QWidget*>(angle_), static_cast<QWidget*>(turn_)})
    row->addWidget(widget);
  return row;
}

QLayout* PathPage::value_row() {
  name_->setObjectName("value_name");
  name_->setEditable(true);
  name_->setToolTip(
      tr("Process value, such as speed or an output. A value that the path does not have yet is "
         "first set to 0 for all waypoints except the selected ones"));
  constexpr double kMost = 1e9;  // beyond any process
  value_ = number_box("value", kMost, 4, "", tr("As the path's file has it, without a unit"));
  auto* const row = new QHBoxLayout;
  for (QWidget* const widget :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(value_), static_cast<QWidget*>(set_)})
    row->addWidget(widget);
  return row;
}

void PathPage::lay_out() {
  frame_->setObjectName("edit_frame");
  frame_->addItems({tr("Axes of the tool at each waypoint"), tr("Axes of the path's frame")});
  QPushButton* const pick = named_button("tool_waypoint", tr("&Pick in the view"), this);
  pick->setToolTip(tr("Click a waypoint in the view; its handles move and turn it"));
  connect(pick, &QPushButton::clicked, this, [this] { Q_EMIT toolWanted("waypoint"); });
  QPushButton* const view = named_button("path_tool_view", tr("&View"), this);
  view->setToolTip(tr("The mouse turns the view, and drags the handles of the waypoint"));
  connect(view, &QPushButton::clicked, this, [this] { Q_EMIT toolWanted("view"); });
  auto* const acts = new QHBoxLayout;
  for (QPushButton* const button : {pick, view, add_, delete_})
    acts->addWidget(button);
  auto* const form = new QFormLayout;
  form->addRow(tr("A&xes"), frame_);
  form->addRow(tr("By"), move_row());
  form->addRow(tr("Angle"), turn_row());
  form->addRow(tr("Value"), value_row());
  auto* const buttons = new QHBoxLayout;
  for (QPushButton* const button : {undo_, redo_, drop_})
    buttons->addWidget(button);
  auto* const saving = new QFormLayout;
  saving->addRow(tr("&Note"), note_);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(count_);
  layout->addWidget(waypoints_, 2);
  layout->addLayout(acts);
  layout->addLayout(form);
  layout->addWidget(edits_, 1);
  layout->addLayout(buttons);
  layout->addLayout(saving);
  layout->addWidget(save_);
  layout->addWidget(end_);
}

/// Restores the edits made to the path of a run before.
void PathPage::show_run(const scan_cell_msgs::DescribeRunResponse& run) {
  const QString id = QString::fromStdString(run.run.id);
  if (id == run_ && session_.is_open()) return;
  if (session_.is_open()) kept_[run_] = session_.edits();
  run_ = id;
  try {
    session_.open(tool_path_stretcher::from_message(run.path), run.expected_errors, run.frame);
    if (session_.is_open()) session_.add(kept_[run_]);
  } catch (const scan_cell_common::Error& error) {
    session_.close();
    show_end(QString::fromStdString(error.what()));
  }
}

EditFrame PathPage::frame() const {
  return frame_->currentIndex() == 0 ? EditFrame::kTool : EditFrame::kPath;
}

void PathPage::move() {
  const Eigen::Vector3d by(by_[0]->value(), by_[1]->value(), by_[2]->value());
  session_.add(tool_paths::MoveEdit{*session_.selected(), by * kMillimetre, frame()});
}

void PathPage::turn() {
  session_.add(tool_paths::TurnEdit{*session_.selected(),
                                    Eigen::Vector3d::Unit(axis_->currentIndex()),
                                    angle_->value() * kDegree, frame()});
}

void PathPage::set_value() {
  const std::string name = name_->currentText().trimmed().toStdString();
  const auto& names = session_.edited().path.process_names;
  std::vector<tool_paths::PathEdit> edits;
  if (std::find(names.begin(), names.end(), name) == names.end())
    edits.push_back(tool_paths::SetEdit{{0, session_.waypoints().size() - 1}, {{name, 0}}});
  edits.push_back(tool_paths::SetEdit{*session_.selected(), {{name, value_->value()}}});
  session_.add(edits);
}

void PathPage::take_selection() {
  if (showing_) return;
  const QModelIndexList rows = waypoints_->selectionModel()->selectedRows();
  if (rows.isEmpty()) return session_.select(std::nullopt);
  const auto [first, last] = std::minmax_element(
      rows.begin(), rows.end(),
      [](const auto& one, const auto& other) { return one.row() < other.row(); });
  session_.select(tool_paths::WaypointRange{static_cast<std::size_t>(first->row()),
                                            static_cast<std::size_t>(last->row())});
  const Eigen::Vector3d at = session_.waypoints()[session_.selected()->last].pose.translation();
  Q_EMIT placeChosen(at.x(), at.y(), at.z(), QString::fromStdString(session_.frame()));
}

/// Shows the selection made in the view, or left by edits.
void PathPage::show_selection() {
  showing_ = true;
  QItemSelection rows;
  if (const auto& range = session_.selected()) {
    const auto row = [this](std::size_t number) {
      return table_->index(static_cast<int>(number), 0);
    };
    rows.select(row(range->first), row(range->last));
    waypoints_->scrollTo(row(range->last));
  }
  waypoints_->selectionModel()->select(
      rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  showing_ = false;
  update_buttons();
}

void PathPage::show_session() {
  const QString kept = name_->currentText();
  QStringList names;
  for (const std::string& name : session_.edited().path.process_names)
    if (name != tool_paths::kEditedValue) names.append(QString::fromStdString(name));
  name_->clear();
  name_->addItems(names);
  if (!kept.isEmpty()) name_->setCurrentText(kept);
  edits_->clear();
  edits_->addItems(session_.words());
  count_->setText(session_.is_open() ? tr("%1 waypoints").arg(session_.waypoints().size())
                                     : tr("No adapted path is in view: choose an accepted run."));
  end_->clear();
  show_selection();
}

void PathPage::update_buttons() {
  const bool chosen = session_.selected().has_value();
  for (QPushButton* const button : {move_, set_, add_, delete_})
    button->setEnabled(chosen);
  turn_->setEnabled(chosen && session_.edited().path.has_orientation);
  undo_->setEnabled(session_.can_undo());
  drop_->setEnabled(session_.can_undo());
  redo_->setEnabled(session_.can_redo());
  save_->setEnabled(free_ && session_.can_undo());
}

void PathPage::set_free(bool free) {
  free_ = free;
  update_buttons();
}

void PathPage::show_end(const QString& message) {
  end_->setText(message);
}

}  // namespace scan_cell_rviz
