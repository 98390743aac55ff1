// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/pass_link.h"

#include <QMetaType>

#include "scan_cell/ros/service_call.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::CheckProgram;
using scan_cell_msgs::EditProgram;

constexpr double kProgramTimeout = 5;        // [s] for an answer; chosen
constexpr double kCheckProgramTimeout = 10;  // [s] the controller is asked for each place; chosen

}  // namespace

PassLink::PassLink(const NodeNames& names) : names_(names) {
  qRegisterMetaType<scan_cell_msgs::EditProgramResponse>("scan_cell_msgs::EditProgramResponse");
  qRegisterMetaType<std::vector<scan_cell_msgs::CheckProgramResponse>>(
      "std::vector<scan_cell_msgs::CheckProgramResponse>");
}

PassLink::~PassLink() {
  ++latest_;
  worker_.reset();  // while there still is somebody whose signals it emits
}

void PassLink::load(const QString& recipe) {
  worker_->add([this, recipe] {
    try {
      EditProgram::Request request;
      request.recipe = recipe.toStdString();
      Q_EMIT programCame(recipe, scan_cell::call<EditProgram>(names_.recipes + "/program", request,
                                                              kProgramTimeout));
    } catch (const std::exception& error) {
      Q_EMIT failed(QString::fromStdString(error.what()));
    }
  });
}

void PassLink::save(const QString& recipe, const std::string& frame,
                    const std::vector<scan_cell_msgs::ScanPass>& passes) {
  worker_->add([=] {
    try {
      EditProgram::Request request;
      request.recipe = recipe.toStdString();
      request.set = 1;
      request.frame = frame;
      request.passes = passes;
      scan_cell::call<EditProgram>(names_.recipes + "/program", request, kProgramTimeout);
      Q_EMIT programSaved(recipe);
    } catch (const std::exception& error) {
      Q_EMIT failed(QString::fromStdString(error.what()));
    }
  });
}

void PassLink::check(const std::string& frame,
                     const std::vector<scan_cell_msgs::ScanPass>& passes) {
  const int number = ++latest_;
  worker_->add([=] {
    std::vector<CheckProgram::Response> answers;
    for (const scan_cell_msgs::ScanPass& pass : passes) {
      if (number != latest_) return;
      CheckProgram::Request request;
      request.frame = frame;
      request.passes = {pass};
      try {
        answers.push_back(scan_cell::ask<CheckProgram>(names_.cell + "/check_program", request,
                                                       kCheckProgramTimeout));
      } catch (const std::exception& error) {
        answers.emplace_back();
        answers.back().link_lost = 1;
        answers.back().message = error.what();
      }
    }
    if (number == latest_) Q_EMIT checked(answers);
  });
}

}  // namespace scan_cell_rviz
