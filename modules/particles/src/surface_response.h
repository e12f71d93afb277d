// SPDX-License-Identifier: MIT
//
// The impact of a particle on a surface: Newton's law of restitution along the normal and Coulomb
// friction across it, with the remaining motion until the end of the substep.
#pragma once

#include "jostle/physics/world.h"

namespace jostle::modules::particles_detail {

// The surface at the point of impact. The responses are changes of its velocity per impulse, 1/kg;
// 0 for a fixed surface.
struct SurfaceAtImpact {
    physics::Vec3 normal;    // out of the surface
    physics::Vec3 velocity;  // m/s
    // Of the body, for the response along any direction; null: fixed.
    const physics::Mat3* inverse_inertia = nullptr;
    double inverse_mass = 0;
    physics::Vec3 arm;  // from the centre of the body

    double response(physics::Vec3 along) const {
        if (inverse_inertia == nullptr) return 0;
        const physics::Vec3 turn = cross(arm, along);
        return inverse_mass + dot(*inverse_inertia * turn, turn);
    }
};

// The surface of a body at a point; inverse_mass 0: a fixed or kinematic body.
inline SurfaceAtImpact surface_of(const physics::BodyState& body,
                                  const physics::Mat3& inverse_inertia, double inverse_mass,
                                  physics::Vec3 point, physics::Vec3 normal) {
    const physics::Vec3 arm = point - body.center;
    return {.normal = normal,
            .velocity = body.linear_velocity + cross(body.angular_velocity, arm),
            .inverse_inertia = inverse_mass > 0 ? &inverse_inertia : nullptr,
            .inverse_mass = inverse_mass,
            .arm = arm};
}

// A particle at the moment of impact. `velocity` is what it would have at the end of the substep.
struct ArrivingParticle {
    physics::Vec3 velocity, acceleration;  // m/s, m/s^2
    double left;                           // s until the end of the substep
};

struct ImpactMaterial {
    double mass, restitution, friction;
};

struct SurfaceImpulse {
    physics::Vec3 on_surface;  // N s; the particle receives the opposite
};

struct ParticleBounce {
    physics::Vec3 velocity;  // m/s, at the end of the substep
    physics::Vec3 move;      // m, from the point of impact until then
    SurfaceImpulse impulse;
};

// Approach speeds up to `rest_speed` (m/s), which forces cause within one substep, do not rebound:
// the particle then stays on the surface, which carries its weight.
ParticleBounce bounce_particle(const ArrivingParticle& particle, const SurfaceAtImpact& surface,
                               const ImpactMaterial& material, double rest_speed);

}  // namespace jostle::modules::particles_detail
