// SPDX-License-Identifier: MIT
//
// Records the running tick of each world in a memory-mapped file, so that a crash of the process
// can be attributed to a tick. Writing is free, and the file outlives the process. A signal handler
// counts crashes; a kill from outside does not count.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "jostle/base/result.h"

namespace jostle::server {

// The marker of one world; used by one thread at a time.
class CrashMarker {
public:
    struct Slot {
        char world[40];                           // world id; empty: free
        std::atomic<std::uint32_t> running_tick;  // the running tick; 0: none
        std::uint32_t tick;                       // the last tick that crashed
        std::uint32_t crashes;                    // consecutive crashes in that tick
    };

    CrashMarker() = default;  // records nothing
    explicit CrashMarker(Slot* slot) : slot_(slot) {}

    void begin(std::uint32_t tick) const {
        if (slot_) slot_->running_tick.store(tick, std::memory_order_relaxed);
    }
    void end() const { begin(0); }
    // Consecutive crashes in crashed_tick(); 0: no crash.
    std::uint32_t crashes() const { return slot_ ? slot_->crashes : 0; }
    std::uint32_t crashed_tick() const { return slot_ ? slot_->tick : 0; }
    void forget() const;

private:
    Slot* slot_ = nullptr;
};

class CrashMarkers {
public:
    static constexpr std::size_t worlds_max = 1024;  // further worlds are not recorded

    // Creates the file with mode 0600 if it does not exist or is not a marker file.
    static Result<std::unique_ptr<CrashMarkers>> open(const std::string& path);
    ~CrashMarkers();
    CrashMarkers(const CrashMarkers&) = delete;
    CrashMarkers& operator=(const CrashMarkers&) = delete;

    // False if the disk is full: the markers then end with the process.
    bool is_stored() const { return is_stored_; }
    // The marker of the world; a new one if it has none. One thread at a time.
    CrashMarker of(const std::string& world);
    void drop(const std::string& world);
    // Counts a crash for every running tick. Async-signal-safe.
    void on_crash();

    // From now on these markers count fatal signals before the process ends; null: no counting.
    static void count_fatal_signals(CrashMarkers* marks);

private:
    struct File;
    CrashMarkers(File* file, bool is_stored) : file_(file), is_stored_(is_stored) {}

    File* file_;
    const bool is_stored_;
};

}  // namespace jostle::server
