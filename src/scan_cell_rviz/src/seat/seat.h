// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStringList>
#include <QTabWidget>
#include <QWidget>
#include <optional>

#include "design/pick_session.h"
#include "edit/edit_session.h"
#include "pages/preparation/design_page.h"
#include "pages/preparation/passes_page.h"
#include "pages/preparation/teach_page.h"
#include "pages/shift/clean_page.h"
#include "pages/shift/fit_page.h"
#include "pages/shift/history_page.h"
#include "pages/shift/part_page.h"
#include "pages/shift/path_page.h"
#include "pages/shift/work_page.h"
#include "seat/band.h"
#include "seat/page.h"
#include "seat/place_in_view.h"
#include "seat/seat_links.h"

namespace scan_cell_rviz {

/// What a person works on at a seat, shared with the displays and tools of rviz.
struct SeatSessions {
  EditSession& edits;   ///< of the scan in view
  PathSession& path;    ///< of the run in view
  PickSession& picks;   ///< on the reference of a recipe
  PassSession& passes;  ///< of a recipe's scan program
};

/// The seat without rviz: the band, what is under way, and one page per stage in the operator's
/// order.
class Seat : public QWidget {
  Q_OBJECT

 public:
  Seat(SeatLinks& links, const SeatSessions& sessions, QWidget* parent = nullptr);

  /// Whether a scan or work of this seat is under way.
  bool is_busy() const { return link_.busy() == Busy::kOurs; }
  bool is_free() const { return link_.busy() == Busy::kFree; }  ///< nor does any other seat
  QString person() const { return fit_->person(); }
  void set_person(const QString& name) { fit_->set_person(name); }
  QString pose_file() const { return teach_->file(); }
  void set_pose_file(const QString& file) { teach_->set_file(file); }
  /// Descriptions of edits that would be lost with this seat.
  QStringList unsaved() const;
  Page page() const { return static_cast<Page>(pages_->currentIndex()); }
  /// The subject of the page: a run by its path, or by its scan if it has no path. None while a run
  /// is awaited.
  std::optional<PlaceInView> place() const;

 Q_SIGNALS:
  void personChanged();
  void poseFileChanged();
  void placeChosen(double x, double y, double z, QString frame);  ///< [m]
  void toolWanted(QString name);                                  ///< as CleanPage
  void boxWanted();                                               ///< as in CleanPage
  void poseChosen(int pose);                                      ///< of the preview, to show
  void pageShown(Page page);
  void runShown(QString run);  ///< now in view
  void placeCame();            ///< place() has changed
  void placeWanted();          ///< to be centred in the view

 private:
  void show_page(Page page);
  void open_run(const QString& run);
  void connect_link();
  void connect_pages();
  void connect_clean();
  void connect_path();
  void connect_design();
  void connect_passes();
  void show_busy(Busy busy);
  void show_progress(const QString& doing, double share);
  void show_end(const scan_cell_msgs::RunRecipeResult& result, Doing was);
  void tell(const QString& message);  ///< what failed; empty: clears it

  CellLink& link_;
  DesignLink& designs_;
  PassLink& pass_link_;
  EditSession& edits_;
  PathSession& path_session_;
  PickSession& picks_;
  PassSession& pass_session_;
  Band* band_;
  QTabWidget* pages_;
  PartPage* part_;
  CleanPage* clean_;
  FitPage* fit_;
  PathPage* path_;
  WorkPage* work_;
  HistoryPage* history_;
  TeachPage* teach_;
  DesignPage* design_;
  PassesPage* passes_;
  QLabel* doing_;
  QProgressBar* progress_;
  QPushButton* stop_;
  QPushButton* look_;
  QLabel* trouble_;
  bool run_is_awaited_ = false;
  QString saved_edits_;  // of the scan, in YAML
};

}  // namespace scan_cell_rviz
