// SPDX-License-Identifier: MIT
//
// `jostle-server --health`: checks whether the server on this machine is serving and returns an
// exit status. Container images have neither a shell nor curl, so their health checks run this
// probe. It calls both listeners: the gRPC health service and /healthz over HTTP. A server is
// healthy only if both respond.
#pragma once

#include <chrono>
#include <string>

#include "server/config/config.h"

namespace jostle::server {

// The addresses to probe. A server that listens on all addresses is probed on loopback.
struct HealthTarget {
    HostPort grpc, http;
    // The certificate chain that the server presents (PEM); empty: no TLS. The probe does not
    // verify it: the certificate names the public host and not the loopback address, a restart
    // cannot repair a certificate, and the probe sends no secrets.
    std::string certificates;
};

// Requires a configuration that passed check(). Errors name the setting that has no usable port or
// no readable file.
Result<HealthTarget> health_target(const Config& config);

// Returns the state of both listeners in one line; an error holds the response of the listener that
// failed. Takes at most `timeout` and a few milliseconds.
Result<std::string> probe_health(const HealthTarget& target, std::chrono::milliseconds timeout);

// Prints one line and returns the exit status within 3 s: 0 healthy, 1 not healthy.
int run_health_probe(const Config& config);

}  // namespace jostle::server
