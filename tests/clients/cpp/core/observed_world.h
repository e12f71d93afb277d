// SPDX-License-Identifier: MIT
//
// A world with analytically known motion, rendered through a simulated network. The web SDK has the
// same tests (clients/web/sdk/src/testing/observed_world.ts).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "jostle/base/network_simulator.h"
#include "jostle/client/interpolation.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::client {

// Bodies: 1 moves straight at 2 m/s. 2 runs a circle of 2 m at 3 m/s and rotates with it. 3 bounces
// 0.4 m high without loss and drifts at 0.5 m/s. 4 teleports by 5 m every 7 s. 5 exists for 3 s of
// every 6 s.
inline snapshot::Pose pose_at(std::uint32_t body, double s) {
    switch (body) {
        case 1:
            return {{2 * s, 0, 0}, {0, 0, 0, 1}};
        case 2:
            return {{2 * std::cos(1.5 * s), 0, 2 * std::sin(1.5 * s)},
                    {0, -std::sin(0.75 * s), 0, std::cos(0.75 * s)}};
        case 3: {
            const double g = 9.81, up = std::sqrt(2 * g * 0.4);
            const double t = std::fmod(s, 2 * up / g);
            return {{0.5 * s, up * t - g * t * t / 2, 0}, {0, 0, 0, 1}};
        }
        case 4:
            return {{5 * std::floor(s / 7), 0, 0}, {0, 0, 0, 1}};
        default:
            return {{0, 1, 0}, {0, 0, 0, 1}};
    }
}

inline double top_speed(std::uint32_t body) {
    constexpr double of[] = {0, 2, 3, 2.85, 0, 0};
    return of[body];
}

inline bool is_there(std::uint32_t body, double s) {
    return body != 5 || std::fmod(s, 6) < 3;
}

inline snapshot::QuantizedFrame frame_at(std::uint32_t number, double s) {
    snapshot::QuantizedFrame frame{.frame = number, .entities = {}};
    for (std::uint32_t body = 1; body <= 5; body++)
        if (is_there(body, s))
            frame.entities.push_back(snapshot::quantize(body, pose_at(body, s), false, {}));
    return frame;
}

// Measurements of the rendered frames.
struct Observation {
    int pictures = 0, backward_steps = 0, halfway_leaps = 0, ghosts = 0;
    double least_speed = 1, greatest_speed = 1;  // of the clock
    // mm. step_mm: motion in one rendered frame beyond 1.1 times the top speed. error_mm,
    // usual_error_mm: distance from the true position at the rendered time, maximum and 95th
    // percentile.
    double step_mm = 0, usual_error_mm = 0, error_mm = 0;
    double behind_ms = 0;  // mean delay behind the server
};

class Watcher {
public:
    // Adds a frame rendered at server time s that shows the time shown_s.
    void look(const std::vector<SmoothPose>& poses, double shown_s, double s, double seconds) {
        if (shown_s < 0) return;  // before the first frame
        double error = 0;
        for (const SmoothPose& now : poses)
            error = std::max(error, add_rendered_pose(now, shown_s, seconds));
        errors_.push_back(error);
        if (!last_.empty()) {
            const double speed = (shown_s - last_shown_) / seconds;
            seen_.backward_steps += speed < 0 ? 1 : 0;
            seen_.least_speed = std::min(seen_.least_speed, speed);
            seen_.greatest_speed = std::max(seen_.greatest_speed, speed);
        }
        seen_.behind_ms += 1000 * (s - shown_s);
        last_ = poses;
        last_shown_ = shown_s;
    }
    Observation seen() {
        std::sort(errors_.begin(), errors_.end());
        Observation all = seen_;
        all.pictures = static_cast<int>(errors_.size());
        all.error_mm = 1000 * errors_.back();
        all.usual_error_mm = 1000 * errors_[errors_.size() * 95 / 100];
        all.behind_ms /= all.pictures;
        return all;
    }

private:
    static double between(const snapshot::Pose& a, const snapshot::Pose& b) {
        return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1],
                          a.position[2] - b.position[2]);
    }
    double add_rendered_pose(const SmoothPose& now, double shown_s, double seconds) {
        if (now.entity == 4) {
            seen_.halfway_leaps += std::fmod(now.pose.position[0] + 0.1, 5) > 0.2 ? 1 : 0;
            return 0;
        }
        // The appearance and disappearance of a body may be off by the spacing of frames.
        if (!is_there(now.entity, shown_s) && !is_there(now.entity, shown_s + 0.02) &&
            !is_there(now.entity, shown_s - 0.1))
            seen_.ghosts++;
        for (const SmoothPose& before : last_) {
            if (before.entity != now.entity) continue;
            const double moved = between(now.pose, before.pose);
            const double explained = 1.1 * top_speed(now.entity) * seconds;
            seen_.step_mm = std::max(seen_.step_mm, 1000 * (moved - explained));
        }
        return between(now.pose, pose_at(now.entity, shown_s));
    }

    Observation seen_;
    std::vector<double> errors_;
    std::vector<SmoothPose> last_;
    double last_shown_ = 0;
};

// Renders `seconds` of frames, 60 per second, received over a simulated network, `pictures_hz`
// times per second.
inline Observation observe(const NetworkConditions& link_settings, double pictures_hz,
                           double seconds = 60) {
    constexpr std::int64_t epoch_us = 7'000'000'000;  // of the server's clock
    constexpr std::int64_t ours_us = 1'000'000;       // of the local clock at the same time
    NetworkSimulator link(link_settings);
    InterpolationBuffer buffer;
    Watcher watcher;
    std::uint32_t next = 1;
    std::int64_t arrival_us = link.send(0).arrival_us;
    const auto pictures = static_cast<int>(seconds * pictures_hz);
    for (int picture = 0; picture < pictures; picture++) {
        const std::int64_t us = std::llround(picture * 1e6 / pictures_hz);
        for (; arrival_us <= us; next++) {
            const std::int64_t due_us = std::llround((next - 1) * 1e6 / 60);
            buffer.add(frame_at(next, static_cast<double>(due_us) / 1e6), epoch_us + due_us,
                       ours_us + arrival_us);
            arrival_us = link.send(std::llround(next * 1e6 / 60)).arrival_us;
        }
        const auto poses = buffer.sample(ours_us + us, {});
        const double shown_s =
            static_cast<double>(buffer.clock().render_time_us() - epoch_us) / 1e6;
        if (!poses.empty())
            watcher.look(poses, shown_s, static_cast<double>(us) / 1e6, 1 / pictures_hz);
    }
    return watcher.seen();
}

}  // namespace jostle::client
