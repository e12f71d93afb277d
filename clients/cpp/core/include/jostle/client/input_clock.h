// SPDX-License-Identifier: MIT
//
// Which tick of the server an input that is made now is meant for (Input.tick). It runs ahead of
// the server, so that inputs arrive before their tick: the server tells by how much (the margin,
// Private.input_margin_us), and this clock is steered until that is a tick and four times its
// jitter. Within a tick of that it runs evenly; after three margins in a row beyond, at 1.05 or
// 0.95 times the speed, for as long as it takes; more than ten ticks off, it jumps. One thread at a
// time.
#pragma once

#include <cstdint>

namespace jostle::client {

class InputClock {
public:
    // A stream of a world with so many ticks a second begins.
    void begin(double tick_hz);
    // A frame arrived: its tick was due so long ago, by the server's clock and with half a round
    // trip, the time of an input on its way. now_us is on our clock.
    void on_frame(std::uint32_t tick, double due_ago_us, double one_way_us, std::int64_t now_us);
    // Inputs up to that number have left.
    void sent(std::uint32_t sequence) { last_sent_sequence_ = sequence; }
    // The server told the margin of an input. That of one that was sent before the last jump tells
    // nothing, nor does 0: it knows none.
    void on_margin(std::uint32_t sequence, double margin_us);

    bool ready() const { return ready_; }
    // In ticks, with a fraction; never back but by a jump. 0 until ready.
    double position(std::int64_t now_us);
    // The tick that an input of now is meant for: the next whole one.
    std::uint32_t tick(std::int64_t now_us);

    double margin_ms() const { return mean_us_ / 1000; }  // as told, smoothed
    double target_ms() const { return target_us() / 1000; }
    double speed() const { return speed_; }
    int jumps() const { return jumps_; }

private:
    double target_us() const;
    void jump(double ticks);

    double tick_us_ = 1e6 / 60;
    bool ready_ = false, measured_ = false;
    double position_ = 0, speed_ = 1, correction_us_ = 0;  // how much is still to be won or lost
    std::int64_t now_us_ = 0;
    double mean_us_ = 0, last_us_ = 0, jitter_us_ = 0;
    int frames_since_margin_ = 0;  // since the last margin
    int consecutive_out_of_range_ =
        0;  // how many margins in a row were beyond; negative: short of it
    int jumps_ = 0;
    std::uint32_t last_sent_sequence_ = 0, last_margin_sequence_ = 0;  // newest
};

}  // namespace jostle::client
