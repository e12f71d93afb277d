// SPDX-License-Identifier: MIT
//
// Tells systemd how the server is, for units of Type=notify: ready, alive, going down. The protocol
// is one datagram of lines to the socket in $NOTIFY_SOCKET (man sd_notify), so no library is
// needed. Without that variable nobody asked, and every call does nothing. Any thread; no call
// waits.
#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace jostle::server {

// Each returns whether a manager was told. What keeps one from being told is logged as a warning:
// the server goes on, and systemd does what its unit says about silence.

// Clients can connect now. `status` is the line that `systemctl status` shows.
bool notify_ready(std::string_view status);
// A drain begins.
bool notify_stopping();
// Everything that should move does. Call it every watchdog_period(), from the thread that checks;
// when it stays out, systemd kills the server and starts it anew.
bool notify_watchdog();

// How often the manager wants to hear notify_watchdog(): half of the time after which it kills.
// Nothing when it does not, or when it watches another process.
std::optional<std::chrono::microseconds> watchdog_period();

}  // namespace jostle::server
