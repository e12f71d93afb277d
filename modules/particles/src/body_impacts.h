// SPDX-License-Identifier: MIT
//
// Impacts of particles with the bodies of a world, and the impulses that the bodies receive.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "jostle/modules/particle_group.h"
#include "jostle/physics/world.h"

namespace jostle::modules::particles_detail {

// The first contact of a particle that moves from one point to another.
struct ShapeImpact {
    physics::BodyId body;
    physics::Vec3 center;  // of the particle when it touches the shape; outside of the shape
    physics::Vec3 normal;  // out of the shape
    double fraction;       // of the motion; 0 also if the particle was inside
};

// Returns the first impact with a shape; nullopt if there is none. The only function that queries
// the world for single particles: a batched query can replace it.
std::optional<ShapeImpact> find_impact(const physics::World& world, const physics::Queries& queries,
                                       physics::Vec3 from, physics::Vec3 to, double radius,
                                       const physics::QueryFilter& filter);

// Collects the impulses of a step and applies them at its end. Particles that hit only static and
// kinematic bodies are moved on all threads, the others one after the other in the order of their
// indices, so that each meets the velocity that the previous ones left.
class BodyImpacts {
public:
    // Starts a step of the module, after the step of the world.
    void begin(const physics::World& world);
    // Resolves the impacts of a substep of h seconds, in which each particle moved from `before` to
    // its position with a mean acceleration.
    void resolve(ParticleGroup& group, std::span<const physics::Vec3> before,
                 std::span<const physics::Vec3> acceleration, double h, double rest_speed);
    // Stops particles that impacts with each other would push from `before` into a body, after
    // resolve() of the same substep.
    void hold(ParticleGroup& group, std::span<const physics::Vec3> before);
    // Applies the impulses to the world.
    void apply(physics::World& world);

private:
    // A dynamic body that was hit, with its velocity after the impacts so far.
    struct PushedBody {
        physics::BodyState state;
        physics::Mat3 inverse_inertia;
        double inverse_mass = 0;
        physics::Vec3 impulse, angular_impulse;  // N s, N m s about the centre
    };
    struct NearPlane {
        physics::Vec3 normal;
        double offset;
    };
    struct Motion;  // of one particle until the end of the substep
    struct Task;

    PushedBody* find(const physics::BodyState& state);
    void collect_near_shapes(const ParticleGroup& group, std::span<const physics::Vec3> before);
    bool may_hit(physics::Vec3 from, physics::Vec3 to, double radius) const;
    bool move_along_fixed(const Task& task, std::size_t k) const;
    void move(const Task& task, std::size_t k);

    const physics::World* world_ = nullptr;
    std::vector<PushedBody> bodies_;     // sorted by id
    std::vector<physics::Aabb> bounds_;  // of shapes near the group
    std::vector<NearPlane> planes_;
    bool test_all_ = false;  // there are too many shapes to list them
    std::vector<std::uint8_t>
        pending_;  // per particle: moved in order, because it hits a dynamic body
};

}  // namespace jostle::modules::particles_detail
