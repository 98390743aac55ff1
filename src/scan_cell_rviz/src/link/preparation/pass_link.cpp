// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/preparation/pass_link.h"

#include <QMetaType>

#include "scan_cell/ros/service_call.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::CheckProgram;
using scan_cell_msgs::EditProgram;

constexpr double kProgramTimeout = 5;        // [s] for an answer; chosen
constexpr double kCheckProgramTimeout = 10;  // [s] the controller is asked about each place; chosen

}  // namespace

PassLink::PassLink(const NodeNames& names) : names_(names) {
  qRegisterMetaType<scan_cell_msgs::EditProgramResponse>("scan_cell_msgs::EditProgramResponse");
  qRegisterMetaType<std::vector<scan_cell_msgs::CheckProgramResponse>>(
      "std::vector<scan_cell_msgs::CheckProgramResponse>");
}

PassLink::~PassLink() {
  ++latest_;
  worker_.reset();  // while the receivers of its signals still exist
}

void PassLink::load(const QString& recipe) {
  EditProgram::Request request;
  request.recipe = recipe.toStdString();
  edit(request, [this, recipe](const EditProgram::Response& program) {
    Q_EMIT programCame(recipe, program);
  });
}

void PassLink::save(const QString& recipe, const std::string& frame,
                    const std::vector<scan_cell_msgs::ScanPass>& passes) {
  EditProgram::Request request;
  request.recipe = recipe.toStdString();
  request.set = 1;
  request.frame = frame;
  request.passes = passes;
  edit(request, [this, recipe](const EditProgram::Response&) { Q_EMIT programSaved(recipe); });
}

/// @param end receives the answer
template <class End>
void PassLink::edit(const scan_cell_msgs::EditProgramRequest& request, const End& end) {
  const auto task = [this, request, end] {
    end(scan_cell::call<EditProgram>(names_.recipes + "/program", request, kProgramTimeout));
  };
  worker_->add(task, [this](const QString& message) { Q_EMIT failed(message); });
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
