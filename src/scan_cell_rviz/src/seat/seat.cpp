// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "seat/seat.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QUrl>
#include <QVBoxLayout>

#include "scan_cell_common/ros/cloud_messages.h"
#include "widgets/labels_and_buttons.h"
#include "widgets/scrolled.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RunRecipeResult;

constexpr int kPerMille = 1000;
constexpr int kTroubleLines = 3;  // chosen

QString id_of(const RunRecipeResult& result) {
  return QFileInfo(QString::fromStdString(result.folder)).fileName();
}

}  // namespace

Seat::Seat(SeatLinks& links, const SeatSessions& sessions, QWidget* parent)
    : QWidget(parent),
      link_(links.cell),
      designs_(links.design),
      pass_link_(links.passes),
      edits_(sessions.edits),
      path_session_(sessions.path),
      picks_(sessions.picks),
      pass_session_(sessions.passes),
      band_(new Band(this)),
      pages_(new QTabWidget(this)),
      part_(new PartPage(this)),
      clean_(new CleanPage(sessions.edits, this)),
      fit_(new FitPage(this)),
      path_(new PathPage(sessions.path, this)),
      work_(new WorkPage(this)),
      history_(new HistoryPage(this)),
      teach_(new TeachPage(links.teach, this)),
      design_(new DesignPage(sessions.picks, this)),
      passes_(new PassesPage(sessions.passes, this)),
      doing_(text_label("doing", this)),
      progress_(new QProgressBar(this)),
      stop_(new QPushButton(tr("S&top"), this)),
      look_(named_button("look", tr("F&it the view"), this)),
      trouble_(text_label("trouble", this)) {
  look_->setToolTip(tr("Brings what the page is about into the middle of the 3D view"));
  pages_->setObjectName("pages");
  pages_->setStyleSheet("QTabBar::tab { padding: 4px 5px; }");  // all nine are in view
  pages_->addTab(scrolled_page(part_, this), tr("&1 Part"));
  pages_->addTab(scrolled_page(clean_, this), tr("&2 Clean"));
  pages_->addTab(scrolled_page(fit_, this), tr("&3 Fit"));
  pages_->addTab(scrolled_page(path_, this), tr("&4 Path"));
  pages_->addTab(scrolled_page(work_, this), tr("&5 Work"));
  pages_->addTab(scrolled_page(history_, this), tr("&6 History"));
  pages_->addTab(scrolled_page(teach_, this), tr("&7 Teach"));
  pages_->addTab(scrolled_page(design_, this), tr("&8 New path"));
  pages_->addTab(scrolled_page(passes_, this), tr("&9 Passes"));
  progress_->setObjectName("progress");
  progress_->setMaximum(kPerMille);
  stop_->setObjectName("stop");
  stop_->setToolTip(tr("Stops the robot and ends what is under way. It is not an emergency stop."));

  auto* const under_way = new QHBoxLayout;
  under_way->addWidget(progress_, 1);
  under_way->addWidget(stop_);
  under_way->addWidget(look_);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(band_);
  layout->addWidget(doing_);
  layout->addLayout(under_way);
  layout->addWidget(pages_, 1);
  layout->addWidget(in_lines(trouble_, kTroubleLines, this));

  connect_link();
  connect_pages();
  connect_clean();
  connect_path();
  connect_design();
  connect_passes();
  show_busy(link_.busy());
  tell(QString());
}

void Seat::show_page(Page page) {
  pages_->setCurrentIndex(static_cast<int>(page));
}

/// Also notes that the view waits for the run.
void Seat::open_run(const QString& run) {
  run_is_awaited_ = true;
  link_.describe(run);
}

void Seat::connect_link() {
  connect(&link_, &CellLink::signChanged, band_, &Band::show_sign);
  connect(&link_, &CellLink::busyChanged, this, &Seat::show_busy);
  connect(&link_, &CellLink::recipesListed, part_, &PartPage::show_recipes);
  connect(&link_, &CellLink::recipesListed, design_, &DesignPage::show_recipes);
  connect(&link_, &CellLink::recipesListed, passes_, &PassesPage::show_recipes);
  connect(&link_, &CellLink::recipesMissed, part_, &PartPage::show_missed);
  connect(&link_, &CellLink::runsListed, history_, &HistoryPage::show_runs);
  connect(&link_, &CellLink::progressed, this, &Seat::show_progress);
  connect(&link_, &CellLink::failed, this, [this](const QString& message) {
    run_is_awaited_ = false;
    tell(message);
  });
  connect(&link_, &CellLink::runEnded, this, &Seat::show_end);
  connect(&link_, &CellLink::failed, work_, &WorkPage::give_up_preview);
  connect(&link_, &CellLink::previewed, work_, &WorkPage::show_preview);
  connect(&link_, &CellLink::limitsCame, work_, &WorkPage::set_limits);
  connect(&link_, &CellLink::decided, &link_, &CellLink::describe);
  connect(&link_, &CellLink::described, this, [this](const auto& run) {
    fit_->show_run(run);
    path_->show_run(run);
    work_->show_run(run);
    run_is_awaited_ = false;
    Q_EMIT runShown(QString::fromStdString(run.run.id));
    Q_EMIT placeCame();
  });
}

