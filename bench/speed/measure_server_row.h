// SPDX-License-Identifier: MIT
//
// Fills one row of the server table: starts jostle-server, jostle-load and jostlectl, the programs
// beside this one, and takes the figures from what they say.
#pragma once

#include <string>

#include "bench/speed/server_row.h"
#include "bench/speed/speed_scenes.h"

namespace jostle::bench {

struct ServerRequest {
    const SpeedScene* scene = nullptr;
    int threads = 1;  // of the world's step
    int clients = 20;
    double seconds = 10;  // 1 to 30: as long as a server records
    std::string script;   // what clients do, a file for jostle-load; empty: they push what is there
};

ServerRow measure_server_row(const ServerRequest& request);

}  // namespace jostle::bench
