// SPDX-License-Identifier: MIT
//
// One line per event. Levels: debug is for developers; info reports events once for operators; warn
// reports a fault of a client or an overloaded machine; error reports a fault of the server.
// Nothing is logged per tick.
//
// Any thread may log, and logging never waits for the reader of the log: lines go through a bounded
// queue to a writing thread. A line is dropped and counted if the queue is full or the reader is
// too slow. Text from clients is escaped, so that one line is one event.
#pragma once

#include <spdlog/spdlog.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace jostle::server {

struct LogSettings {
    std::string level = "info";
    bool json = false;  // one {"time": ..., "level": ..., "message": ...} object per line
    int descriptor = 1;
};

// Call before the first line; until then lines go to standard output synchronously. Ignores
// SIGPIPE, so that a closed log pipe does not end the process.
void start_log(const LogSettings& settings);
// Writes the queued lines; does not wait for a stalled reader.
void stop_log();
// Lines dropped since start_log().
std::uint64_t log_lines_dropped();

struct LogLine {
    std::uint64_t number = 0;  // counts the lines from 1
    std::string time;          // RFC 3339 in UTC
    std::string level, text;
};
// The newest lines after line `after`, oldest first, of the last `log_tail_lines`. Empty before
// start_log(). Any thread.
inline constexpr std::size_t log_tail_lines = 500;
std::vector<LogLine> log_tail(std::uint64_t after);

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
