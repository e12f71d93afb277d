// SPDX-License-Identifier: MIT
//
// Seeded random numbers (SplitMix64) that are equal on every machine, unlike the standard
// distributions.
#pragma once

#include <cstdint>

#include "jostle/physics/quat.h"

namespace jostle::test {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15ull;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    double in(double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    }
    std::uint64_t below(std::uint64_t count) { return bits() % count; }
    physics::Vec3 vector(double size) {
        const double x = in(-size, size), y = in(-size, size), z = in(-size, size);
        return {x, y, z};
    }
    physics::Vec3 direction() {
        for (;;) {
            const physics::Vec3 v = vector(1);
            const double l2 = physics::length_squared(v);
            if (l2 > 0.01 && l2 < 1) return physics::normalized(v);
        }
    }
    physics::Quat rotation() {
        for (;;) {
            const physics::Vec3 v = vector(1);
            const physics::Quat q{v.x, v.y, v.z, in(-1, 1)};
            const double n = physics::norm_squared(q);
            if (n > 0.01 && n < 1) return physics::normalized(q);
        }
    }

private:
    std::uint64_t state_;
};

}  // namespace jostle::test
