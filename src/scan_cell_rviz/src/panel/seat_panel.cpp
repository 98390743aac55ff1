// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "panel/seat_panel.h"

#include <rviz/display.h>
#include <rviz/tool.h>
#include <rviz/tool_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>

#include <QEvent>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <utility>
#include <vector>

#include "seat/translation.h"
#include "view/cloud_frame.h"
#include "view/stage/displays.h"

namespace scan_cell_rviz {
namespace {

constexpr const char* kPreview = "scan_cell_rviz/WorkPreview";

struct Answer {
  QString text;
  QMessageBox::ButtonRole role;
};

/// Asks before the window closes.
/// @return index of the answer; none: keep it open
std::optional<std::size_t> ask(QWidget* parent, const QString& title, const QString& text,
                               const std::vector<Answer>& answers) {
  QMessageBox question(QMessageBox::Question, title, text, QMessageBox::NoButton, parent);
  std::vector<const QAbstractButton*> buttons;
  for (const Answer& answer : answers)
    buttons.push_back(question.addButton(answer.text, answer.role));
  question.addButton(SeatPanel::tr("&Do not close"), QMessageBox::RejectRole);
  question.exec();
  const auto clicked = std::find(buttons.begin(), buttons.end(), question.clickedButton());
  if (clicked == buttons.end()) return std::nullopt;
  return static_cast<std::size_t>(clicked - buttons.begin());
}

}  // namespace

SeatPanel::SeatPanel(QWidget* parent) : rviz::Panel(parent) {
  install_translation();  // before any text is made
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
}

void SeatPanel::onInitialize() {
  links_ = std::make_unique<SeatLinks>(NodeNames());
  seat_ = new Seat(
      *links_,
      {shared_edit_session(), shared_path_session(), shared_pick_session(), shared_pass_session()},
      this);
  views_ = std::make_unique<StageViews>(*vis_manager_);
  apply_config();
  layout()->addWidget(seat_);
  connect(seat_, &Seat::personChanged, this, &SeatPanel::configChanged);
  connect(seat_, &Seat::poseFileChanged, this, &SeatPanel::configChanged);
  connect(seat_, &Seat::placeChosen, this, &SeatPanel::look_at);
  connect(seat_, &Seat::toolWanted, this, &SeatPanel::use_tool);
  connect(seat_, &Seat::poseChosen, this, &SeatPanel::show_pose);
  connect(seat_, &Seat::runShown, this, &SeatPanel::show_run);
  connect(seat_, &Seat::pageShown, this, &SeatPanel::show_page);
  connect(seat_, &Seat::placeCame, this, &SeatPanel::fit_view_once);
  connect(seat_, &Seat::placeWanted, this, &SeatPanel::fit_view);
  connect(&shared_edit_session(), &EditSession::changed, this, &SeatPanel::fit_view_once);
  box_ = std::make_unique<BoxHandles>(shared_edit_session());
  connect(seat_, &Seat::boxWanted, box_.get(), &BoxHandles::apply);
  waypoint_ = std::make_unique<WaypointHandles>(shared_path_session());
  passes_ = std::make_unique<PassHandles>(shared_pass_session());
  window()->installEventFilter(this);
  links_->start();
}

void SeatPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  config.mapGetString("Person", &person_);
  config.mapGetString("Pose File", &pose_file_);
  kept_views_.copy(config.mapGetChild("Views by Page"));
  if (seat_ != nullptr) apply_config();
}

void SeatPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  if (seat_ == nullptr) return;
  config.mapSetValue("Person", seat_->person());
  config.mapSetValue("Pose File", seat_->pose_file());
  views_->save(config.mapMakeChild("Views by Page"));
}

void SeatPanel::apply_config() {
  seat_->set_person(person_);
  if (!pose_file_.isEmpty()) seat_->set_pose_file(pose_file_);
  views_->load(kept_views_);
  views_->show(seat_->page());
}

bool SeatPanel::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Close && object == window() && !may_close()) {
    event->ignore();
    return true;
  }
  return rviz::Panel::eventFilter(object, event);
}

/// Shows a topic if no display does; its visibility depends on the page.
void SeatPanel::show_topic(const QString& type, const char* name, const char* property,
                           const std::string& topic) {
  display_of(*vis_manager_, type, name).subProp(property)->setValue(QString::fromStdString(topic));
}

void SeatPanel::show_handles(const char* name, const std::string& topic) {
  show_topic("rviz/InteractiveMarkers", name, "Update Topic", topic + "/update");
}

