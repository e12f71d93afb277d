// SPDX-License-Identifier: MIT
//
// Resolves the HOST:PORT of a flag to the address of a stream socket. Any thread.
#pragma once

#include <netdb.h>
#include <sys/socket.h>

#include <cstring>
#include <string>

#include "jostle/base/result.h"

namespace jostle::common {

struct SocketAddress {
    sockaddr_storage bytes{};
    socklen_t size = 0;

    const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&bytes); }
};

// IPv6 addresses are in brackets. Errors name the text and the cause.
inline Result<SocketAddress> resolve(const std::string& host_port) {
    const std::size_t colon = host_port.rfind(':');
    if (colon == std::string::npos)
        return invalid_argument("\"" + host_port + "\" is not of the form HOST:PORT");
    std::string host = host_port.substr(0, colon);
    if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
    addrinfo hints{}, *found = nullptr;
    hints.ai_socktype = SOCK_STREAM;
    if (const int error = getaddrinfo(host.c_str(), host_port.c_str() + colon + 1, &hints, &found);
        error != 0)
        return invalid_argument("cannot resolve \"" + host_port + "\": " + gai_strerror(error));
    SocketAddress address;
    std::memcpy(&address.bytes, found->ai_addr, found->ai_addrlen);
    address.size = found->ai_addrlen;
    freeaddrinfo(found);
    return address;
}

}  // namespace jostle::common
