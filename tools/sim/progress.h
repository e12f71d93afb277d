// SPDX-License-Identifier: MIT
//
// A progress bar or line on a terminal; prints nothing elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace jostle::sim {

class Progress {
public:
    explicit Progress(std::uint64_t total);
    ~Progress();  // clears the line
    void at(std::uint64_t done, int awake);

private:
    const std::uint64_t total_;
    const bool live_;
    std::chrono::steady_clock::time_point began_, last_{};
};

// Replaces the line on a terminal; an empty text clears it.
void show_line(const std::string& text);

}  // namespace jostle::sim
