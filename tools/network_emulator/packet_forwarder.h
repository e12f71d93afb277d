// SPDX-License-Identifier: MIT
//
// Network emulator for IP packets, so that TCP and UDP are affected alike: two TUN devices, one per
// network namespace. A packet sent into one device leaves the other one; it can be lost, duplicated
// or reordered. Requires root. One thread.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

#include "jostle/base/network_queue.h"
#include "jostle/base/result.h"

namespace jostle::network_emulator {

using Clock = std::chrono::steady_clock;

struct PacketForwarderSettings {
    std::array<std::string, 2> devices;  // unused names
    NetworkConditions conditions;        // the same in both directions
};

class PacketForwarder {
public:
    explicit PacketForwarder(PacketForwarderSettings settings) : settings_(std::move(settings)) {}
    ~PacketForwarder();
    PacketForwarder(const PacketForwarder&) = delete;
    PacketForwarder& operator=(const PacketForwarder&) = delete;

    // Creates the devices; the destructor removes them. Errors name the device and the cause.
    Status open();
    void run(const std::atomic<bool>& stop);

    std::uint64_t forwarded() const { return forwarded_; }
    std::uint64_t lost() const { return lost_; }

private:
    struct Direction {
        int from, to;
        NetworkQueue<std::string> packets;
    };
    void read(Direction& direction, Clock::time_point now);
    void write_due(Direction& direction, Clock::time_point now);

    const PacketForwarderSettings settings_;
    std::array<int, 2> devices_{-1, -1};
    std::uint64_t forwarded_ = 0, lost_ = 0;
};

}  // namespace jostle::network_emulator
