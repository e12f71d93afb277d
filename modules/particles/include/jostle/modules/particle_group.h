// SPDX-License-Identifier: MIT
//
// A group of particles with common properties, and its simulation. A group needs no world: the
// module Particles advances the groups of a world and lets them collide with its bodies; clients
// advance cosmetic groups with the same code (cosmetic_particles.h).
//
//     ParticleGroupDef smoke{.emitter = {.rate = 100, .lifetime = 3}, .flow = {.speed = 0.5}};
//     ParticleGroup group = ParticleGroup::create(smoke).value();
//     group.advance({.gravity = {0, 0.2, 0}}, 0, 1.0 / 60);  // the first step
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/modules/deformables.h"
#include "jostle/modules/emitter.h"
#include "jostle/modules/particle_flow.h"
#include "jostle/physics/force_fields.h"
#include "jostle/physics/result.h"
#include "jostle/physics/state_visitor.h"

namespace jostle::physics {
class World;
}

namespace jostle::modules {

namespace particles_detail {
class BodyImpacts;
struct ParticleScratch;
}  // namespace particles_detail

/// Integration method of a group. With the time step h, the error after a fixed time is
/// proportional to h, h, h, h^2 and h^4.
enum class ParticleIntegrator : std::uint8_t {
    explicit_euler,       ///< gains energy
    semi_implicit_euler,  ///< symplectic: the energy of an oscillation stays bounded
    /// Newton's method; stable for any stiffness of springs, attractors and drag; loses energy.
    implicit_euler,
    verlet,         ///< position Verlet: symplectic, exact in uniform gravity
    runge_kutta_4,  ///< classical Runge-Kutta method, four evaluations per step
};

/// An acceleration towards a point: strength / max(r, min_distance)^falloff.
struct ParticleAttractor {
    physics::Vec3 point = {};   ///< m, each component within 1e7
    double strength = 1;        ///< m/s^2 at r = 1 m, within 1e9; negative repels
    std::int32_t falloff = 2;   ///< -1 to 4; -1 is a linear spring of strength 1/s^2
    double min_distance = 0.1;  ///< m, 1e-6 to 1e6: constant within it (falloff > 0)

    bool operator==(const ParticleAttractor&) const = default;
};

/// A plane that particles hit: they stay where dot(normal, p) > offset.
struct ParticlePlane {
    physics::Vec3 normal = {0, 1, 0};  ///< any length but 0
    double offset = 0;                 ///< m along the unit normal, within 1e7

    bool operator==(const ParticlePlane&) const = default;
};

/// Second particle of a spring that is attached to a fixed point.
inline constexpr std::uint32_t spring_anchor = 0xffffffff;

/// A damped spring between two particles of a group, or between a particle and a fixed point. It
/// ends when one of its particles does.
struct ParticleSpring {
    std::uint32_t a = 0, b = spring_anchor;  ///< indices in the group
    physics::Vec3 anchor = {};               ///< m, if b is spring_anchor
    double rest_length = 0;                  ///< m, 0 to 1e4
    double stiffness = 100;                  ///< N/m, 0 to 1e9
    double damping = 0;                      ///< N s/m along the spring, 0 to 1e6

    bool operator==(const ParticleSpring&) const = default;
};

/// Properties of a group.
struct ParticleGroupDef {
    static constexpr std::size_t attractors_max = 8, planes_max = 8;
    static constexpr std::size_t particles_max = 100000;
    /// Maximum number of particles that attract each other: the cost is quadratic.
    static constexpr std::size_t attracting_max = 2048;
    /// Maximum number of springs of a group; with several substeps, of springs times substeps.
    static constexpr std::size_t springs_max = 20000;

    ParticleIntegrator integrator = ParticleIntegrator::verlet;
    std::uint32_t substeps = 1;      ///< per step, 1 to 64
    std::uint32_t count_max = 1000;  ///< 1 to particles_max; further ones are not emitted
    double mass = 1e-3;              ///< kg, of a particle, 1e-9 to 1e6
    double radius = 0;               ///< m, 0 to 100
    double gravity_scale = 1;        ///< factor on the gravity of the world, within 1e3
    /// Drag against the medium, of velocity u relative to it: -(linear_drag + quadratic_drag |u|)
    /// u.
    double linear_drag = 0;     ///< 1/s, 0 to 1e6
    double quadratic_drag = 0;  ///< 1/m, 0 to 1e6
    bool follow_flow = false;   ///< whether particles are tracers that move with the medium
    bool world_fields = false;  ///< whether wind, radial and vortex fields of the world act
    std::uint32_t category = 0xffffffff;  ///< bits, for FieldDef::mask
    /// Mutual attraction, within 1e12 m^3/(kg s^2): each particle at the distance r accelerates
    /// another by attraction * mass * r / (r^2 + softening^2)^(3/2). Needs count_max <=
    /// attracting_max.
    double attraction = 0;
    double softening = 0.1;                      ///< m, 1e-6 to 1e4
    bool collide_bodies = true;                  ///< whether particles hit the bodies of the world
    std::uint32_t body_categories = 0xffffffff;  ///< hits shapes with one of these categories
    bool collide_particles = false;              ///< whether particles of the group hit each other
    double restitution = 0.3;                    ///< 0 to 1, of all impacts
    double friction = 0.3;                       ///< 0 to 10, with bodies and planes
    bool planar = false;  ///< whether all motion is in the xy plane, as in planar worlds
    /// Whether clients simulate the group instead of the world. Such particles hit only `planes`.
    bool cosmetic = false;
    std::uint32_t color = 0xffffff;  ///< 0xRRGGBB, for clients
    Emitter emitter = {};
    ParticleFlow flow = {};
    std::vector<ParticleAttractor> attractors = {};  ///< at most attractors_max
    std::vector<ParticlePlane> planes = {};          ///< at most planes_max

