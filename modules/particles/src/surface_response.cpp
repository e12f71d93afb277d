// SPDX-License-Identifier: MIT
#include "modules/particles/src/surface_response.h"

namespace jostle::modules::particles_detail {

using namespace physics;

namespace {

// Friction against the tangential velocity u: the impulse that stops it, at most `most` N s.
Vec3 friction_impulse(const SurfaceAtImpact& surface, Vec3 u, double mass, double most) {
    const double speed = length(u);
    if (speed == 0 || most == 0) return {};
    const Vec3 along = u * (1 / speed);
    const double stop = speed / (1 / mass + surface.response(along));
    return along * -minimum(stop, most);
}

}  // namespace

ParticleBounce bounce_particle(const ArrivingParticle& particle, const SurfaceAtImpact& surface,
                               const ImpactMaterial& material, double rest_speed) {
    const Vec3 n = surface.normal, a = particle.acceleration;
    const double left = particle.left, mass = material.mass;
    Vec3 velocity = particle.velocity - a * left;  // at the impact
    const Vec3 relative = velocity - surface.velocity;
    const double approach = -dot(relative, n), later = -dot(a, n) * left;
    if (!(approach > 0 || approach + later > 0))
        return {particle.velocity, velocity * left + a * (0.5 * left * left), {}};

    // The surface is where it will be at the end already, so the motion along its normal counts
    // relative to it.
    const Vec3 carried_along = n * (dot(surface.velocity, n) * left);
    const Vec3 across = relative + n * approach;
    if (approach > rest_speed) {
        const double change = (1 + material.restitution) * approach;
        Vec3 impulse = n * (change / (1 / mass + surface.response(n)));
        impulse += friction_impulse(surface, across, mass, material.friction * dot(impulse, n));
        velocity += impulse * (1 / mass);
        return {velocity + a * left,
                velocity * left + a * (0.5 * left * left) - carried_along,
                {-impulse}};
    }
    // At rest on the surface, which also takes the force of the remaining time; friction acts on
    // the velocity at its end.
    const double stopped = maximum(approach, 0);
    const double carried = maximum(approach + later - stopped, 0);
    Vec3 impulse = n * (stopped / (1 / mass + surface.response(n)) + carried * mass);
    impulse += friction_impulse(surface, across + a * left + n * later, mass,
                                material.friction * dot(impulse, n));
    const Vec3 end = velocity + impulse * (1 / mass) + a * left;
    return {end, end * left - carried_along, {-impulse}};
}

}  // namespace jostle::modules::particles_detail
