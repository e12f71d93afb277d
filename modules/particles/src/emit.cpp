// SPDX-License-Identifier: MIT
#include "modules/particles/src/emit.h"

#include <algorithm>
#include <cmath>

#include "jostle/physics/scalar.h"

namespace jostle::modules::particles_detail {

using namespace physics;

namespace {

// Numbers of one particle, even in [0, 1): SplitMix64 (G. Steele et al., "Fast splittable
// pseudorandom number generators", 2014), started from seed, stream and number.
class ParticleRandom {
public:
    ParticleRandom(std::uint32_t seed, std::uint32_t stream, std::uint64_t number)
        : state_((std::uint64_t{seed} << 32 | stream) * 0xd1342543de82ef95ULL +
                 number * 0x2545f4914f6cdd1dULL) {}

    double unit() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double in(double low, double high) { return low + (high - low) * unit(); }

private:
    std::uint64_t state_;
};

constexpr double two_pi = 2 * pi;

// Two unit vectors that form a right-handed basis with n.
struct Tangents {
    Vec3 a, b;

    explicit Tangents(Vec3 n) {
        const Vec3 other = absolute(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        a = normalized(cross(n, other));
        b = cross(n, a);
    }
};

// In the plane, discs and boxes lose their extent along z, spheres become discs and cones sectors.
Vec3 place_of(const Emitter& e, Vec3 axis, ParticleRandom& random, bool planar) {
    const double u = random.unit(), v = random.unit(), w = random.unit();
    const SinCos turn = sin_cos(two_pi * u);
    switch (e.shape) {
        case EmitterShape::point:
            break;
        case EmitterShape::disc: {
            if (planar) return e.position + Vec3{-axis.y, axis.x, 0} * (e.radius * (2 * v - 1));
            const Tangents t(axis);
            const double r = e.radius * square_root(v);
            return e.position + t.a * (r * turn.cos) + t.b * (r * turn.sin);
        }
        case EmitterShape::box:
            return e.position +
                   scaled(e.half_extents, {2 * u - 1, 2 * v - 1, planar ? 0 : 2 * w - 1});
        case EmitterShape::sphere: {
            if (planar)
                return e.position + Vec3{turn.cos, turn.sin, 0} * (e.radius * square_root(v));
            const double z = 2 * v - 1, side = square_root(maximum(1 - z * z, 0));
            // The cube root of w by Newton's method: w = r^3.
            double r = 0.5 + 0.5 * w;
            for (int k = 0; k < 24; k++) r -= (r * r * r - w) / (3 * r * r);
            return e.position + Vec3{side * turn.cos, side * turn.sin, z} * (e.radius * r);
        }
    }
    return e.position;
}

Vec3 direction_of(const Emitter& e, Vec3 axis, ParticleRandom& random, bool planar) {
    const double u = random.unit(), v = random.unit();
    if (e.cone == 0) return axis;
    if (planar) {
        const SinCos turn = sin_cos(e.cone * (2 * u - 1));
        return {axis.x * turn.cos - axis.y * turn.sin, axis.x * turn.sin + axis.y * turn.cos, 0};
    }
    // Even in solid angle: the cosine is even.
    const double cosine = 1 - v * (1 - sin_cos(e.cone).cos);
    const double sine = square_root(maximum(1 - cosine * cosine, 0));
    const SinCos turn = sin_cos(two_pi * u);
    const Tangents t(axis);
    return axis * cosine + t.a * (sine * turn.cos) + t.b * (sine * turn.sin);
}

EmittedParticle particle(const Emitter& e, std::uint32_t stream, std::uint64_t number, double time,
                         bool planar) {
    ParticleRandom random(e.seed, stream, number);
    Vec3 axis = e.direction;
    if (planar) axis.z = 0;
    axis = normalized(axis);
    EmittedParticle made{.time = time, .id = static_cast<std::uint32_t>(2 * number + stream)};
    made.position = place_of(e, axis, random, planar);
    if (planar) made.position.z = 0;
    // One statement each: the order of random numbers must not depend on the compiler.
    const Vec3 direction = direction_of(e, axis, random, planar);
    const double speed = e.speed * random.in(1 - e.speed_spread, 1 + e.speed_spread);
    made.velocity = direction * speed;
    made.lifetime =
        maximum(e.lifetime * random.in(1 - e.lifetime_spread, 1 + e.lifetime_spread), 1e-3);
    return made;
}

double end_of(const Emitter& e, double to) {
    return e.duration > 0 ? minimum(to, e.start + e.duration) : to;
}

// The first k with start + k * period >= time.
std::uint64_t first_from(double start, double period, double time) {
    if (time <= start) return 0;
    const double guess = std::floor((time - start) / period);
    if (!(guess < 0x1p53)) return std::uint64_t{1} << 53;
    auto k = static_cast<std::uint64_t>(guess);
    // The guess is wrong by rounding only. The limit bounds the loops for extreme numbers.
    for (int n = 0; n < 1000 && k > 0 && start + static_cast<double>(k - 1) * period >= time; n++)
        k--;
    for (int n = 0; n < 1000 && start + static_cast<double>(k) * period < time; n++) k++;
    return k;
}

}  // namespace

EmittedRange emitted_at_rate(const Emitter& e, double from, double to, std::uint64_t most) {
    if (e.rate == 0) return {};
    EmittedRange range{first_from(e.start, 1 / e.rate, from),
                       first_from(e.start, 1 / e.rate, end_of(e, to))};
    range.first = std::max(range.first, range.last - std::min(range.last, most));
    range.first = std::min(range.first, range.last);
    return range;
}

EmittedRange emitted_in_bursts(const Emitter& e, double from, double to, std::uint64_t most) {
    if (e.burst == 0) return {};
    const double last_time = end_of(e, to);
    EmittedRange range;
    if (e.burst_period == 0) {
        const bool now = e.start >= from && e.start < last_time;
        range = {0, now ? std::uint64_t{e.burst} : 0};
    } else {
        range = {first_from(e.start, e.burst_period, from) * e.burst,
                 first_from(e.start, e.burst_period, last_time) * e.burst};
    }
    range.first = std::max(range.first, range.last - std::min(range.last, most));
    range.first = std::min(range.first, range.last);
    return range;
}

EmittedParticle particle_at_rate(const Emitter& e, std::uint64_t number, bool planar) {
    return particle(e, 0, number, e.start + static_cast<double>(number) * (1 / e.rate), planar);
}

EmittedParticle particle_of_burst(const Emitter& e, std::uint64_t number, bool planar) {
    const auto burst = static_cast<double>(number / e.burst);
    return particle(e, 1, number, e.start + burst * e.burst_period, planar);
}

}  // namespace jostle::modules::particles_detail
