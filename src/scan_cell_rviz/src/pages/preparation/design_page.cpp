// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pages/preparation/design_page.h"

#include <tf2_eigen/tf2_eigen.h>

#include <QFormLayout>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>
#include <cmath>

#include "scan_cell_common/pose/units.h"
#include "widgets/labels_and_buttons.h"
#include "widgets/recipe_box.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::DesignPathRequest;
using scan_cell_msgs::DesignPathResponse;

constexpr std::size_t kFewest = 2;  // picks for a path

/// [m] along all segments
double length_of(const scan_cell_msgs::ToolPath& path) {
  double length = 0;
  for (const auto& segment : path.segments)
    for (std::size_t i = 1; i < segment.waypoints.size(); ++i) {
      const auto& one = segment.waypoints[i - 1].pose.position;
      const auto& other = segment.waypoints[i].pose.position;
      length += std::hypot(other.x - one.x, other.y - one.y, other.z - one.z);
    }
  return length;
}

QString words_of(const DesignPathResponse& answer) {
  std::size_t waypoints = 0;
  for (const auto& segment : answer.path.segments)
    waypoints += segment.waypoints.size();
  QString words = DesignPage::tr("%1 waypoints in %2 segments, %3 mm long")
                      .arg(waypoints)
                      .arg(answer.path.segments.size())
                      .arg(length_of(answer.path) * scan_cell_common::kMillimetres, 0, 'f', 1);
  for (const std::string& note : answer.notes)
    words += "\n" + QString::fromStdString(note);
  return words;
}

}  // namespace