void SeatPanel::show_path() {
  display_of(*vis_manager_, "scan_cell_rviz/EditedPath", "path edited by hand", true)
      .setEnabled(true);
  show_handles(display_names::kWaypoint, waypoint_->topic());
  waypoint_->show();
}

void SeatPanel::show_pose(int pose) {
  if (seat_->page() != Page::kWork) return;  // another seat's preview
  rviz::Display& preview = display_of(*vis_manager_, kPreview, "what the robot would do", true);
  preview.subProp("Run")->setValue(run_);
  preview.subProp("Pose")->setValue(pose);
}

/// Previews of other runs are not drawn.
void SeatPanel::show_run(const QString& run) {
  run_ = run;
  for_each_display(*vis_manager_, [&run](rviz::Display& display) {
    if (display.getClassId() == kPreview) display.subProp("Run")->setValue(run);
  });
}

/// @param name of a tool of this package, such as polygon; box, passes and view use rviz's default
/// tool, which drags handles
void SeatPanel::use_tool(const QString& name) {
  rviz::ToolManager* const tools = vis_manager_->getToolManager();
  if (name == "box") {
    show_handles(display_names::kBox, box_->topic());
    box_->show();
  }
  if (name == "waypoint") show_path();
  if (name == "passes") show_handles(display_names::kPoses, passes_->handles());
  if (name == "view") box_->hide();
  if (name == "box" || name == "passes" || name == "view")
    return tools->setCurrentTool(tools->getDefaultTool());
  const QString wanted = "scan_cell_rviz/" + name.left(1).toUpper() + name.mid(1);
  for (int i = 0; i < tools->numTools(); ++i)
    if (tools->getTool(i)->getClassId() == wanted) return tools->setCurrentTool(tools->getTool(i));
  tools->setCurrentTool(tools->addTool(wanted));
}

/// Deselects the tool: it must not edit a scan that is not in view.
void SeatPanel::show_page(Page page) {
  use_tool("view");
  views_->show(page, !seat_->is_free());
  passes_->show(page == Page::kPasses);
  if (page == Page::kPath) show_path();
  if (page == Page::kPasses)
    show_topic("rviz/MarkerArray", display_names::kPasses, "Marker Topic", passes_->topic());
  if (page == Page::kDesign) {
    const std::string recipes = NodeNames().recipes;
    for (const auto& [name, topic] : {std::pair(display_names::kDesignReference, "/reference"),
                                      std::pair(display_names::kDesignPicks, "/picks"),
                                      std::pair(display_names::kDesign, "/designed_path")})
      show_topic("rviz/Marker", name, "Marker Topic", recipes + topic);
  }
  fit_view_once();
}

void SeatPanel::fit_view() {
  if (const auto place = seat_->place()) views_->fit(*place);
}

/// Fits the view unless a person has chosen one. The first page and the teach page are about the
/// whole cell.
void SeatPanel::fit_view_once() {
  const Page page = seat_->page();
  if (page != Page::kPart && page != Page::kTeach && !views_->has_view()) fit_view();
}

/// Turns the view; if rviz does not know the frame, it stays.
void SeatPanel::look_at(double x, double y, double z, const QString& frame) {
  const auto pose = frame_in_view(*vis_manager_, frame.toStdString());
  if (pose)
    vis_manager_->getViewManager()->getCurrent()->lookAt(pose->position +
                                                         pose->orientation * to_ogre({x, y, z}));
}

/// Asks before a person's edits are lost.
bool SeatPanel::may_lose_edits() {
  const QStringList unsaved = seat_->unsaved();
  return unsaved.isEmpty() ||
         ask(this, tr("Edits are not saved"), tr("Not saved: %1.").arg(unsaved.join(", ")),
             {{tr("&Close without them"), QMessageBox::DestructiveRole}})
             .has_value();
}

bool SeatPanel::may_close() {
  if (seat_ == nullptr) return true;
  if (!may_lose_edits()) return false;
  if (!seat_->is_busy()) return true;
  const auto answer =
      ask(this, tr("The cell is at work"), tr("What this seat began is still under way."),
          {{tr("&Stop it and close"), QMessageBox::AcceptRole},
           {tr("&Leave it running and close"), QMessageBox::DestructiveRole}});
  if (answer == 0) links_->cell.stop();
  return answer.has_value();
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::SeatPanel, rviz::Panel)
