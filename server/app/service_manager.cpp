// SPDX-License-Identifier: MIT
#include "server/app/service_manager.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>

#include "server/util/log.h"

namespace jostle::server {
namespace {

struct SocketAddress {
    sockaddr_un address{};
    socklen_t bytes = 0;
};

// "/run/systemd/notify", or "@name" for a name in the kernel's abstract name space.
std::optional<SocketAddress> parse_address(std::string_view text) {
    SocketAddress out;
    if (text.size() < 2 || text.size() >= sizeof out.address.sun_path ||
        (text[0] != '/' && text[0] != '@'))
        return {};
    out.address.sun_family = AF_UNIX;
    std::memcpy(out.address.sun_path, text.data(), text.size());
    // An abstract name begins with a zero byte and ends at the given length.
    if (text[0] == '@') out.address.sun_path[0] = '\0';
    out.bytes = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + text.size());
    return out;
}

bool send_to_manager(std::string_view lines) {
    const char* name = std::getenv("NOTIFY_SOCKET");
    if (name == nullptr || *name == '\0') return false;
    const std::optional<SocketAddress> to = parse_address(name);
    if (!to) {
        log_warn(
            "cannot notify systemd \"{}\": NOTIFY_SOCKET {} must be a path or @NAME of 2 to {} "
            "bytes",
            lines, name, sizeof(sockaddr_un::sun_path) - 1);
        return false;
    }
    const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const ssize_t sent = socket < 0
                             ? -1
                             : sendto(socket, lines.data(), lines.size(), MSG_NOSIGNAL,
                                      reinterpret_cast<const sockaddr*>(&to->address), to->bytes);
    if (sent < 0) log_warn("cannot notify systemd \"{}\": {}", lines, std::strerror(errno));
    if (socket >= 0) close(socket);
    return sent == static_cast<ssize_t>(lines.size());
}

// A number from the environment; nothing if the variable is missing or not a number.
std::optional<long long> number_in(const char* variable) {
    const char* text = std::getenv(variable);
    if (text == nullptr) return {};
    long long number = 0;
    const char* end = text + std::strlen(text);
    const auto [rest, error] = std::from_chars(text, end, number);
    if (error != std::errc{} || rest != end || text == end) return {};
    return number;
}

}  // namespace

bool notify_ready(std::string_view status) {
    std::string lines = "READY=1\nSTATUS=";
    // A line break would start another assignment.
    for (const char c : status) lines += c == '\n' || c == '\r' || c == '\0' ? ' ' : c;
    return send_to_manager(lines);
}

bool notify_stopping() {
    return send_to_manager("STOPPING=1\nSTATUS=shutting down");
}

bool notify_watchdog() {
    return send_to_manager("WATCHDOG=1");
}

std::optional<std::chrono::microseconds> watchdog_period() {
    const std::optional<long long> period = number_in("WATCHDOG_USEC");
    if (!period || *period < 2) return {};
    if (std::getenv("WATCHDOG_PID") != nullptr && number_in("WATCHDOG_PID") != getpid()) return {};
    return std::chrono::microseconds(*period / 2);
}

}  // namespace jostle::server
