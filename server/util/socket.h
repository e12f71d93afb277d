// SPDX-License-Identifier: MIT
//
// Sockets of the listeners: bound to an address of this machine, with the options that all set. Any
// thread.
#pragma once
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "jostle/base/check.h"
#include "jostle/base/result.h"
#include "server/util/clock.h"

namespace jostle::server {

// Opens a non-blocking socket of type SOCK_STREAM or SOCK_DGRAM. Sockets of "::" accept IPv4, too.
// The caller closes the descriptor. Errors contain the cause only.
Result<int> open_bound_socket(const std::string& host, std::uint16_t port, int type);

// The port, if the socket was bound to port 0.
std::uint16_t port_of(int descriptor);

inline void set_socket_option(int descriptor, int level, int name, int value) {
    ASSERT(descriptor >= 0);
    setsockopt(descriptor, level, name, &value, sizeof value);
}

// The kernel closes the connection if the peer acknowledges no data for this long while data is
// pending: the peer is gone or does not read (RFC 5482; on Linux the timeout also covers a zero
// window).
inline void set_tcp_user_timeout(int descriptor, Clock::duration tcp_user_timeout) {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(tcp_user_timeout).count();
    set_socket_option(descriptor, IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(ms));
}

}  // namespace jostle::server