DesignPage::DesignPage(PickSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      recipe_(new QComboBox(this)),
      way_(new QComboBox(this)),
      count_(text_label("pick_count", this)),
      pick_(named_button("path_tool_pick", tr("Pic&k in the view"), this)),
      view_(named_button("design_view", tr("&View"), this)),
      undo_(named_button("undo_pick", tr("&Undo"), this)),
      redo_(named_button("redo_pick", tr("R&edo"), this)),
      clear_(named_button("clear_picks", tr("&Clear"), this)),
      form_(new ParameterForm(this)),
      make_(named_button("make_path", tr("&Make the path"), this)),
      name_(new QLineEdit(this)),
      save_(named_button("save_design", tr("Save as a ne&w recipe"), this)),
      end_(text_label("design_end", this)) {
  recipe_->setObjectName("design_recipe");
  recipe_->setToolTip(tr("Whose reference the path is made on"));
  way_->setObjectName("design_way");
  way_->addItem(tr("through picked places"), DesignPathRequest::PICKS);
  way_->addItem(tr("along the edge"), DesignPathRequest::EDGE);
  way_->addItem(tr("a raster"), DesignPathRequest::SLICES);
  pick_->setToolTip(tr("Clicks on the reference become places of the path, in their order"));
  view_->setToolTip(tr("The mouse turns the view"));
  name_->setObjectName("design_name");
  name_->setToolTip(tr("Of the new recipe and its folder"));
  save_->setToolTip(
      tr("A recipe as the one above, but with this path; it counts as made, not proven"));
  lay_out();
  connect(recipe_, qOverload<int>(&QComboBox::activated), this, &DesignPage::choose_recipe);
  connect(way_, qOverload<int>(&QComboBox::activated), this, &DesignPage::choose);
  connect(pick_, &QPushButton::clicked, this, [this] { Q_EMIT toolWanted("pick"); });
  connect(view_, &QPushButton::clicked, this, [this] { Q_EMIT toolWanted("view"); });
  connect(undo_, &QPushButton::clicked, &session_, &PickSession::undo);
  connect(redo_, &QPushButton::clicked, &session_, &PickSession::redo);
  connect(clear_, &QPushButton::clicked, &session_, &PickSession::clear);
  connect(make_, &QPushButton::clicked, this, [this] { ask(true); });
  connect(save_, &QPushButton::clicked, this, [this] { ask(true, name_->text().trimmed()); });
  connect(name_, &QLineEdit::textChanged, this, [this] { update_buttons(); });
  connect(&session_, &PickSession::changed, this, &DesignPage::follow_picks);
  update_buttons();
}

void DesignPage::lay_out() {
  auto* const head = new QFormLayout;
  head->addRow(tr("&Reference of"), recipe_);
  head->addRow(tr("W&ay"), way_);
  auto* const tools = new QHBoxLayout;
  for (QPushButton* const button : {pick_, view_, undo_, redo_, clear_})
    tools->addWidget(button);
  auto* const scrolled = new QScrollArea(this);
  scrolled->setWidgetResizable(true);
  scrolled->setWidget(form_);
  auto* const saving = new QFormLayout;
  saving->addRow(tr("&Name"), name_);
  auto* const layout = new QVBoxLayout(this);
  layout->addLayout(head);
  layout->addWidget(count_);
  layout->addLayout(tools);
  layout->addWidget(scrolled, 1);
  layout->addWidget(make_);
  layout->addWidget(end_);
  layout->addLayout(saving);
  layout->addWidget(save_);
}

unsigned char DesignPage::way() const {
  return static_cast<unsigned char>(way_->currentData().toUInt());
}

void DesignPage::show_recipes(const std::vector<scan_cell_msgs::RecipeState>& recipes) {
  if (list_recipes(recipes, *recipe_)) choose_recipe();
  update_buttons();
}

void DesignPage::suggest(const QString& recipe) {
  if (choose_in_empty(*recipe_, recipe)) choose_recipe();
}

/// Picks on another reference are useless.
void DesignPage::choose_recipe() {
  if (recipe_->currentText() != chosen_) {
    chosen_ = recipe_->currentText();
    session_.close();
  }
  if (!chosen_.isEmpty()) choose();
}

/// Chooses another reference, or another kind of path.
void DesignPage::choose() {
  end_->clear();
  ask(false);
  update_buttons();
}

/// Updates the path after each pick.
void DesignPage::follow_picks() {
  update_buttons();
  if (way() == DesignPathRequest::PICKS && !recipe_->currentText().isEmpty())
    ask(session_.picks().size() >= kFewest);
}

void DesignPage::ask(bool make, const QString& save_as) {
  DesignPathRequest request;
  request.recipe = recipe_->currentText().toStdString();
  request.way = way();
  request.make = static_cast<unsigned char>(make);
  for (const auto& [name, value] : form_->given()) {
    request.parameter_names.push_back(name);
    request.parameter_values.push_back(value);
  }
  if (request.way == DesignPathRequest::PICKS)
    for (const Eigen::Vector3d& pick : session_.picks())
      request.picks.push_back(tf2::toMsg(pick));
  request.save_as = save_as.toStdString();
  saving_ = saving_ || !save_as.isEmpty();
  update_buttons();
  Q_EMIT designWanted(request);
}

void DesignPage::show_answer(const DesignPathRequest& request, const DesignPathResponse& answer) {
  const bool was_saved = !request.save_as.empty();
  const bool is_in_view = request.recipe == recipe() && request.way == way();
  if (is_in_view && !answer.parameters.empty()) form_->show_parameters(answer.parameters);
  if (was_saved) saving_ = false;
  if (answer.success == 0) {
    if (is_in_view || was_saved) end_->setText(QString::fromStdString(answer.message));
  } else if (was_saved) {
    end_->setText(tr("Saved as %1: prove it, then scan a part.")
                      .arg(QString::fromStdString(request.save_as)) +
                  "\n" + words_of(answer));
    Q_EMIT recipeMade();
  } else if (is_in_view) {
    end_->setText(request.make != 0 ? words_of(answer) : QString());
  }
  update_buttons();
}

void DesignPage::show_end(const QString& message) {
  end_->setText(message);
  saving_ = false;
  update_buttons();
}

void DesignPage::update_buttons() {
  const bool chosen = !recipe_->currentText().isEmpty();
  const bool by_picks = way() == DesignPathRequest::PICKS;
  const std::size_t picks = session_.picks().size();
  const bool may_make = chosen && (!by_picks || picks >= kFewest);
  way_->setEnabled(chosen);
  pick_->setEnabled(chosen && by_picks);
  undo_->setEnabled(by_picks && picks > 0);
  clear_->setEnabled(by_picks && picks > 0);
  redo_->setEnabled(by_picks && session_.can_redo());
  make_->setEnabled(may_make);
  save_->setEnabled(may_make && !saving_ && !name_->text().trimmed().isEmpty());
  count_->setText(!chosen    ? tr("Choose the recipe whose reference it is.")
                  : by_picks ? tr("%1 places picked").arg(picks)
                             : QString());
}

}  // namespace scan_cell_rviz
