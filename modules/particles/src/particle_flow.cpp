// SPDX-License-Identifier: MIT
#include "jostle/modules/particle_flow.h"

#include "jostle/modules/curl_noise.h"

namespace jostle::modules {

using namespace physics;

namespace {

// Distance from a wall, negative behind it, and its gradient.
struct WallDistance {
    double distance;
    Vec3 normal;
};

WallDistance distance_to(const FlowWall& wall, Vec3 p) {
    const Vec3 from = p - wall.point;
    if (wall.radius > 0) {
        const double r = length(from);
        const double side = wall.inside ? -1 : 1;
        return {(r - wall.radius) * side, normalized(from) * side};
    }
    const Vec3 normal = normalized(wall.normal);
    return {dot(normal, from), normal};
}

// The ramp of Bridson et al.: odd, smooth to the second derivative, 1 from x = 1 on.
struct Ramp {
    double value, slope;

    explicit Ramp(double x) : value(1), slope(0) {
        if (x >= 1) return;
        if (x < 0) {
            value = 0;
            return;
        }
        const double x2 = x * x;
        value = x * (15 - x2 * (10 - 3 * x2)) * 0.125;
        slope = 15 * (1 - x2) * (1 - x2) * 0.125;
    }
};

// The product of the ramps of all walls, and its gradient.
struct RampProduct {
    double value = 1;
    Vec3 gradient = {};
};

RampProduct ramps_at(const ParticleFlow& flow, Vec3 p) {
    RampProduct all;
    for (const FlowWall& wall : flow.walls) {
        const WallDistance at = distance_to(wall, p);
        const Ramp ramp(at.distance / flow.ramp);
        all.gradient = all.gradient * ramp.value + at.normal * (all.value * ramp.slope / flow.ramp);
        all.value *= ramp.value;
    }
    return all;
}

}  // namespace

Vec3 flow_at(const ParticleFlow& flow, Vec3 p, double time, bool planar) {
    if (flow.speed == 0) return flow.wind;
    const CurlNoise noise{.seed = flow.seed, .octaves = flow.octaves};
    const Vec3 at = p * (1 / flow.scale);
    // Numbers that a particle can reach before it is removed; beyond, cells have no number.
    const Vec3 size = abs(at);
    if (!(maximum(size.x, maximum(size.y, size.z)) <= 1e15 && absolute(time * flow.rate) <= 1e15))
        return flow.wind;
    if (flow.walls.empty())
        return flow.wind + (planar ? planar_curl_noise(noise, at, time * flow.rate).flow
                                   : curl_noise(noise, at, time * flow.rate)) *
                               flow.speed;
    const RampProduct ramp = ramps_at(flow, p);
    if (ramp.value == 0 && ramp.gradient == Vec3{}) return flow.wind;
    const CurlNoiseSample sample = planar ? planar_curl_noise(noise, at, time * flow.rate)
                                          : curl_noise_sample(noise, at, time * flow.rate);
    // The potential of a flow of `scale` times the size is larger by that factor.
    const Vec3 eddies =
        sample.flow * ramp.value + cross(ramp.gradient, sample.potential * flow.scale);
    return flow.wind + eddies * flow.speed;
}

}  // namespace jostle::modules
