// SPDX-License-Identifier: MIT
//
// Determines the server tick for which an input made now is meant (Input.tick). The clock runs
// ahead of the server, so that inputs arrive before their tick. The server reports the arrival
// margin (ClientUpdate.input_margin_us). The clock steers the margin to one tick plus four times
// its jitter. Within a quarter of a tick of that target the clock runs at normal speed. After three
// successive smoothed margins outside, it runs at 1.003 or 0.997 times the speed until the error is
// corrected, or at 1.05 or 0.95 if the error exceeds one tick. With an error above ten ticks it
// jumps. One thread at a time.
#pragma once

#include <cstdint>

namespace jostle::client {

/// The clock of timed inputs.
class InputClock {
public:
    /// Starts a stream of a world with this tick rate.
    void begin(double tick_hz);
    /// Adds an arrived frame. `due_ago_us`: time since its tick was due on the server's clock.
    /// `one_way_us`: half a round trip, the transit time of an input. `now_us`: local clock.
    void on_frame(std::uint32_t tick, double due_ago_us, double one_way_us, std::int64_t now_us);
    /// Inputs up to this sequence number were sent.
    void sent(std::uint32_t sequence) { last_sent_sequence_ = sequence; }
    /// Adds the margin that the server reported for an input. Ignores margins of inputs sent before
    /// the last jump, and a margin of 0, which means unknown.
    void on_margin(std::uint32_t sequence, double margin_us);

    /// At least one frame was added.
    bool ready() const { return ready_; }
    /// Position in ticks, with a fraction; decreases only by a jump. 0 until ready.
    double position(std::int64_t now_us);
    /// Tick for an input made now: the next whole tick.
    std::uint32_t tick(std::int64_t now_us);

    double margin_ms() const { return mean_us_ / 1000; }  ///< reported by the server, smoothed
    /// The margin that the clock steers to, ms.
    double target_ms() const { return target_us() / 1000; }
    /// Current speed relative to real time.
    double speed() const { return speed_; }
    /// Number of jumps.
    int jumps() const { return jumps_; }

private:
    double target_us() const;
    void adjust_speed(double off_us);
    void jump(double ticks);

    double tick_us_ = 1e6 / 60;
    bool ready_ = false, measured_ = false;
    // correction_us_: remaining error to correct
    double position_ = 0, speed_ = 1, correction_us_ = 0;
    std::int64_t now_us_ = 0;
    double mean_us_ = 0, last_us_ = 0, jitter_us_ = 0;
    int frames_since_margin_ = 0;       // frames since the last margin
    int consecutive_out_of_range_ = 0;  // successive margins outside; negative: below the target
    int jumps_ = 0;
    std::uint32_t last_sent_sequence_ = 0, last_margin_sequence_ = 0;  // newest
};

}  // namespace jostle::client
