// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe/places_file.h"

#include "scan_cell_common/files/files.h"

namespace part_recipes {

void write(YAML::Emitter& text, const std::vector<Place>& places) {
  constexpr int kDigits = 17;  // that bring a double back
  text.SetDoublePrecision(kDigits);
  text << YAML::BeginSeq;
  for (const Place& place : places) {
    text << YAML::BeginMap << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << place.name
         << YAML::Key << "position" << YAML::Value << YAML::Flow << YAML::BeginSeq
         << place.position.x() << place.position.y() << place.position.z() << YAML::EndSeq
         << YAML::Key << "radius" << YAML::Value << place.radius << YAML::EndMap;
  }
  text << YAML::EndSeq;
}

void save_places(const std::string& file, const std::vector<Place>& places) {
  YAML::Emitter text;
  write(text, places);
  scan_cell_common::save_text(file, std::string(text.c_str()) + "\n");
}

}  // namespace part_recipes
