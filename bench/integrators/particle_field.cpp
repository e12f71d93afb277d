// SPDX-License-Identifier: MIT
#include "bench/integrators/particle_field.h"

#include <cmath>
#include <vector>

#include "jostle/physics/scalar.h"

namespace jostle::bench::integrators {
namespace {

using physics::pi;

// x'' = -w^2 x, released at 1 m: x = cos(w t).
ParticleField oscillator() {
    constexpr double w = 2 * pi;
    return {.name = "oscillator",
            .about = "a spring to the origin, 1 Hz, released at 1 m",
            .seconds = 2,
            .start = {{1, 0, 0}, {}},
            .acceleration = [](Vec3 x, Vec3, double) { return x * (-w * w); },
            .truth =
                [](double t) {
                    return Vec3{std::cos(w * t), 0, 0};
                },
            .energy =
                [](const ParticleState& s) {
                    return 0.5 * (length_squared(s.velocity) + w * w * length_squared(s.position));
                }};
}

// r'' = -4 pi^2 r / |r|^3, axis 1 m, eccentricity 0.5: period 1 s. Kepler's equation
// E - e sin(E) = 2 pi t by Newton's method; then r = (cos(E) - e, sqrt(1 - e^2) sin(E)).
ParticleField kepler() {
    constexpr double pull = 4 * pi * pi, e = 0.5;
    const double narrow = std::sqrt(1 - e * e);
    return {.name = "kepler",
            .about = "an ellipse of eccentricity 0.5 about the origin, period 1 s",
            .seconds = 2,
            .start = {{1 - e, 0, 0}, {0, 2 * pi * std::sqrt((1 + e) / (1 - e)), 0}},
            .acceleration =
                [](Vec3 x, Vec3, double) {
                    const double r = length(x);
                    return x * (-pull / (r * r * r));
                },
            .truth =
                [narrow](double t) {
                    const double mean = 2 * pi * t;
                    double anomaly = mean + e * std::sin(mean);
                    for (int k = 0; k < 20; k++)
                        anomaly -=
                            (anomaly - e * std::sin(anomaly) - mean) / (1 - e * std::cos(anomaly));
                    return Vec3{std::cos(anomaly) - e, narrow * std::sin(anomaly), 0};
                },
            .energy =
                [](const ParticleState& s) {
                    return 0.5 * length_squared(s.velocity) - pull / length(s.position);
                }};
}

// x'' = g - c x': v = g / c + (v0 - g / c) exp(-c t).
ParticleField drag() {
    constexpr double c = 2;
    static constexpr Vec3 g{0, 0, -9.81}, v0{3, 4, 5}, last{0, 0, -9.81 / c};
    return {.name = "drag",
            .about = "a throw in a uniform field with linear drag of 2/s",
            .seconds = 2,
            .start = {{}, v0},
            .acceleration = [](Vec3, Vec3 v, double) { return g - v * c; },
            .truth = [](double t) { return last * t + (v0 - last) * ((1 - std::exp(-c * t)) / c); },
            .energy = {}};
}

// x'' = -w^2 (x - b sin(u t)) along x, from rest at x0:
// x = b w^2 / (w^2 - u^2) (sin(u t) - u / w sin(w t)) + x0 cos(w t).
ParticleField moving_centre() {
    constexpr double w = 2 * pi, u = 3, b = 0.5, wide = b * w * w / (w * w - u * u), x0 = 0.3;
    return {.name = "moving",
            .about = "a spring of 1 Hz to a centre that oscillates by 0.5 m at 3 rad/s",
            .seconds = 2,
            .start = {{x0, 0, 0}, {}},
            .acceleration =
                [](Vec3 x, Vec3, double t) {
                    return (x - Vec3{b * std::sin(u * t), 0, 0}) * (-w * w);
                },
            .truth =
                [](double t) {
                    const double forced = std::sin(u * t) - u / w * std::sin(w * t);
                    return Vec3{wide * forced + x0 * std::cos(w * t), 0, 0};
                },
            .energy = {}};
}

}  // namespace

std::span<const ParticleField> all_fields() {
    static const std::vector<ParticleField> all = {oscillator(), kepler(), drag(), moving_centre()};
    return all;
}

const ParticleField* find_field(std::string_view name) {
    for (const ParticleField& field : all_fields())
        if (field.name == name) return &field;
    return nullptr;
}

}  // namespace jostle::bench::integrators
