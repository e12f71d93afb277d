// SPDX-License-Identifier: MIT
//
// Levels with a meaning each, one line per event: debug for what a developer follows, info for what
// an operator wants to know of once, warn for what a client did wrong or the machine could not keep
// up with, error for what is our fault. Nothing is logged per tick.
#pragma once

#include <spdlog/spdlog.h>

#include <utility>

namespace jostle::server {

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
