// SPDX-License-Identifier: MIT
//
// A grab of a point of a deformable object: a mass point that moves with it, and that a spring
// pulls to a target. The spring is the one with which players drag bodies: 5 Hz, critically damped,
// and it accelerates the mass by at most 200 m/s^2. A mass point as heavy as the object therefore
// lifts it, but cannot tear anything out of the world.
#pragma once

#include <cstdint>

#include "jostle/physics/state_visitor.h"
#include "jostle/physics/vec3.h"

namespace jostle::modules {

struct PointGrab {
    static constexpr double mass_min = 0.05, mass_max = 100;  ///< kg

    std::uint32_t holder = 0;     ///< number of the holder, from 1
    double mass = 1;              ///< kg
    physics::Vec3 target = {};    ///< m, world
    physics::Vec3 position = {};  ///< m, world
    physics::Vec3 velocity = {};  ///< m/s

    /// Sets the target. Returns false, without effect, if a component is not within 1e6 m.
    bool aim_at(physics::Vec3 point);
    /// Mean acceleration by the spring in the next h seconds, m/s^2, from an implicit step.
    physics::Vec3 pull(double h) const;
    void visit(physics::StateVisitor& v);
};

/// A grab of a point (m) of an object of a mass in kg.
PointGrab make_point_grab(std::uint32_t holder, physics::Vec3 point, double object_mass);

}  // namespace jostle::modules
