// SPDX-License-Identifier: MIT
#include "modules/crowd/src/linear_program.h"

#include <array>
#include <cmath>

namespace jostle::modules::crowd_detail {
namespace {

constexpr float parallel_sine = 1e-5f;  // lines with a smaller angle count as parallel

float along(const HalfPlane& plane, Velocity2 v) {
    return plane.x * v.x + plane.y * v.y;
}

bool obeys(const HalfPlane& plane, Velocity2 v) {
    return along(plane, v) >= plane.offset;
}

// Part of the boundary of a plane that obeys the planes before it and the speed limit: from low to
// high along `direction` from the point nearest to the origin. Empty if low > high.
struct Interval {
    Velocity2 foot, direction;
    float low = 1, high = 0;

    Velocity2 at(float t) const { return {foot.x + direction.x * t, foot.y + direction.y * t}; }
};

Interval permitted_interval(std::span<const HalfPlane> planes, std::size_t k, float max_speed) {
    const HalfPlane& line = planes[k];
    const float half_squared = max_speed * max_speed - line.offset * line.offset;
    if (half_squared < 0) return {};
    const float half = std::sqrt(half_squared);
    Interval part{{line.x * line.offset, line.y * line.offset}, {-line.y, line.x}, -half, half};
    for (std::size_t j = 0; j < k; j++) {
        // slope * t >= bound
        const float slope = along(planes[j], part.direction);
        const float bound = planes[j].offset - along(planes[j], part.foot);
        if (std::fabs(slope) < parallel_sine) {
            if (bound > 0) return {};
            continue;
        }
        const float t = bound / slope;
        if (slope > 0)
            part.low = t > part.low ? t : part.low;
        else
            part.high = t < part.high ? t : part.high;
        if (part.low > part.high) return {};
    }
    return part;
}

struct Solution {
    Velocity2 velocity;
    std::size_t obeyed = 0;  // planes.size() if all are obeyed; otherwise the first that failed
};

// Permitted velocity nearest to `wish`.
Solution solve_nearest(std::span<const HalfPlane> planes, Velocity2 wish, float max_speed) {
    const float squared = wish.x * wish.x + wish.y * wish.y;
    Velocity2 v = wish;
    if (squared > max_speed * max_speed) {
        const float scale = max_speed / std::sqrt(squared);
        v = {wish.x * scale, wish.y * scale};
    }
    for (std::size_t k = 0; k < planes.size(); k++) {
        if (obeys(planes[k], v)) continue;
        const Interval part = permitted_interval(planes, k, max_speed);
        if (part.low > part.high) return {v, k};
        const float t = part.direction.x * wish.x + part.direction.y * wish.y;
        v = part.at(t < part.low ? part.low : (t > part.high ? part.high : t));
    }
    return {v, planes.size()};
}

// Permitted velocity farthest along the normal of a plane.
Solution solve_farthest(std::span<const HalfPlane> planes, const HalfPlane& aim, float max_speed) {
    Velocity2 v{aim.x * max_speed, aim.y * max_speed};
    for (std::size_t k = 0; k < planes.size(); k++) {
        if (obeys(planes[k], v)) continue;
        const Interval part = permitted_interval(planes, k, max_speed);
        if (part.low > part.high) return {v, k};
        v = part.at(along(aim, part.direction) > 0 ? part.high : part.low);
    }
    return {v, planes.size()};
}

// Minimizes the largest violation d of the planes after the hard ones: the three-dimensional linear
// program in (v, d), solved on the plane of each constraint in turn.
Velocity2 solve_least_violation(std::span<const HalfPlane> planes, std::size_t hard,
                                std::size_t first, Velocity2 v, float max_speed) {
    std::array<HalfPlane, half_planes_max> lines;
    for (std::size_t k = 0; k < hard; k++) lines[k] = planes[k];
    float violation = 0;
    for (std::size_t i = first; i < planes.size(); i++) {
        if (planes[i].offset - along(planes[i], v) <= violation) continue;
        // Where plane j is violated at most as much as plane i.
        std::size_t count = hard;
        for (std::size_t j = hard; j < i; j++) {
            const float x = planes[j].x - planes[i].x, y = planes[j].y - planes[i].y;
            const float size = std::sqrt(x * x + y * y);
            if (size < parallel_sine) continue;
            lines[count++] = {x / size, y / size, (planes[j].offset - planes[i].offset) / size};
        }
        const Solution best = solve_farthest(std::span(lines).first(count), planes[i], max_speed);
        // A failure is a rounding error, because the previous velocity is feasible.
        if (best.obeyed == count) v = best.velocity;
        violation = planes[i].offset - along(planes[i], v);
    }
    return v;
}

}  // namespace

Velocity2 nearest_permitted_velocity(std::span<const HalfPlane> planes, std::size_t hard,
                                     Velocity2 wish, float max_speed) {
    const Solution all = solve_nearest(planes, wish, max_speed);
    if (all.obeyed == planes.size()) return all.velocity;
    // With contradicting hard planes, such as walls on both sides of a narrow gap, none is hard.
    const std::size_t kept = all.obeyed < hard ? 0 : hard;
    return solve_least_violation(planes, kept, all.obeyed, all.velocity, max_speed);
}

}  // namespace jostle::modules::crowd_detail
