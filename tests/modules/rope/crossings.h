// SPDX-License-Identifier: MIT
//
// Counts how often links of ropes pass through each other between two steps.
#pragma once

#include <cstddef>
#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

// A link, at the start and at the end of a step.
struct MovingLink {
    physics::Vec3 first[2], last[2];  // its nodes, by time

    physics::Vec3 at(double along, double time) const {
        const physics::Vec3 a = first[0] + (first[1] - first[0]) * time;
        const physics::Vec3 b = last[0] + (last[1] - last[0]) * time;
        return a + (b - a) * along;
    }
};

// Six times the signed volume of the tetrahedron of both links: its sign tells their sides.
inline double signed_volume(const MovingLink& a, const MovingLink& b, double time) {
    const physics::Vec3 apart = b.at(0, time) - a.at(0, time);
    return dot(cross(a.at(1, time) - a.at(0, time), b.at(1, time) - b.at(0, time)), apart);
}

// Whether two lines that lie in one plane cross within both links.
inline bool cross_within(const MovingLink& a, const MovingLink& b, double time) {
    const physics::Vec3 u = a.at(1, time) - a.at(0, time), v = b.at(1, time) - b.at(0, time);
    const physics::Vec3 r = b.at(0, time) - a.at(0, time);
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), d = uu * vv - uv * uv;
    if (!(d > 1e-9 * uu * vv)) return false;
    const double s = (dot(r, u) * vv - dot(r, v) * uv) / d;
    const double t = (dot(r, u) * uv - dot(r, v) * uu) / d;
    return s >= 0 && s <= 1 && t >= 0 && t <= 1;
}

inline bool pass(const MovingLink& a, const MovingLink& b) {
    double low = 0, high = 1;
    const double before = signed_volume(a, b, 0);
    if (!(before * signed_volume(a, b, 1) < 0)) return false;
    for (int k = 0; k < 40; k++) {
        const double middle = 0.5 * (low + high);
        (before * signed_volume(a, b, middle) > 0 ? low : high) = middle;
    }
    return cross_within(a, b, low);
}

// Nodes of a rope at the start and at the end of a step.
struct MovingRope {
    std::vector<physics::Vec3> from, to;

    MovingLink link(std::size_t k) const { return {{from[k], to[k]}, {from[k + 1], to[k + 1]}}; }
    std::size_t links() const { return from.size() - 1; }
};

inline int count_passes(const MovingRope& a, const MovingRope& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.links(); i++)
        for (std::size_t j = 0; j < b.links(); j++)
            if (pass(a.link(i), b.link(j))) count++;
    return count;
}

// Through itself. `apart`: difference of the first two links that touch each other.
inline int count_passes(const MovingRope& rope, std::size_t apart) {
    int count = 0;
    for (std::size_t i = 0; i < rope.links(); i++)
        for (std::size_t j = i + apart; j < rope.links(); j++)
            if (pass(rope.link(i), rope.link(j))) count++;
    return count;
}

}  // namespace jostle::modules
