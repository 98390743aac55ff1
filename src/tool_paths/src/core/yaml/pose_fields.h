// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <set>
#include <string>
#include <vector>

#include "yaml/yaml_shape.h"

namespace tool_paths {

/// A YAML pose split into its parts.
struct PoseParts {
  std::vector<PoseField> fields;   //!< numbers, in the file's order
  std::vector<YAML::Node> values;  //!< of the fields
  std::vector<std::string> kept;   //!< keys of everything that is not a number
};

/// Splits poses: numbers become fields, everything else is kept as it is.
class PoseSplitter {
 public:
  /// @param process_names of the whole file, for `process_values`
  /// @param not_orientations keys that look like an orientation but are none
  PoseSplitter(const std::string& source, const std::vector<std::string>& process_names,
               const std::vector<std::string>& not_orientations)
      : source_(source), process_names_(process_names), not_orientations_(not_orientations) {}

  /// @throw scan_cell_common::UnusableInput if it is not a pose, or contains what could be an
  /// orientation of unknown kind
  PoseParts split(const YAML::Node& node) const;

 private:
  std::string where(const YAML::Node& node) const;
  void split_map(const YAML::Node& map, const std::string& prefix, PoseParts& parts) const;
  void split_entry(const std::string& key, const YAML::Node& value, const std::string& prefix,
                   PoseParts& parts) const;
  void split_position(const YAML::Node& node, const std::string& slot, PoseParts& parts) const;
  void split_orientation(const YAML::Node& node, const std::string& slot, PoseParts& parts) const;
  void split_rpy(const YAML::Node& node, const std::string& slot, PoseParts& parts) const;
  void split_process_values(const YAML::Node& node, const std::string& slot,
                            PoseParts& parts) const;
  void check_value_count(const YAML::Node& node, std::size_t count) const;
  void split_list(const YAML::Node& node, PoseParts& parts) const;
  void split_elements(const YAML::Node& list, const std::string& slot,
                      const std::vector<std::string>& names, PoseParts& parts) const;
  void keep(const std::string& key, const YAML::Node& value, PoseParts& parts) const;
  void check_kept(const std::string& key, const YAML::Node& value, int depth) const;
  void check_kept_name(const std::string& key, const YAML::Node& value) const;

  const std::string& source_;
  const std::vector<std::string>& process_names_;
  const std::vector<std::string>& not_orientations_;
  mutable std::size_t visited_ = 0;
};

}  // namespace tool_paths
