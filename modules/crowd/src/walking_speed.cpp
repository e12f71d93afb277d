// SPDX-License-Identifier: MIT
#include "modules/crowd/src/walking_speed.h"

#include "jostle/modules/exponential.h"

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr double steepness = 1.913;  // 1/m^2
constexpr double jam_density = 5.4;  // 1/m^2
constexpr double slowest = 0.02;     // relative: people shuffle even in a jam
constexpr double same_side_cosine = 0.6;

// Part of a disc of radius 1 that a line at distance t from its centre cuts off.
double segment_of_disc(double t) {
    if (t >= 1) return 0;
    const double half_chord = square_root(1 - t * t);
    return (arc_tangent(half_chord, t) - t * half_chord) / pi;
}

}  // namespace

double relative_walking_speed(double density) {
    const double room = 1 / maximum(density, 1e-6) - 1 / jam_density;  // m^2 per person
    return maximum(1 - exp_of_negative(-steepness * maximum(room, 0)), slowest);
}

double density_ahead(double radius, double ahead, std::span<const NearWall> walls) {
    double open = 1;
    for (std::size_t k = 0; k < walls.size() && walls[k].distance < radius; k++) {
        // The sides of a bent wall face the same way and count once. The end of a wall hides
        // little, unless it is a corner in front of the walker.
        bool counted = walls[k].is_end && k > 0;
        for (std::size_t j = 0; j < k && !counted; j++)
            counted = dot(walls[j].offset, walls[k].offset) >
                      same_side_cosine * walls[j].distance * walls[k].distance;
        if (!counted) open -= segment_of_disc(walls[k].distance / radius);
    }
    // The walker itself is in the middle of the straight side: half of it counts.
    return (ahead + 0.5) / (0.5 * pi * radius * radius * maximum(open, 0.1));
}

}  // namespace jostle::modules::crowd_detail
