// SPDX-License-Identifier: MIT
//
// Measures one row of the server table: starts jostle-server, jostle-load and jostlectl, which must
// be in the directory of this program, and collects their reports.
#pragma once

#include <string>

#include "bench/speed/server_row.h"
#include "bench/speed/speed_scenes.h"

namespace jostle::bench {

struct ServerRequest {
    const SpeedScene* scene = nullptr;
    int threads = 1;  // of the world's step
    int clients = 20;
    double seconds = 10;  // 1 to 30: the limit of a server's recording
    std::string script;   // script file for jostle-load; empty: clients push bodies
};

ServerRow measure_server_row(const ServerRequest& request);

}  // namespace jostle::bench
