// SPDX-License-Identifier: MIT
//
// A bad link, for tests and demonstrations: says when a message that is sent now arrives at the
// other end of a stream. Nothing is lost or overtaken, as on TCP: a lost message comes a
// retransmission later, and those behind it wait. The same seed gives the same link, here and in
// the browser (clients/web/src/link_conditioner.ts). One direction each; one thread at a time.
#pragma once

#include <cstdint>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::client {

struct LinkSettings {
    double delay_ms = 0;           // of every message
    double jitter_ms = 0;          // on top, from 0 to this, each alike
    double tail_ms = 0;            // on top, exponential with this mean
    double stalls_ms = 0;          // how long nothing arrives
    double stall_every_ms = 5000;  // from the beginning of one stall to the next: 0.5 to 1.5 times
    double loss = 0;               // share of messages that are sent a second time, 0 to 1
    double retransmit_ms = 200;    // that much later
    std::uint32_t seed = 1;

    // Whether it does anything.
    bool bad() const {
        return delay_ms > 0 || jitter_ms > 0 || tail_ms > 0 || stalls_ms > 0 || loss > 0;
    }
};

// From "delay=80,jitter=20,stalls=250": the names of the fields without their units. An error names
// what cannot be read.
Result<LinkSettings> read_link_settings(std::string_view text);

class LinkConditioner {
public:
    explicit LinkConditioner(const LinkSettings& settings);

    // When a message that is sent now arrives; times rise, in microseconds of any clock.
    std::int64_t arrival_us(std::int64_t sent_us);

private:
    double chance();  // 0 to 1, less than 1
    std::int64_t after_stalls(std::int64_t arrival_us);

    LinkSettings settings_;
    std::uint32_t random_;
    std::int64_t last_arrival_us_ = 0;
    std::int64_t stall_us_ = 0;  // begin of the next stall, or of the one that is on
    bool begun_ = false;
};

}  // namespace jostle::client
