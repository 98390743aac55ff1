// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/DescribeRunResponse.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

namespace scan_cell_rviz {

/// The result of a run: the verdict in words, its figures, and a person's decision.
class FitPage : public QWidget {
  Q_OBJECT

 public:
  explicit FitPage(QWidget* parent = nullptr);

  void show_run(const scan_cell_msgs::DescribeRunResponse& run);

  QString person() const;
  void set_person(const QString& name);

 Q_SIGNALS:
  void decisionWanted(QString run, bool approved, QString name, QString note);
  void reportWanted(QString file);
  void placeChosen(double x, double y, double z, QString frame);  ///< [m]

 private:
  void lay_out();
  void show_waypoints();
  void update_buttons();
  void decide(bool approved);

  scan_cell_msgs::DescribeRunResponse run_;
  QLabel* verdict_;
  QLabel* message_;
  QTableWidget* figures_;
  QListWidget* waypoints_;
  QLabel* decision_;
  QLineEdit* person_;
  QLineEdit* note_;
  QPushButton* approve_;
  QPushButton* refuse_;
  QPushButton* report_;
};

}  // namespace scan_cell_rviz
