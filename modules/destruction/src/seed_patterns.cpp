// SPDX-License-Identifier: MIT
#include "jostle/modules/seed_patterns.h"

#include <algorithm>
#include <string>

#include "jostle/modules/fractured_shape.h"
#include "jostle/physics/scalar.h"
#include "modules/destruction/src/next_uniform.h"

namespace jostle::modules {

using namespace physics;
using destruction_detail::next_uniform;

namespace {

constexpr int attempts_max = 200;  // per requested seed

Status check(const Aabb& bounds, const SeedPatternOptions& plan) {
    for (int k = 0; k < 3; k++) {
        const double side = bounds.high[k] - bounds.low[k];
        if (!(side >= 2 * min_shape_size && side <= 2 * max_shape_size))
            return invalid_argument(
                "a side of bounds is out of range; it must be from 2e-4 to 2e4 m");
    }
    if (plan.count < 1 || plan.count > static_cast<int>(chunks_max))
        return invalid_argument("count is " + std::to_string(plan.count) +
                                "; it must be from 1 to " + std::to_string(chunks_max));
    if (plan.center && !(is_finite(*plan.center) && length_squared(*plan.center) < 1e8))
        return invalid_argument("center is out of range; it must be finite and within 10 km");
    if (!(plan.spread >= 1e-3 && plan.spread <= 1))
        return invalid_argument("spread is " + std::to_string(plan.spread) +
                                "; it must be from 0.001 to 1");
    return {};
}

Vec3 middle_of(const Aabb& bounds) {
    return (bounds.low + bounds.high) * 0.5;
}

double longest_side(const Aabb& bounds) {
    const Vec3 sides = bounds.high - bounds.low;
    return maximum(sides.x, maximum(sides.y, sides.z));
}

Vec3 random_point(const Aabb& bounds, std::uint64_t& state) {
    const double x = next_uniform(state), y = next_uniform(state), z = next_uniform(state);
    return bounds.low + scaled(bounds.high - bounds.low, {x, y, z});
}

// Approximately normal distribution: the sum of twelve uniform numbers.
double random_gaussian(std::uint64_t& state) {
    double sum = -6;
    for (int k = 0; k < 12; k++) sum += next_uniform(state);
    return sum;
}

// Four of five points are in the cluster.
Vec3 in_cluster(const Aabb& bounds, const SeedPatternOptions& plan, Vec3 center,
                std::uint64_t& state) {
    if (next_uniform(state) < 0.2) return random_point(bounds, state);
    const double x = random_gaussian(state), y = random_gaussian(state), z = random_gaussian(state);
    return center + Vec3{x, y, z} * (0.5 * plan.spread * longest_side(bounds));
}

bool is_within(const Aabb& bounds, Vec3 p) {
    for (int k = 0; k < 3; k++)
        if (p[k] < bounds.low[k] || p[k] > bounds.high[k]) return false;
    return true;
}

Result<std::vector<Vec3>> random_points(const Aabb& bounds, const SeedPatternOptions& plan,
                                        const std::function<bool(Vec3)>& inside) {
    std::uint64_t state = plan.seed;
    const Vec3 center = plan.center.value_or(middle_of(bounds));
    std::vector<Vec3> seeds;
    const auto count = static_cast<std::size_t>(plan.count);
    for (std::size_t tries = 0; seeds.size() < count; tries++) {
        if (tries == attempts_max * count)
            return invalid_argument("only " + std::to_string(seeds.size()) + " of " +
                                    std::to_string(tries) +
                                    " sampled points are inside; the solid is too thin for its "
                                    "bounds, or center is too far away");
        const Vec3 p = plan.pattern == SeedPattern::uniform
                           ? random_point(bounds, state)
                           : in_cluster(bounds, plan, center, state);
        if (is_within(bounds, p) && (!inside || inside(p))) seeds.push_back(p);
    }
    return seeds;
}

// Newton's method, from above.
double cube_root(double x) {
    double root = maximum(1, x);
    for (int k = 0; k < 100; k++) root = (2 * root + x / (root * root)) / 3;
    return root;
}

// Blocks that are as close to cubes as the count allows.
std::vector<Vec3> blocks(const Aabb& bounds, int count) {
    const Vec3 sides = bounds.high - bounds.low;
    const double edge = cube_root(sides.x * sides.y * sides.z / count);
    int counts[3];
    for (int k = 0; k < 3; k++) counts[k] = std::max(1, static_cast<int>(sides[k] / edge + 0.5));
    while (static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]) *
               static_cast<std::size_t>(counts[2]) >
           chunks_max)
        (*std::max_element(counts, counts + 3))--;
    std::vector<Vec3> seeds;
    for (int z = 0; z < counts[2]; z++)
        for (int y = 0; y < counts[1]; y++)
            for (int x = 0; x < counts[0]; x++)
                seeds.push_back(bounds.low +
                                scaled(sides, {(x + 0.5) / counts[0], (y + 0.5) / counts[1],
                                               (z + 0.5) / counts[2]}));
    return seeds;
}

// Rings about the shortest axis, whose widths grow quadratically, with the same number of slightly
// randomized spokes in each.
std::vector<Vec3> rings(const Aabb& bounds, const SeedPatternOptions& plan) {
    const Vec3 sides = bounds.high - bounds.low;
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (sides[k] < sides[axis]) axis = k;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vec3 center = plan.center.value_or(middle_of(bounds));
    const double reach = 0.5 * square_root(sides[u] * sides[u] + sides[v] * sides[v]) +
                         length(center - middle_of(bounds));
    const int spokes = std::max(3, static_cast<int>(1.6 * square_root(plan.count)));
    const int count = std::max(1, (plan.count + spokes - 1) / spokes);
    std::uint64_t state = plan.seed;
    std::vector<Vec3> seeds;
    for (int ring = 0; ring < count; ring++)
        for (int spoke = 0; spoke < spokes; spoke++) {
            const double fraction = (ring + 0.3 + 0.4 * next_uniform(state)) / count;
            const double turn = 2 * pi * (spoke + 0.3 * next_uniform(state)) / spokes;
            Vec3 p = center;
            p[u] += reach * fraction * fraction * sin_cos(turn).cos;
            p[v] += reach * fraction * fraction * sin_cos(turn).sin;
            p[axis] = bounds.low[axis] + sides[axis] * (0.4 + 0.2 * next_uniform(state));
            if (is_within(bounds, p)) seeds.push_back(p);
        }
    if (seeds.empty()) seeds.push_back(middle_of(bounds));
    return seeds;
}

}  // namespace

Result<std::vector<Vec3>> generate_seeds(const Aabb& bounds, const SeedPatternOptions& plan,
                                         const std::function<bool(Vec3)>& inside) {
    if (Status s = check(bounds, plan); !s.ok()) return s.error();
    switch (plan.pattern) {
        case SeedPattern::grid:
            return blocks(bounds, plan.count);
        case SeedPattern::radial:
            return rings(bounds, plan);
        default:
            return random_points(bounds, plan, inside);
    }
}

}  // namespace jostle::modules