void Seat::connect_pages() {
  connect(part_, &PartPage::refreshWanted, this, [this] {
    tell(QString());
    link_.list_recipes();
  });
  connect(part_, &PartPage::runWanted, this, [this](const QString& recipe, const QString& note) {
    tell(QString());
    link_.run(recipe, note);
  });
  connect(fit_, &FitPage::decisionWanted, &link_, &CellLink::decide);
  connect(fit_, &FitPage::decisionWanted, this, &Seat::personChanged);
  connect(fit_, &FitPage::placeChosen, this, &Seat::placeChosen);
  connect(fit_, &FitPage::reportWanted, this, [this](const QString& file) {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(file)))
      tell(tr("No program here opens %1").arg(file));
  });
  connect(work_, &WorkPage::workWanted, this, [this](const QString& run, bool dry) {
    tell(QString());
    link_.work(run, dry);
  });
  connect(work_, &WorkPage::previewWanted, this, [this](const QString& run, bool dry) {
    tell(QString());
    link_.preview(run, dry);
  });
  connect(work_, &WorkPage::poseChosen, this, &Seat::poseChosen);
  connect(work_, &WorkPage::placeChosen, this, &Seat::placeChosen);
  connect(teach_, &TeachPage::fileChanged, this, &Seat::poseFileChanged);
  connect(history_, &HistoryPage::refreshWanted, &link_, &CellLink::list_runs);
  connect(history_, &HistoryPage::runChosen, this, [this](const QString& run) {
    open_run(run);
    show_page(Page::kFit);
  });
  connect(pages_, &QTabWidget::currentChanged, this, [this] {
    if (page() == Page::kHistory) link_.list_runs();
    if (page() == Page::kDesign) design_->suggest(part_->chosen());
    if (page() == Page::kPasses) passes_->suggest(part_->chosen());
    Q_EMIT pageShown(page());
  });
  connect(stop_, &QPushButton::clicked, &link_, &CellLink::stop);
  connect(look_, &QPushButton::clicked, this, &Seat::placeWanted);
}

void Seat::connect_clean() {
  // In the link's thread: millions of points are read.
  connect(
      &link_, &CellLink::rawCame, &edits_,
      [&edits = edits_](const sensor_msgs::PointCloud2ConstPtr& raw) {
        edits.open(std::make_shared<cloud_preprocess::Cloud>(scan_cell_common::from_message(*raw)),
                   raw->header.frame_id);
      },
      Qt::DirectConnection);
  connect(&link_, &CellLink::described, this, [this](const auto& run) {
    clean_->set_recipe(QString::fromStdString(run.recipe), QString::fromStdString(run.cleaning));
  });
  connect(&link_, &CellLink::edited, this, [this](const QString& recipe) {
    clean_->show_end(tr("Saved into %1: scan a part again, or prove the recipe.").arg(recipe));
    link_.list_recipes();
  });
  connect(clean_, &CleanPage::saveWanted, &link_, &CellLink::edit);
  connect(clean_, &CleanPage::saveWanted, this,
          [this](const QString&, const QString& edits) { saved_edits_ = edits; });
  connect(clean_, &CleanPage::stagesSaveWanted, &link_, &CellLink::set_stages);
  connect(clean_, &CleanPage::toolWanted, this, &Seat::toolWanted);
  connect(clean_, &CleanPage::boxWanted, this, &Seat::boxWanted);
}

std::optional<PlaceInView> Seat::place() const {
  if (page() == Page::kDesign) return place_of(picks_);
  if (page() == Page::kPasses) return place_of(pass_session_);
  if (run_is_awaited_) return std::nullopt;
  const auto path = place_of(path_session_);
  return path ? path : place_of(edits_);
}

