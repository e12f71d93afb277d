// SPDX-License-Identifier: MIT
//
// Force fields F(p, v, t) on one particle of 1 kg, each with its motion in closed form.
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
    double seconds = 1;  // of a run
    ParticleState start;
    // m/s^2 at a place, with a velocity, at a time.
    std::function<Vec3(Vec3 position, Vec3 velocity, double t)> acceleration;
    std::function<Vec3(double t)> truth;  // m
    // J/kg, of fields that keep it; else null.
    std::function<double(const ParticleState&)> energy;
};

// Oscillator, Kepler's ellipse, fall with drag, a spring to a centre that moves.
std::span<const ParticleField> all_fields();
const ParticleField* find_field(std::string_view name);  // null: none

}  // namespace jostle::bench::integrators
