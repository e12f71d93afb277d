// SPDX-License-Identifier: MIT
//
// A bar or a line on a terminal; nothing when the output goes elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace jostle::sim {

class Progress {
public:
    explicit Progress(std::uint64_t total);
    ~Progress();  // leaves the line clean
    void at(std::uint64_t done, int awake);

private:
    const std::uint64_t total_;
    const bool live_;
    std::chrono::steady_clock::time_point began_, last_{};
};

// Replaces the line on a terminal; empty: clears it.
void show_line(const std::string& text);

}  // namespace jostle::sim
