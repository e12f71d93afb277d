// SPDX-License-Identifier: MIT
//
// `jostle-server --health`: asks a server on this machine whether it serves, and answers with an
// exit status. Containers, which have no shell and no curl, call it for their health check; so may
// an operator. It asks both doors: gRPC's health service, and /healthz over HTTP. A process that
// still answers one of them but not the other is not healthy.
#pragma once

#include <chrono>
#include <string>

#include "server/config/config.h"

namespace jostle::server {

// Where to ask. A server that listens on all addresses is asked on loopback.
struct HealthTarget {
    HostPort grpc, http;
    // The server's certificates as it presents them (PEM); empty: the doors speak no TLS. They are
    // not checked: they name the server as others see it, not the loopback address, to start it
    // anew would mend none of them, and nothing secret is sent.
    std::string certificates;
};

// From settings that check() found good. Errors name the setting that leads to no port or to no
// file.
Result<HealthTarget> health_target(const Config& config);

// What both doors said, in one line; an error says what the door that failed said. Takes no longer
// than `patience`, and a moment.
Result<std::string> probe_health(const HealthTarget& target, std::chrono::milliseconds timeout);

// Prints one line and returns the exit status within 3 s: 0 healthy, 1 not.
int run_health_probe(const Config& config);

}  // namespace jostle::server
