// SPDX-License-Identifier: MIT
//
// Builds all parts in order, runs until it is told to stop, takes them down in reverse.
#pragma once

#include <string>

#include "server/config/config.h"

namespace jostle::server {

// Runs a server until SIGTERM or SIGINT; a second signal ends it at once. `port_file`: where to
// write the real ports as JSON (empty: nowhere). `version`: what the metrics call this program.
// Returns the exit status: 0 after an orderly end, 1
// when something could not be started.
int run_server(const Config& config, const std::string& port_file, const std::string& version);

}  // namespace jostle::server
