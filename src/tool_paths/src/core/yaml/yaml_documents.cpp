// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "yaml/yaml_documents.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <set>
#include <sstream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/errors/utf8.h"

namespace tool_paths {
namespace {

using scan_cell_common::UnusableInput;

/// Checks that each document begins after the one before. yaml-cpp 0.7 takes text that cannot begin
/// a document for an empty one, over and over, and LoadAll() never ends.
class DocumentsGoOn : public YAML::EventHandler {
 public:
  explicit DocumentsGoOn(const std::string& source) : source_(source) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos <= last_) {
      throw UnusableInput(line_of(source_, mark), "neither part of a document nor a new one",
                          "correct the YAML");
    }
    last_ = mark.pos;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  const std::string& source_;
  int last_ = -1;  // where the last document began
};

}  // namespace

std::vector<YAML::Node> load_documents(const std::string& text, const std::string& source) {
  scan_cell_common::check_utf8(text, source);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    DocumentsGoOn documents(source);
    while (parser.HandleNextDocument(documents)) {
    }
    return YAML::LoadAll(text);
  } catch (const YAML::Exception& error) {
    throw UnusableInput(line_of(source, error.mark), error.msg, "correct the YAML");
  }
}

std::string line_of(const std::string& source, const YAML::Mark& mark) {
  return fmt::format("{}, line {}", source, mark.line + 1);
}

std::vector<std::pair<std::string, YAML::Node>> entries_of(const YAML::Node& map,
                                                           const std::string& source) {
  std::set<std::string> keys;
  std::vector<std::pair<std::string, YAML::Node>> entries;
  for (const auto& entry : map) {
    if (!entry.first.IsScalar()) {
      throw UnusableInput(line_of(source, map.Mark()), "a key that is not text",
                          "give keys as text");
    }
    const std::string& key = entry.first.Scalar();
    if (!keys.insert(key).second) {
      throw UnusableInput(line_of(source, map.Mark()),
                          fmt::format("'{}' occurs twice", scan_cell_common::excerpt(key)),
                          "keep one");
    }
    entries.emplace_back(key, entry.second);
  }
  return entries;
}

}  // namespace tool_paths
