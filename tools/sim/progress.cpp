// SPDX-License-Identifier: MIT
#include "tools/sim/progress.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace jostle::sim {

using std::chrono::steady_clock;

Progress::Progress(std::uint64_t total)
    : total_(total), live_(isatty(STDERR_FILENO) != 0), began_(steady_clock::now()) {}

Progress::~Progress() {
    if (live_) std::fputs("\r\033[K", stderr);
}

void Progress::at(std::uint64_t done, int awake) {
    if (!live_) return;
    const auto now = steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100) && done < total_) return;
    last_ = now;
    const double share = static_cast<double>(done) / static_cast<double>(total_);
    const double passed = std::chrono::duration<double>(now - began_).count();
    const double left = share > 0 ? passed * (1 - share) / share : 0;
    const auto full = static_cast<std::size_t>(share * 30);
    const std::string bar = std::string(full, '#') + std::string(30 - full, '.');
    std::fprintf(stderr, "\r[%s] %3.0f %%  %llu of %llu steps  %d awake  %.0f s left \033[K",
                 bar.c_str(), share * 100, static_cast<unsigned long long>(done),
                 static_cast<unsigned long long>(total_), awake, left);
}

void show_line(const std::string& text) {
    if (isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "\r%s\033[K", text.c_str());
}

}  // namespace jostle::sim
