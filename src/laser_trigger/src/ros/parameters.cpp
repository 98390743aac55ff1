// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include "scan_cell_common/parameters/parameter_table.h"

namespace laser_trigger {

void describe(scan_cell_common::ParameterTable& table, Parameters& parameters) {
  describe(table, parameters.port);
  PulseGenerator::Settings& pulses = parameters.pulses;
  table.add("pulse_width", pulses.pulse_width, {1e-5, 0.05, "s"},
            "how long the camera's line is high; limits the rate to half of its inverse");
  table.add("max_rate", pulses.max_rate, {0.1, 10000, "Hz"}, "highest pulse rate");
  table.renamed("most_rate", "max_rate");
  table.add("keep_alive_timeout", pulses.keep_alive_timeout, {0.05, 5, "s"},
            "the lasers go off when `~keep_alive` has been silent for this long");
  table.add("longest_on", pulses.longest_on, {0.1, 3600, "s"},
            "longest time an arming lasts, whatever was requested");
  table.add("realtime_priority", pulses.realtime_priority, {0, 99},
            "SCHED_FIFO priority of the pulse thread, if the rights allow it; if they do not, the "
            "node says so at its start and in the diagnostics; 0: never");
  table.add("exposure", pulses.exposure, {1e-5, 1, "s"},
            "alternating lasers do not switch for this long after a pulse, if the client does not "
            "give the camera's exposure; set it to at least that exposure plus its delay");
  table.add("exposure_delay", pulses.exposure_delay, {0, 0.1, "s"},
            "of the camera's trigger input; added to an exposure that the client gives");
  table.add("laser_rise", pulses.laser_rise, {0, 0.1, "s"},
            "each alternating laser is on for this long before its pulse, to become steady");
  table.add("hang_timeout", parameters.hang_timeout, {0.5, 10, "s"},
            "the guardian ends a node that has hung for this long while armed");
}

}  // namespace laser_trigger
