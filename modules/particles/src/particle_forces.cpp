// SPDX-License-Identifier: MIT
#include "modules/particles/src/particle_forces.h"

#include "modules/particles/src/particle_scratch.h"

namespace jostle::modules::particles_detail {

using namespace physics;

namespace {

constexpr int force_grain = 128;      // particles per task
constexpr int attraction_grain = 16;  // likewise, with a loop over all others

double power(double x, int exponent) {
    double product = 1;
    for (int k = 0; k < exponent; k++) product *= x;
    return product;
}

Vec3 attraction_of(const ParticleAttractor& attractor, Vec3 position) {
    const Vec3 to = attractor.point - position;
    if (attractor.falloff < 0) return to * attractor.strength;
    const double r = length(to);
    if (r == 0) return {};
    return to * (attractor.strength /
                 (r * power(maximum(r, attractor.min_distance), attractor.falloff)));
}

Mat3 outer(Vec3 a, double s) {
    return {a * (a.x * s), a * (a.y * s), a * (a.z * s)};
}

Mat3 identity_times(double s) {
    return diagonal({s, s, s});
}

// Derivative of attraction_of() by the position: with d towards the point,
// d(s d r^-(k+1)) = -s r^-(k+1) (I - (k+1) d d^T / r^2).
Mat3 attraction_gradient(const ParticleAttractor& attractor, Vec3 position) {
    if (attractor.falloff < 0) return identity_times(-attractor.strength);
    const Vec3 to = attractor.point - position;
    const double r = length(to);
    if (r == 0) return identity_times(0);
    const double least = attractor.min_distance;
    const double scale = -attractor.strength / (r * power(maximum(r, least), attractor.falloff));
    const int exponent = r > least ? attractor.falloff + 1 : 1;
    return identity_times(scale) + outer(to, -scale * exponent / (r * r));
}

bool acts_on(const FieldDef& field, std::uint32_t category, Vec3 p) {
    if ((field.mask & category) == 0) return false;
    if (!field.region) return true;
    const Vec3 low = field.region->low, high = field.region->high;
    return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y &&
           p.z <= high.z;
}

// Force of a field on a particle in N, or acceleration; see per_mass_of().
Vec3 force_of(const RadialField& field, Vec3 p) {
    const Vec3 from = p - field.center;
    const double r = length(from);
    if (r == 0) return {};
    return from * (field.strength / (r * power(maximum(r, field.min_distance), field.falloff)));
}

Vec3 force_of(const VortexField& field, Vec3 p) {
    const Vec3 from = p - field.center;
    const Vec3 out = from - field.axis * dot(field.axis, from);
    const double r = length(out);
    const double decay = 1 / power(maximum(r, field.min_distance), field.falloff);
    const Vec3 lift = field.axis * (field.lift * decay);
    if (r == 0) return lift;
    const Vec3 radial = out * (1 / r);
    return lift + (cross(field.axis, radial) * field.strength - radial * field.pull) * decay;
}

}  // namespace

bool ParticleForces::has_medium() const {
    return def.follow_flow || def.linear_drag > 0 || def.quadratic_drag > 0;
}

Vec3 ParticleForces::medium(Vec3 position, double time) const {
    Vec3 velocity = flow_at(def.flow, position, time, def.planar);
    for (const FieldDef& field : environment.fields) {
        const auto* wind = std::get_if<UniformWind>(&field.force);
        if (wind == nullptr || !acts_on(field, def.category, position)) continue;
        velocity += wind->velocity + wind->gust * sin_cos(2 * pi * time / wind->gust_period).sin;
    }
    return velocity;
}

Vec3 ParticleForces::world_acceleration(Vec3 position) const {
    Vec3 sum;
    for (const FieldDef& field : environment.fields) {
        if (!acts_on(field, def.category, position)) continue;
        const auto add = [&](const auto& law) {
            sum += force_of(law, position) * (law.per_mass ? 1 : 1 / def.mass);
        };
        if (const auto* radial = std::get_if<RadialField>(&field.force)) add(*radial);
        if (const auto* vortex = std::get_if<VortexField>(&field.force)) add(*vortex);
    }
    return sum;
}

Vec3 ParticleForces::position_acceleration(std::span<const Vec3> positions, std::size_t k) const {
    Vec3 sum = environment.gravity * def.gravity_scale;
    for (const ParticleAttractor& attractor : def.attractors)
        sum += attraction_of(attractor, positions[k]);
    if (!environment.fields.empty()) sum += world_acceleration(positions[k]);
    if (def.attraction != 0) sum += attraction_on(positions, k);
    return sum;
}

// `u`: velocity relative to the medium.
Vec3 ParticleForces::drag_acceleration(Vec3 u) const {
    const double fast = def.quadratic_drag > 0 ? def.quadratic_drag * length(u) : 0;
    return u * -(def.linear_drag + fast);
}

Vec3 ParticleForces::attraction_on(std::span<const Vec3> positions, std::size_t k) const {
    const double softening = def.softening * def.softening;
    Vec3 sum;
    for (const Vec3& other : positions) {
        // The particle itself adds zero.
        const Vec3 to = other - positions[k];
        const double r2 = length_squared(to) + softening;
        sum += to * (1 / (r2 * square_root(r2)));
    }
    return sum * (def.attraction * def.mass);
}

SpringState::SpringState(const ParticleSpring& spring, std::span<const Vec3> positions,
                         std::span<const Vec3> velocities) {
    const bool fixed = spring.b == spring_anchor;
    const Vec3 d = (fixed ? spring.anchor : positions[spring.b]) - positions[spring.a];
    const Vec3 u = (fixed ? Vec3{} : velocities[spring.b]) - velocities[spring.a];
    length = physics::length(d);
    direction = length > 0 ? d * (1 / length) : Vec3{};
    rate = dot(u, direction);
}

Vec3 SpringState::force(const ParticleSpring& spring) const {
    return direction * (spring.stiffness * (length - spring.rest_length) + spring.damping * rate);
}

// Serial and in order, because springs share particles.
void ParticleForces::add_springs(std::span<const Vec3> positions, std::span<const Vec3> velocities,
                                 std::span<Vec3> accelerations) const {
    const double inverse_mass = 1 / def.mass;
    for (const ParticleSpring& spring : springs) {
        const Vec3 a = SpringState(spring, positions, velocities).force(spring) * inverse_mass;
        accelerations[spring.a] += a;
        if (spring.b != spring_anchor) accelerations[spring.b] -= a;
    }
}

void ParticleForces::accelerate(std::span<const Vec3> positions, std::span<const Vec3> velocities,
                                double time, std::span<Vec3> accelerations) const {
    accelerate_after(positions, velocities, time, 0, accelerations);
    if (!springs.empty()) add_springs(positions, velocities, accelerations);
}

void ParticleForces::accelerate_after(std::span<const Vec3> positions,
                                      std::span<const Vec3> velocities, double time, double lead,
                                      std::span<Vec3> accelerations) const {
    struct Task {
        const ParticleForces& forces;
        std::span<const Vec3> positions, velocities;
        double time, lead;
        std::span<Vec3> accelerations;

        Vec3 of(std::size_t k) const {
            Vec3 sum = forces.position_acceleration(positions, k);
            if (forces.def.linear_drag > 0 || forces.def.quadratic_drag > 0) {
                const Vec3 u = velocities[k] - forces.medium(positions[k], time);
                const Vec3 now = sum + forces.drag_acceleration(u);
                sum = lead == 0 ? now : sum + forces.drag_acceleration(u + now * lead);
            }
            if (forces.def.planar) sum.z = 0;
            return sum;
        }
    } task{*this, positions, velocities, time, lead, accelerations};
    // The lambda captures one reference, so std::function allocates nothing.
    for_ranges(environment.world, positions.size(),
               def.attraction != 0 ? attraction_grain : force_grain, [&task](int first, int last) {
                   for (auto k = static_cast<std::size_t>(first);
                        k < static_cast<std::size_t>(last); k++)
                       task.accelerations[k] = task.of(k);
               });
}

Mat3 ParticleForces::stiffness(Vec3 position, Vec3 velocity, double time, double h) const {
    Mat3 sum = identity_times(0);
    for (const ParticleAttractor& attractor : def.attractors)
        sum = sum + attraction_gradient(attractor, position) * (h * h);
    if (has_medium()) {
        // d((c1 + c2 |u|) u) = (c1 + c2 |u|) I + c2 u u^T / |u|
        const Vec3 u = velocity - medium(position, time);
        const double speed = length(u);
        sum = sum - identity_times(h * (def.linear_drag + def.quadratic_drag * speed));
        if (speed > 0) sum = sum - outer(u, h * def.quadratic_drag / speed);
    }
    return sum;
}

}  // namespace jostle::modules::particles_detail
