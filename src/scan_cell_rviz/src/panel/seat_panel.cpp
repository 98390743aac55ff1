// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "panel/seat_panel.h"

#include <OgreQuaternion.h>
#include <OgreVector3.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/frame_manager.h>
#include <rviz/tool.h>
#include <rviz/tool_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>

#include <QEvent>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>
#include <vector>

#include "seat/translation.h"

namespace scan_cell_rviz {

SeatPanel::SeatPanel(QWidget* parent) : rviz::Panel(parent) {
  install_translation();  // before there is any text
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

/// The display that is there, as of a saved configuration; null: there is none.
/// @param name where there may be several of the type; empty: any
rviz::Display* SeatPanel::found_display(const QString& type, const QString& name) {
  std::vector<rviz::DisplayGroup*> groups = {vis_manager_->getRootDisplayGroup()};
  while (!groups.empty()) {
    rviz::DisplayGroup* const group = groups.back();
    groups.pop_back();
    for (int i = 0; i < group->numDisplays(); ++i) {
      rviz::Display* const display = group->getDisplayAt(i);
      if (display->getClassId() == type && (name.isEmpty() || display->getName() == name))
        return display;
      if (rviz::DisplayGroup* const inner = group->getGroupAt(i)) groups.push_back(inner);
    }
  }
  return nullptr;
}

/// The display that is there, or a new one.
rviz::Display* SeatPanel::display_of(const QString& type, const QString& name,
                                     const QString& title) {
  rviz::Display* const found = found_display(type, name);
  return found != nullptr ? found : vis_manager_->createDisplay(type, title, true);
}

/// Shows a topic, or hides it where it is shown.
void SeatPanel::show_topic(const TopicDisplay& topic, bool shown) {
  rviz::Display* const display = shown ? display_of(topic.type, topic.title, topic.title)
                                       : found_display(topic.type, topic.title);
  if (display == nullptr) return;
  display->subProp(topic.property)->setValue(topic.topic);
  display->setEnabled(shown);
}

void SeatPanel::show_handles(const QString& title, const std::string& topic) {
  rviz::Display* const display = display_of("rviz/InteractiveMarkers", title, title);
  display->subProp("Update Topic")->setValue(QString::fromStdString(topic + "/update"));
}

void SeatPanel::show_path() {
  display_of("scan_cell_rviz/EditedPath", {}, tr("path edited by hand"))->setEnabled(true);
  show_handles(tr("waypoint of the seat"), waypoint_->topic());
  waypoint_->show();
}

void SeatPanel::show_pose(int pose) {
  rviz::Display* const display =
      display_of("scan_cell_rviz/WorkPreview", {}, tr("what the robot would do"));
  display->setEnabled(true);
  display->subProp("Pose")->setValue(pose);
}

/// The reference, the picks and the path through them; only beside their page, for the reference
/// would lie over the part.
void SeatPanel::show_design(bool shown) {
  show_topic({"rviz/Marker", "Marker Topic", "/part_recipes/reference", tr("new path, reference")},
             shown);
  show_topic({"rviz/Marker", "Marker Topic", "/part_recipes/picks", tr("new path, picks")}, shown);
  show_topic({"rviz/Path", "Topic", "/part_recipes/designed_path", tr("new path")}, shown);
}

/// Only beside their page: they lie over the part.
void SeatPanel::show_passes(bool shown) {
  show_topic({"rviz/MarkerArray", "Marker Topic", QString::fromStdString(passes_->topic()),
              tr("passes of the scan")},
             shown);
  passes_->show(shown);
}

/// @param name of a tool of this package, such as polygon; box, passes and view go with rviz's own,
/// which drags handles
void SeatPanel::use_tool(const QString& name) {
  rviz::ToolManager* const tools = vis_manager_->getToolManager();
  if (name == "box") {
    show_handles(tr("box of the seat"), box_->topic());
    box_->show();
  }
  if (name == "waypoint") show_path();
  if (name == "passes") show_handles(tr("poses of the pass"), passes_->handles());
  if (name == "view") box_->hide();
  if (name == "box" || name == "passes" || name == "view")
    return tools->setCurrentTool(tools->getDefaultTool());
  const QString wanted = "scan_cell_rviz/" + name.left(1).toUpper() + name.mid(1);
  for (int i = 0; i < tools->numTools(); ++i)
    if (tools->getTool(i)->getClassId() == wanted) return tools->setCurrentTool(tools->getTool(i));
  tools->setCurrentTool(tools->addTool(wanted));
}

void SeatPanel::show_page(Page page) {
  views_->show(page);
  show_design(page == Page::kDesign);
  show_passes(page == Page::kPasses);
  fit_view_once();
}

void SeatPanel::fit_view() {
  if (const auto place = seat_->place()) views_->fit(*place);
}

/// As long as nobody has chosen from where the page is seen. The first page and the robot's are
/// about the cell.
void SeatPanel::fit_view_once() {
  const Page page = seat_->page();
  if (page != Page::kPart && page != Page::kTeach && !views_->has_view()) fit_view();
}

/// Turns the view; where the frame is not known to rviz, it stays.
void SeatPanel::look_at(double x, double y, double z, const QString& frame) {
  Ogre::Vector3 origin;
  Ogre::Quaternion turn;
  rviz::ViewController* const view = vis_manager_->getViewManager()->getCurrent();
  if (view == nullptr || !vis_manager_->getFrameManager()->getTransform(frame.toStdString(),
                                                                        ros::Time(), origin, turn))
    return;
  const Ogre::Vector3 place(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  view->lookAt(origin + turn * place);
}

bool SeatPanel::may_close() {
  if (seat_ == nullptr || !seat_->is_busy()) return true;
  QMessageBox question(QMessageBox::Question, tr("The cell is at work"),
                       tr("What this seat began is still under way."), QMessageBox::NoButton, this);
  QPushButton* const stop = question.addButton(tr("&Stop it and close"), QMessageBox::AcceptRole);
  QPushButton* const leave =
      question.addButton(tr("&Leave it running and close"), QMessageBox::DestructiveRole);
  question.addButton(tr("&Do not close"), QMessageBox::RejectRole);
  question.exec();
  if (question.clickedButton() == stop) {
    links_->cell.stop();
    return true;
  }
  return question.clickedButton() == leave;
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::SeatPanel, rviz::Panel)
