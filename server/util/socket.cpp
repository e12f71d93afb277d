// SPDX-License-Identifier: MIT
#include "server/util/socket.h"

#include <cerrno>
#include <cstring>
#include <memory>

#include <netdb.h>
#include <unistd.h>

namespace jostle::server {

Result<int> open_bound_socket(const std::string& host, std::uint16_t port, int type) {
    addrinfo hints{};
    hints.ai_socktype = type;
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (const int e = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
        e != 0)
        return Error{ErrorCode::unavailable, gai_strerror(e)};
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owned(found, freeaddrinfo);
    const int descriptor = socket(found->ai_family, type | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (descriptor < 0) return Error{ErrorCode::unavailable, std::strerror(errno)};
    if (type == SOCK_STREAM) set_socket_option(descriptor, SOL_SOCKET, SO_REUSEADDR, 1);
    if (found->ai_family == AF_INET6) set_socket_option(descriptor, IPPROTO_IPV6, IPV6_V6ONLY, 0);
    if (bind(descriptor, found->ai_addr, found->ai_addrlen) == 0) return descriptor;
    const Error error{ErrorCode::unavailable, std::strerror(errno)};
    close(descriptor);
    return error;
}

std::uint16_t port_of(int descriptor) {
    sockaddr_storage own{};
    socklen_t size = sizeof own;
    getsockname(descriptor, reinterpret_cast<sockaddr*>(&own), &size);
    // The port has the same offset in IPv4 and IPv6.
    return ntohs(reinterpret_cast<const sockaddr_in6&>(own).sin6_port);
}

}  // namespace jostle::server
