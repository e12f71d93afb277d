// SPDX-License-Identifier: MIT
//
// Sockets bound to an address of this machine, for the listeners. Any thread.
#pragma once

#include <cstdint>
#include <string>

#include "jostle/base/result.h"

namespace jostle::server {

// Opens a non-blocking socket of type SOCK_STREAM or SOCK_DGRAM. Sockets of "::" accept IPv4, too.
// The caller closes the descriptor. Errors contain the cause only.
Result<int> open_bound_socket(const std::string& host, std::uint16_t port, int type);

// The port, if the socket was bound to port 0.
std::uint16_t port_of(int descriptor);

}  // namespace jostle::server
