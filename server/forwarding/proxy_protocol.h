// SPDX-License-Identifier: MIT
//
// The header of the PROXY protocol, version 2, with which a proxy that forwards TCP names its
// client (https://www.haproxy.org/download/3.0/doc/proxy-protocol.txt). It precedes every other
// byte of the connection, also TLS. A value; one thread.
#pragma once

#include <sys/socket.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "jostle/base/result.h"

namespace jostle::server {

class ProxyHeaderReader {
public:
    // Of the part after the first 16 bytes. Proxies send up to some hundred bytes of extensions.
    static constexpr std::size_t rest_bytes_max = 4096;

    // Bytes to read next, so that no byte behind the header is read; 0: the header is complete.
    std::size_t wanted() const;
    // At most wanted() bytes. An error: this is not a valid header; the connection must be closed.
    Status take(std::span<const std::uint8_t> bytes);
    // The client, after the header is complete. Nothing: the connection is the proxy's own, such as
    // a health check, or the proxy does not name the client.
    std::optional<sockaddr_storage> client() const;

private:
    Status check_start() const;

    // 16 bytes, then at most the addresses of TCP over IPv6; extensions are skipped.
    std::array<std::uint8_t, 16 + 36> bytes_{};
    std::size_t received_ = 0;
};

}  // namespace jostle::server
