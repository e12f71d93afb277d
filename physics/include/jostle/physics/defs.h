// SPDX-License-Identifier: MIT
//
// What to create, with defaults that work. SI units: metres, kilograms, seconds, radians. A Def is
// a constant description; the world copies what it needs and keeps no pointer to it.
#pragma once

#include <cstdint>

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

enum class BodyType {
    fixed,      // never moves: floors, walls
    kinematic,  // moves by its velocity alone and pushes others: platforms
    dynamic,    // moves by forces, impulses and contacts
};

struct Material {
    double friction = 0.5;     // Coulomb coefficient, >= 0; a pair uses sqrt(a b)
    double restitution = 0.0;  // 0 (no bounce) to 1 (keeps all speed); a pair uses the larger

    bool operator==(const Material&) const = default;
};

struct ShapeDef {
    Geometry geometry = Box{};
    Transform pose;  // of the shape in its body
    Material material;
    double density =
        1000;  // kg/m^3, > 0 on dynamic bodies: mass, centre of mass and inertia follow from it
};

struct BodyDef {
    BodyType type = BodyType::dynamic;
    Transform pose;
    Vec3 linear_velocity;        // m/s, of the centre of mass
    Vec3 angular_velocity;       // rad/s, world axes
    double linear_damping = 0;   // 1/s, >= 0: dv/dt = -damping v
    double angular_damping = 0;  // 1/s, >= 0
    double gravity_scale = 1;    // 0 floats, -1 rises
    bool may_sleep = true;
    std::uint64_t user_data = 0;  // kept, saved and returned, never read
};

struct WorldDef {
    Vec3 gravity{0, -9.81, 0};  // m/s^2
    int substeps = 8;           // 1 to 64 solver passes per step: more is stiffer and more exact
    int threads = 1;            // 1 to 64; the result has the same bits for every number
    bool sleeping = true;       // bodies at rest leave the step
};

}  // namespace jostle::physics
