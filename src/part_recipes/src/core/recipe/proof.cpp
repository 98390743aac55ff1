// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe/proof.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/sha256.h"

namespace part_recipes {
namespace {

using Json = nlohmann::ordered_json;
using scan_cell_common::FileError;
using scan_cell_common::Refused;

constexpr int kProofFormat = 1;
constexpr const char* kProofFile = "proof.json";

std::string prove(const Recipe& recipe) {
  return fmt::format("run: recipe prove '{}' with a scan of the reference part",
                     recipe.folder.filename().string());
}

std::string since(const Proof& proof) {
  return fmt::format("changed since the recipe was {} ({})", proof.proven ? "proven" : "made",
                     proof.time);
}

Proof parse(const std::string& text) {
  const Json all = Json::parse(text);
  if (all.at("format").get<int>() != kProofFormat) throw std::runtime_error("another format");
  Proof proof;
  proof.proven = all.at("proven").get<bool>();
  proof.time = all.at("time").get<std::string>();
  proof.run = all.at("run").get<std::string>();
  proof.files = all.at("files").get<Hashes>();
  proof.calibration = all.at("calibration").get<Hashes>();
  return proof;
}

}  // namespace

Hashes hashes_of(const Recipe& recipe) {
  Hashes hashes;
  for (const std::string& name : recipe.files())
    hashes[name] = scan_cell_common::sha256_of_file((recipe.folder / name).string());
  return hashes;
}

std::string hash_over(const Hashes& files) {
  std::string lines;
  for (const auto& [name, hash] : files)
    lines += hash + "  " + name + "\n";
  return scan_cell_common::sha256_of(lines, "hashes of a recipe");
}

Proof load_proof(const Recipe& recipe) {
  const std::string file = (recipe.folder / kProofFile).string();
  const std::string text = scan_cell_common::read_file(file);
  try {
    return parse(text);
  } catch (const std::exception& error) {
    throw FileError(file, error.what(), prove(recipe));
  }
}

void save_proof(const Recipe& recipe, const Proof& proof) {
  constexpr int kIndent = 2;
  const Json all = {{"format", kProofFormat}, {"proven", proof.proven},
                    {"time", proof.time},     {"run", proof.run},
                    {"files", proof.files},   {"calibration", proof.calibration}};
  scan_cell_common::save_text((recipe.folder / kProofFile).string(), all.dump(kIndent) + "\n");
}

void check_unchanged(const Recipe& recipe, const Proof& proof, const Hashes& now) {
  for (const auto& [name, hash] : now) {
    const auto then = proof.files.find(name);
    if (then == proof.files.end() || then->second != hash)
      throw Refused((recipe.folder / name).string(), since(proof), prove(recipe));
  }
}

std::string check_calibration(const Recipe& recipe, const Proof& proof, const Hashes& calibration) {
  std::string notes = proof.proven ? "" : "the recipe was never proven; " + prove(recipe);
  for (const auto& [name, hash] : proof.calibration) {
    const auto known = calibration.find(name);
    if (known == calibration.end()) {
      notes += fmt::format("{}the scan does not name its {} file", notes.empty() ? "" : "; ", name);
    } else if (known->second != hash) {
      throw Refused(fmt::format("the cell's {} file", name), since(proof), prove(recipe));
    }
  }
  return notes;
}

}  // namespace part_recipes
