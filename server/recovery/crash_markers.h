// SPDX-License-Identifier: MIT
//
// Which tick a world was in when its process crashed: in a file that is mapped into memory, so that
// to write it costs nothing and it outlives the process. A signal handler counts crashes; a kill
// from outside is none.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "jostle/base/result.h"

namespace jostle::server {

// Of one world, of one thread at a time.
class CrashMarker {
public:
    struct Slot {
        char world[40];                           // its id; empty: free
        std::atomic<std::uint32_t> running_tick;  // the tick that runs now; 0: none
        std::uint32_t tick;                       // the one that crashed last
        std::uint32_t crashes;                    // in a row, in that tick
    };

    CrashMarker() = default;  // marks nothing
    explicit CrashMarker(Slot* slot) : slot_(slot) {}

    void begin(std::uint32_t tick) const {
        if (slot_) slot_->running_tick.store(tick, std::memory_order_relaxed);
    }
    void end() const { begin(0); }
    // How often in a row it crashed in that tick; 0: in none.
    std::uint32_t crashes() const { return slot_ ? slot_->crashes : 0; }
    std::uint32_t crashed_tick() const { return slot_ ? slot_->tick : 0; }
    void forget() const;

private:
    Slot* slot_ = nullptr;
};

class CrashMarkers {
public:
    static constexpr std::size_t worlds_max = 1024;  // the others are not marked

    // Makes the file, mode 0600, if there is none or what is there is no such file.
    static Result<std::unique_ptr<CrashMarkers>> open(const std::string& path);
    ~CrashMarkers();
    CrashMarkers(const CrashMarkers&) = delete;
    CrashMarkers& operator=(const CrashMarkers&) = delete;

    // The world's mark, a new one if it has none. One thread at a time.
    CrashMarker of(const std::string& world);
    void drop(const std::string& world);
    // Every tick that runs now crashed. Safe in a signal handler.
    void on_crash();

    // From now on a fatal signal is counted in these before it ends the process; null: in none.
    static void count_fatal_signals(CrashMarkers* marks);

private:
    struct File;
    explicit CrashMarkers(File* file) : file_(file) {}

    File* file_;
};

}  // namespace jostle::server
