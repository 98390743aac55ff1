// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "panel.h"

#include <fmt/format.h>

#include <sstream>

#include "controller/arm/wire_pose.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::InvalidParameter;

const char* const kHelp =
    "e_stop                press the emergency stop\n"
    "release               release it: the alarm stays active, the drives stay off\n"
    "reset                 reset the alarms\n"
    "drives on | off       in mode programming: the enabling device\n"
    "mode NAME             programming, automatic or remote; another one switches the drives off\n"
    "fail TEXT             an alarm that ends the current motion, with this text\n"
    "restart MS            switched off for this long, and on again\n"
    "fault NAME VALUE [to_client | from_client]   as the option --NAME; both ways if not given\n"
    "link up | down        plug the cable in, pull it\n"
    "well                  no faults\n"
    "state                 position and state of the robot";

double number(const std::string& text) {
  std::istringstream stream(text);
  double value = 0;
  if (stream >> value && stream.eof()) return value;
  throw InvalidParameter("number", "'" + text + "'", "give one such as 0.3");
}

/// The text after the command's word, without blanks around it.
std::string rest_of(const std::string& line) {
  const char* const blanks = " \t\r";
  const std::size_t word_end = line.find_first_of(blanks, line.find_first_not_of(blanks));
  const std::size_t begin = line.find_first_not_of(blanks, word_end);
  if (begin == std::string::npos) return "";
  return line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
}

void refuse_more_words(const std::vector<std::string>& words) {
  std::size_t most = 1;
  for (const char* const with_one : {"drives", "mode", "restart", "link"})
    if (words[0] == with_one) most = 2;
  if (words[0] == "fault") most = 4;
  if (words.size() <= most) return;
  throw InvalidParameter(words[0], "'" + words[most] + "'", "leave it out, see help");
}

bool one_of(const std::string& word, const char* yes, const char* no) {
  if (word == yes) return true;
  if (word == no) return false;
  throw InvalidParameter("word", "'" + word + "'", std::string("say ") + yes + " or " + no);
}

}  // namespace

void set_fault(WireFaults& faults, const std::string& name, double value) {
  constexpr double kMillisecond = 1e-3;  // [s]
  for (const WireFault& fault : kWireFaults) {
    if (name != fault.name) continue;
    faults.*fault.value = fault.time ? value * kMillisecond : value;
    return;
  }
  throw InvalidParameter("fault", "'" + name + "'", "see the options in --help");
}

std::string Panel::carry_out(const std::string& line) {
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  if (words.empty()) return "";
  if (words[0] == "fail") words = {"fail", rest_of(line)};
  try {
    return perform(words);
  } catch (const std::runtime_error& error) {
    return std::string("refused: ") + error.what();
  }
}

std::string Panel::perform(Words words) {
  constexpr double kMillisecond = 1e-3;  // [s]
  const std::string what = words[0];
  if (what != "fail") refuse_more_words(words);
  words.resize(4);  // what is left out is empty
  if (what == "e_stop") {
    controller_.press_e_stop();
  } else if (what == "release") {
    controller_.release_e_stop();
  } else if (what == "reset") {
    controller_.reset_alarms();
  } else if (what == "drives") {
    controller_.switch_drives(one_of(words[1], "on", "off"));
  } else if (what == "mode") {
    controller_.select(controller_mode_of(words[1]));
  } else if (what == "fail") {
    controller_.fail_motion(words[1].empty() ? "failed" : words[1]);
  } else if (what == "restart") {
    controller_.restart(number(words[1]) * kMillisecond);
  } else if (what == "state") {
    return tell();
  } else if (what == "fault" || what == "link" || what == "well") {
    change_fault(words);
  } else {
    return kHelp;
  }
  return "ok";
}

void Panel::change_fault(const Words& words) {
  ControllerFaults changed = faults_;
  if (words[0] == "well") {
    changed = {};
  } else if (words[0] == "link") {
    changed.to_client.link_down = changed.from_client.link_down = one_of(words[1], "down", "up");
  } else {
    const double value = number(words[2]);
    const bool both = words[3].empty();
    if (both || one_of(words[3], "to_client", "from_client"))
      set_fault(changed.to_client, words[1], value);
    if (both || words[3] == "from_client") set_fault(changed.from_client, words[1], value);
  }
  controller_.set_faults(changed);
  faults_ = changed;
}

std::string Panel::tell() const {
  const MotionState state = controller_.state();
  std::string text = fmt::format(
      "{}, mode {}, drives {}{}", name_of(state.status), name_of(state.readiness.mode()),
      state.readiness.drives() ? "on" : "off", state.readiness.e_stop() ? ", emergency stop" : "");
  for (const Complaint& alarm : state.readiness.alarms())
    text += ", alarm: " + alarm.text;
  return fmt::format("{}, flange [mm, deg] {:g}", text, fmt::join(shown(state.flange), " "));
}

}  // namespace scan_cell_sim
