// SPDX-License-Identifier: MIT
//
// Translates the configuration into the settings of worlds and listeners, and acquires the system
// resources that they need. Pure functions unless noted; main thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "server/config/config.h"
#include "server/forwarding/trusted_proxies.h"
#include "server/grpc/grpc_server.h"
#include "server/http/http_server.h"
#include "server/metrics/metrics.h"
#include "server/tls/certificate_store.h"
#include "server/udp/datagram_server.h"
#include "server/world/world_host.h"

namespace jostle::server {

// `on_frame`: see WorldHostSettings.
WorldHostSettings world_settings(const Config& config, Metrics& metrics,
                                 std::function<void(bool has_events)> on_frame);
// `certificates` null: no TLS.
GrpcSettings grpc_settings(const Config& config, Metrics& metrics,
                           const CertificateStore* certificates, const TrustedProxies* proxies);
HttpServerSettings http_settings(const Config& config, Metrics& metrics,
                                 const CertificateStore* certificates,
                                 const TrustedProxies* proxies);
// The admin listener serves few small requests. On addresses other than loopback it requires a
// client certificate if the configuration sets tls.client_ca.
HttpServerSettings admin_settings(const Config& config, Metrics& metrics,
                                  const CertificateStore* certificates);
DatagramServerSettings datagram_settings(const Config& config, Metrics& metrics);

// Raises the limit of open files of this process to the maximum that the system allows.
void raise_descriptor_limit();
// The folder of the viewer: the configured path, or, if it does not exist relative to the current
// folder, the same path in the source tree of the program or share/jostle/web of its installation
// prefix.
std::filesystem::path find_web_root(const std::string& configured);
// Rejects a configured folder, other than the default, that is absent or contains no viewer.
Status check_web_root(const Config& config);
// The host name that clients use for a listener at `host`.
std::string reachable_host(const std::string& host, const std::string& advertised_host);

}  // namespace jostle::server
