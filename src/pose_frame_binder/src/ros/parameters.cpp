// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include "scan_cell_common/parameters/parameter_table.h"

namespace pose_frame_binder {
namespace {

void describe(scan_cell_common::ParameterTable& table, LookupParameters& lookup) {
  table.add("lookup/address", lookup.address, "IPv4 of the interface that the lookup listens on");
  table.add("lookup/port", lookup.port, {0, 65535}, "port of the lookup; 0: off");
  table.add("lookup/max_clients", lookup.limits.max_clients, {1, 64}, "most clients at a time");
  table.renamed("lookup/most_clients", "lookup/max_clients");
  table.add("lookup/idle_time", lookup.limits.idle_time, {1, 3600, "s"},
            "a client that sends nothing for this long is disconnected");
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, Parameters& parameters) {
  describe(table, parameters.frames);
  table.add("transform_timeout", parameters.transform_timeout, {0, 60, "s"},
            "how long `~start` waits for the static transform from fixed frame to base");
  describe(table, parameters.settings);
  table.group("constant_speed", parameters.settings.constant_speed);
  describe(table, parameters.lookup);
  check(parameters.settings);
}

}  // namespace pose_frame_binder