QStringList Seat::unsaved() const {
  QStringList all;
  const EditedViewPtr scan = edits_.view();
  if (scan && !scan->edits.isEmpty() && scan->yaml != saved_edits_)
    all.append(tr("edits of the scan (page 2)"));
  if (path_session_.can_undo()) all.append(tr("edits of the path (page 4)"));
  return all;
}

void Seat::connect_path() {
  connect(path_, &PathPage::saveWanted, this,
          [this](const QString& run, const QString& edits, const QString& note) {
            tell(QString());
            link_.edit_path(run, edits, note);
          });
  connect(path_, &PathPage::toolWanted, this, &Seat::toolWanted);
  connect(path_, &PathPage::placeChosen, this, &Seat::placeChosen);
}

void Seat::connect_design() {
  connect(&designs_, &DesignLink::referenceCame, this, [this](const auto& reference) {
    if (reference->text != design_->recipe()) return;  // another seat's
    picks_.open(reference);
    Q_EMIT placeCame();
  });
  connect(&designs_, &DesignLink::designed, design_, &DesignPage::show_answer);
  connect(&designs_, &DesignLink::refused, design_, &DesignPage::show_end);
  connect(design_, &DesignPage::designWanted, &designs_, &DesignLink::design);
  connect(design_, &DesignPage::recipeMade, &link_, &CellLink::list_recipes);
  connect(design_, &DesignPage::toolWanted, this, &Seat::toolWanted);
}

void Seat::connect_passes() {
  connect(&pass_link_, &PassLink::programCame, passes_, &PassesPage::show_program);
  connect(&pass_link_, &PassLink::programCame, this, &Seat::placeCame);
  connect(&pass_link_, &PassLink::checked, passes_, &PassesPage::show_checked);
  connect(&pass_link_, &PassLink::failed, passes_, &PassesPage::show_end);
  connect(&pass_link_, &PassLink::programSaved, this, [this](const QString& recipe) {
    passes_->show_end(tr("Saved into %1: scan a part again, or prove the recipe.").arg(recipe));
    link_.list_recipes();
  });
  connect(passes_, &PassesPage::programWanted, &pass_link_, &PassLink::load);
  connect(passes_, &PassesPage::checkWanted, this,
          [this] { pass_link_.check(pass_session_.frame(), pass_session_.passes()); });
  connect(passes_, &PassesPage::saveWanted, this, [this](const QString& recipe) {
    pass_link_.save(recipe, pass_session_.frame(), pass_session_.passes());
  });
  connect(passes_, &PassesPage::toolWanted, this, &Seat::toolWanted);
  connect(passes_, &PassesPage::placeChosen, this, &Seat::placeChosen);
}

void Seat::show_busy(Busy busy) {
  path_->set_free(busy == Busy::kFree);
  part_->set_free(busy == Busy::kFree);
  work_->set_free(busy == Busy::kFree);
  teach_->set_free(busy == Busy::kFree);
  passes_->set_free(busy == Busy::kFree);
  stop_->setEnabled(busy != Busy::kFree);  // whoever sits nearest may stop the robot
  if (busy == Busy::kFree) show_progress(tr("Nothing is under way."), 0);
  if (busy == Busy::kOthers) show_progress(tr("Another seat or program has the cell."), -1);
}

void Seat::show_progress(const QString& doing, double share) {
  doing_->setText(doing);
  progress_->setMaximum(share < 0 ? 0 : kPerMille);  // 0: busy, progress unknown
  progress_->setValue(static_cast<int>(share * kPerMille));
}

void Seat::show_end(const RunRecipeResult& result, Doing was) {
  const bool was_work = was == Doing::kWork || was == Doing::kDryRun;
  const QString id = id_of(result);
  if (result.outcome == RunRecipeResult::NONE) {
    tell(QString::fromStdString(result.message));
    if (was_work)
      work_->show_end(tr("Not completed: %1").arg(QString::fromStdString(result.message)));
    if (was == Doing::kEdit) path_->show_end(QString::fromStdString(result.message));
    return;
  }
  if (was == Doing::kEdit && result.outcome != RunRecipeResult::ACCEPTED)
    return path_->show_end(QString::fromStdString(result.message));  // the edits stay
  tell(QString::fromStdString(result.warning));
  open_run(id);
  const QString done = was == Doing::kDryRun ? tr("Dry run done. %1") : tr("Done. %1");
  if (was_work)
    work_->show_end((result.worked != 0 ? done : tr("Not completed: %1"))
                        .arg(QString::fromStdString(result.work_message)));
  else
    show_page(Page::kFit);
}

void Seat::tell(const QString& message) {
  trouble_->setText(message);
}

}  // namespace scan_cell_rviz
