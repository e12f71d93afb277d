// SPDX-License-Identifier: MIT
//
// Reports the server's state to systemd, for units of Type=notify: ready, alive, stopping. The
// protocol is one datagram of lines to the socket in $NOTIFY_SOCKET (man sd_notify), so no library
// is needed. Without that variable every call does nothing. Any thread; no call blocks.
#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace jostle::server {

// Each returns whether the notification was sent. A failure is logged as a warning and the server
// continues; systemd then applies the timeout of the unit.

// Clients can connect. `status` is the line that `systemctl status` shows.
bool notify_ready(std::string_view status);
// A drain begins.
bool notify_stopping();
// The server is healthy. Call it every watchdog_period(); without it systemd kills the server and
// restarts it.
bool notify_watchdog();

// The interval for notify_watchdog(): half of systemd's watchdog timeout. Nothing if the watchdog
// is off or watches another process.
std::optional<std::chrono::microseconds> watchdog_period();

}  // namespace jostle::server
