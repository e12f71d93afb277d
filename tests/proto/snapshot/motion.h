// SPDX-License-Identifier: MIT
//
// Seeded worlds whose bodies move, rest, appear and vanish, as input of the codecs. The generator
// is our own, so that every machine generates the same frames.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "jostle/snapshot/quantize.h"

namespace jostle::snapshot {

class Random {
public:
    explicit Random(std::uint32_t seed) : state_(seed) {}
    double in(double low, double high) {
        state_ = state_ * 1664525u + 1013904223u;
        return low + (high - low) * (state_ >> 8) / 16777216.0;
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(in(0, n)); }

private:
    std::uint32_t state_;
};

// Chances of changes per body and tick.
struct MotionStyle {
    double calm = 0.3;   // share of bodies that do not move
    double spin = 3;     // rad/s, maximum
    double speed = 4;    // m/s, maximum
    double kick = 0.02;  // chance of a sudden velocity change
    double rest = 0.02;  // chance to fall asleep or wake
    double vanish = 0.005;
    double appear = 0.3;  // new bodies per tick
};

class MovingWorld {
public:
    MovingWorld(std::uint32_t seed, std::size_t bodies, MotionStyle style)
        : random_(seed), style_(style) {
        for (std::size_t i = 0; i < bodies; i++) add();
    }

    QuantizedFrame step(std::uint32_t frame, const QuantSpec& spec) {
        for (std::size_t i = 0; i < bodies_.size();) {
            Body& b = bodies_[i];
            if (random_.in(0, 1) < style_.vanish) {
                bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(i));
                continue;
            }
            if (random_.in(0, 1) < style_.rest) b.at_rest = !b.at_rest;
            if (random_.in(0, 1) < style_.kick) kick(b);
            if (!b.at_rest && !b.calm) move(b);
            i++;
        }
        if (random_.in(0, 1) < style_.appear) add();
        QuantizedFrame out{.frame = frame};
        for (const Body& b : bodies_)
            out.entities.push_back(quantize(b.id, b.pose, b.at_rest, spec));
        return out;
    }

private:
    struct Body {
        std::uint32_t id;
        Pose pose;
        double v[3], w[3];
        bool calm, at_rest;
    };

    void kick(Body& b) {
        for (int k = 0; k < 3; k++) {
            b.v[k] = random_.in(-style_.speed, style_.speed);
            b.w[k] = random_.in(-style_.spin, style_.spin);
        }
    }
    void add() {
        Body b{};
        b.id = next_id_;
        next_id_ += 1 + random_.below(3);
        for (double& p : b.pose.position) p = random_.in(-20, 20);
        double norm = 0;
        for (double& q : b.pose.rotation) {
            q = random_.in(-1, 1);
            norm += q * q;
        }
        for (double& q : b.pose.rotation) q /= std::sqrt(norm);
        b.calm = random_.in(0, 1) < style_.calm;
        kick(b);
        bodies_.push_back(b);
    }
    void move(Body& b) {
        constexpr double h = 1.0 / 60;
        for (std::size_t k = 0; k < 3; k++) b.pose.position[k] += h * b.v[k];
        auto& q = b.pose.rotation;
        const double x = b.w[0] * h / 2, y = b.w[1] * h / 2, z = b.w[2] * h / 2;
        const std::array<double, 4> d{
            x * q[3] + y * q[2] - z * q[1], y * q[3] + z * q[0] - x * q[2],
            z * q[3] + x * q[1] - y * q[0], -x * q[0] - y * q[1] - z * q[2]};
        double norm = 0;
        for (std::size_t k = 0; k < 4; k++) {
            q[k] += d[k];
            norm += q[k] * q[k];
        }
        for (double& c : q) c /= std::sqrt(norm);
    }

    Random random_;
    MotionStyle style_;
    std::vector<Body> bodies_;
    std::uint32_t next_id_ = 1;
};

}  // namespace jostle::snapshot
