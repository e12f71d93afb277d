// SPDX-License-Identifier: MIT
//
// A bar on a terminal; nothing when the output goes elsewhere.
#pragma once

#include <chrono>
#include <cstdint>

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

}  // namespace jostle::sim
