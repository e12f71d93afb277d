// SPDX-License-Identifier: MIT
//
// Levels with a meaning each, one line per event: debug for what a developer follows, info for what
// an operator wants to know of once, warn for what a client did wrong or the machine could not keep
// up with, error for what is our fault. Nothing is logged per tick.
//
// Any thread may log, and none ever waits for whoever reads the log: lines go through a bounded
// queue to a thread that writes them; what finds no room, or no reader in time, is dropped and
// counted. What strangers said is escaped, so that a line is one event.
#pragma once

#include <spdlog/spdlog.h>

#include <cstdint>
#include <string>
#include <utility>

namespace jostle::server {

struct LogSettings {
    std::string level = "info";
    bool json = false;  // {"time": ..., "level": ..., "message": ...} a line
    int descriptor = 1;
};

// Before the first line; until then lines go to standard output at once. A reader that goes away
// is no signal any more (SIGPIPE).
void start_log(const LogSettings& settings);
// Writes what is queued; waits a moment at most for a reader that does not read.
void stop_log();
// Since start_log().
std::uint64_t log_lines_dropped();

template <class... Args>
void log_debug(spdlog::format_string_t<Args...> format, Args&&... args) {
    spdlog::debug(format, std::forward<Args>(args)...);
}
template <class... Args>
void log_info(spdlog::format_string_t<Args...> format, Args&&... args) {
    spdlog::info(format, std::forward<Args>(args)...);
}
template <class... Args>
void log_warn(spdlog::format_string_t<Args...> format, Args&&... args) {
    spdlog::warn(format, std::forward<Args>(args)...);
}
template <class... Args>
void log_error(spdlog::format_string_t<Args...> format, Args&&... args) {
    spdlog::error(format, std::forward<Args>(args)...);
}

}  // namespace jostle::server
