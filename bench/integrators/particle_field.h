// SPDX-License-Identifier: MIT
//
// Force fields F(p, v, t) on one particle of 1 kg, each with its exact solution.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "jostle/physics/vec3.h"

namespace jostle::bench::integrators {

using physics::Vec3;

struct ParticleState {
    Vec3 position;  // m
    Vec3 velocity;  // m/s
};

struct ParticleField {
    std::string name;
    std::string about;
    double seconds = 1;  // duration of a run
    ParticleState start;
    // Acceleration in m/s^2 at a position, velocity and time.
    std::function<Vec3(Vec3 position, Vec3 velocity, double t)> acceleration;
    std::function<Vec3(double t)> truth;  // m
    // J/kg, for conservative fields; else null.
    std::function<double(const ParticleState&)> energy;
};

// Oscillator, Kepler ellipse, fall with drag, spring to a moving centre.
std::span<const ParticleField> all_fields();
const ParticleField* find_field(std::string_view name);  // null: there is none

}  // namespace jostle::bench::integrators
