// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_files/yaml_documents.h"

#include <yaml-cpp/eventhandler.h>

#include <sstream>

#include "scan_cell_common/errors.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::UnusableInput;

std::string where(const std::string& source, const YAML::Mark& mark) {
  return source + ", line " + std::to_string(mark.line + 1);
}

/// Sees to it that each document begins behind the one before. What cannot begin a document
/// yaml-cpp 0.7 takes for an empty one, over and over again, and LoadAll() never ends.
class DocumentsGoOn : public YAML::EventHandler {
 public:
  explicit DocumentsGoOn(const std::string& source) : source_(source) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos <= last_) {
      throw UnusableInput(where(source_, mark), "neither part of a document nor a new one",
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
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    DocumentsGoOn documents(source);
    while (parser.HandleNextDocument(documents)) {
    }
    return YAML::LoadAll(text);
  } catch (const YAML::Exception& error) {
    throw UnusableInput(where(source, error.mark), error.msg, "correct the YAML");
  }
}

}  // namespace tool_path_stretcher
