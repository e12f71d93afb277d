// SPDX-License-Identifier: MIT
#include "bench/broadphase_workload.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "physics/src/collision/broadphase/fat_box.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::bench {
namespace {

using namespace physics;

constexpr double dt = 1.0 / 60;
constexpr double filled = 0.6;  // share of the volume, as in a heap of boxes
constexpr std::size_t ray_count = 1000;
constexpr double ray_length_max = 100;  // m

class Random {
public:
    // The standard defines the bits of the engine, but not those of the library's distributions.
    double in(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    std::size_t below(std::size_t count) { return engine_() % count; }
    Vec3 point_in(const Aabb& box) {
        const double x = in(box.low.x, box.high.x), y = in(box.low.y, box.high.y);
        return {x, y, in(box.low.z, box.high.z)};
    }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = point_in({{-1, -1, -1}, {1, 1, 1}});
            const double l2 = length_squared(v);
            if (l2 > 0.01 && l2 < 1) return v / std::sqrt(l2);
        }
    }

private:
    std::mt19937_64 engine_{20};
};

struct Body {
    Vec3 center, half, velocity;
    Aabb fat;
    Aabb tight() const { return {center - half, center + half}; }
};

Aabb enlarge_aabb(const Body& body) {
    return fat_box(body.tight(), body.velocity * dt, length(body.half));
}

bool left_fat_aabb(const Body& body) {
    return !contains(body.fat, grow(body.tight(), 0.25 * tuning::fat_margin));
}

Vec3 random_half(Arrangement arrangement, Random& random) {
    if (arrangement != Arrangement::sizes) {
        const double x = random.in(0.4, 0.6), y = random.in(0.4, 0.6);
        return {x, y, random.in(0.4, 0.6)};
    }
    const double half = 0.05 * std::pow(100, random.in(0, 1));
    return {half, half, half};
}

// Places boxes on a lattice, each displaced by up to a quarter of the pitch: the density is
// uniform, as in a heap, and neighbours touch.
std::vector<Body> place_bodies(Arrangement arrangement, std::uint32_t count, Random& random) {
    std::vector<Body> bodies(count);
    double volume = 0;
    for (Body& body : bodies) {
        body.half = random_half(arrangement, random);
        volume += 8 * body.half.x * body.half.y * body.half.z;
    }
    const bool flat = arrangement == Arrangement::flat;
    const double pitch = flat ? 2 : std::cbrt(volume / filled / count);
    const double root = flat ? std::sqrt(count) : std::cbrt(count);
    const auto side = static_cast<std::uint32_t>(std::ceil(root - 1e-9));
    for (std::uint32_t k = 0; k < count; k++) {
        const std::uint32_t x = k % side, z = k / side % side, y = k / side / side;
        const double off = 0.25 * pitch;
        const Vec3 jitter =
            random.point_in({{-off, flat ? 0 : -off, -off}, {off, flat ? 0 : off, off}});
        bodies[k].center =
            Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)} * pitch +
            jitter;
    }
    // In a world that has run for a while, the order of the bodies does not follow their positions.
    for (std::size_t k = bodies.size(); k > 1; k--)
        std::swap(bodies[k - 1], bodies[random.below(k)]);
    return bodies;
}

Aabb room_of(const std::vector<Body>& bodies) {
    Aabb room{bodies[0].center, bodies[0].center};
    for (const Body& body : bodies) room = unite(room, {body.center, body.center});
    return room;
}

// Moves the body straight on and reflects it at the walls, which keeps the density constant.
void advance(Body& body, const Aabb& room) {
    body.center += body.velocity * dt;
    for (int k = 0; k < 3; k++)
        if ((body.center[k] < room.low[k] && body.velocity[k] < 0) ||
            (body.center[k] > room.high[k] && body.velocity[k] > 0))
            body.velocity[k] = -body.velocity[k];
}

// Enough steps for the resolution of the clock; a step of 100,000 bodies is long enough by itself.
std::size_t step_count(Moving moving, std::uint32_t bodies) {
    if (moving == Moving::none) return 10000;
    return bodies <= 300 ? 300 : bodies <= 3000 ? 100 : bodies <= 30000 ? 20 : 5;
}

std::vector<BoxRay> random_rays(const Aabb& room, Random& random) {
    std::vector<BoxRay> rays(ray_count);
    for (BoxRay& ray : rays) {
        ray.origin = random.point_in(room);
        ray.origin.y = room.high.y + 1;
        ray.motion = random.point_in(room) - ray.origin;
        const double long_by = length(ray.motion) / ray_length_max;
        if (long_by > 1) ray.motion = ray.motion / long_by;
    }
    return rays;
}

}  // namespace

Workload generate_workload(Arrangement arrangement, Moving moving, std::uint32_t count) {
    Random random;
    std::vector<Body> bodies = place_bodies(arrangement, count, random);
    Aabb room = room_of(bodies);
    const std::uint32_t movers = moving == Moving::all   ? count
                                 : moving == Moving::few ? std::max(1u, count / 100)
                                                         : 0;
    for (std::uint32_t k = 0; k < count; k++) {
        if (k < movers) {
            bodies[k].velocity = random.direction() * random.in(0.5, 3);
            if (arrangement == Arrangement::flat) bodies[k].velocity.y = 0;
        }
        bodies[k].fat = enlarge_aabb(bodies[k]);
    }
    const auto step = [&](auto&& left) {
        for (std::uint32_t k = 0; k < movers; k++) {
            advance(bodies[k], room);
            if (!left_fat_aabb(bodies[k])) continue;
            bodies[k].fat = enlarge_aabb(bodies[k]);
            left(k);
        }
    };
    // The fat boxes initially have the same age, and all bodies would leave theirs in the same
    // step.
    for (int k = 0; k < 60; k++) step([](std::uint32_t) {});

    Workload work;
    for (const Body& body : bodies) work.fat.push_back(body.fat);
    work.steps.resize(step_count(moving, count));
    for (auto& moves : work.steps) {
        step([&](std::uint32_t k) { moves.push_back({k, bodies[k].fat}); });
        work.moves += moves.size();
    }
    for (const Body& body : bodies) {
        work.tight.push_back(body.tight());
        room = unite(room, body.tight());
    }
    work.rays = random_rays(room, random);
    return work;
}

}  // namespace jostle::bench