    bool operator==(const ParticleGroupDef&) const = default;
};

/// Initial state of a particle that is added by a caller.
struct ParticleStart {
    physics::Vec3 position = {}, velocity = {};  ///< m, within 1e7; m/s, within 1e4
    double lifetime = 0;                         ///< s, 0 to 1e6; 0: unlimited
};

/// Everything outside a group that acts on it.
struct ParticleEnvironment {
    physics::Vec3 gravity = {};                       ///< m/s^2
    std::span<const physics::FieldDef> fields = {};   ///< of the world
    const physics::World* world = nullptr;            ///< if not null, its threads are used
    particles_detail::BodyImpacts* bodies = nullptr;  ///< used by Particles
};

/// Returns an error that names the first invalid field of a definition.
physics::Status check(const ParticleGroupDef& def);

/// Returns an upper bound of the work of a step with count_max particles, in units of about 0.2 us.
double work_of(const ParticleGroupDef& def);

/// Particles of one definition. Not thread-safe.
class ParticleGroup {
public:
    /// Returns invalid_argument, naming the field, for a definition out of range.
    static physics::Result<ParticleGroup> create(const ParticleGroupDef& def);
    ParticleGroup();
    ParticleGroup(ParticleGroup&&) noexcept;
    ParticleGroup& operator=(ParticleGroup&&) noexcept;
    ~ParticleGroup();

    const ParticleGroupDef& def() const { return def_; }
    /// Replaces the definition. Particles keep their state; those above count_max stay until they
    /// expire. Errors as create().
    physics::Status set_def(const ParticleGroupDef& def);

    std::size_t size() const { return positions_.size(); }
    /// Positions in m, velocities in m/s, and ages in s, by index. The order is that of creation.
    /// Valid until the group changes.
    std::span<const physics::Vec3> positions() const { return positions_; }
    std::span<const physics::Vec3> velocities() const { return velocities_; }
    std::span<const double> ages() const { return ages_; }
    /// Numbers that identify the particles while they exist.
    std::span<const std::uint32_t> ids() const { return ids_; }
    std::span<const ParticleSpring> springs() const { return springs_; }

    /// Adds particles. Returns invalid_argument, naming the index, or resource_exhausted above
    /// count_max; nothing is added then.
    physics::Status add(std::span<const ParticleStart> particles);
    /// Adds springs. Errors: as add(); resource_exhausted above springs_max.
    physics::Status add_springs(std::span<const ParticleSpring> springs);
    /// Removes all particles and springs.
    void clear();

    /// Advances the group from one time to another, s. Emits the particles of that interval, which
    /// excludes its end; removes those whose lifetime ended and those that left the range of
    /// coordinates (1e7 m) or speeds (1e6 m/s). Does not allocate memory once the group has reached
    /// its largest size. Precondition: from < to.
    void advance(const ParticleEnvironment& environment, double from, double to);

    /// Applies a pulse of pressure to the cross-section of each particle. Particles without a
    /// radius have none. No effect on cosmetic groups, which clients simulate.
    void apply_pulse(const PressurePulse& pulse);

    /// Kinetic energy in J and momentum in kg m/s.
    double kinetic_energy() const;
    physics::Vec3 momentum() const;

    /// Visits the state. Loaded values are checked.
    void visit(physics::StateVisitor& v);

private:
    friend class particles_detail::BodyImpacts;

    void emit(physics::Vec3 gravity, double from, double to);
    void substep(const ParticleEnvironment& environment, double time, double h);
    void check_loaded(physics::StateVisitor& v) const;
    void remove_expired();

    ParticleGroupDef def_;
    std::vector<physics::Vec3> positions_, velocities_;
    std::vector<double> ages_, lifetimes_;  // a lifetime of 0 is unlimited
    std::vector<std::uint32_t> ids_;
    std::vector<ParticleSpring> springs_;
    std::uint32_t next_id_ = 0;  // of particles that are added by a caller

    std::unique_ptr<particles_detail::ParticleScratch> scratch_;  // not state
};

}  // namespace jostle::modules
