// SPDX-License-Identifier: MIT
//
// Definitions of the objects of a world, with usable defaults. Units are SI: metres, kilograms,
// seconds, radians. A definition is a constant description: the world copies what it needs and does
// not keep a reference. A value out of range is rejected with an Error that names it.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/joint_solver.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

/// How a body moves.
enum class BodyType {
    static_body,  ///< never moves: floors, walls
    kinematic,    ///< moves with its set velocity and is not affected by contacts: platforms
    dynamic,      ///< moves by forces, impulses and contacts
};

/// Rule that combines the coefficients of two shapes. If two materials use different rules, the
/// rule that is later in this list applies.
enum class Combine : std::uint8_t {
    average,         ///< (a + b) / 2
    geometric_mean,  ///< sqrt(a b)
    minimum,         ///< min(a, b)
    multiply,        ///< a b
    maximum,         ///< max(a, b)
};

/// Combines two coefficients by the rule that applies to the pair.
inline double combine(double a, Combine rule_a, double b, Combine rule_b) {
    switch (rule_a < rule_b ? rule_b : rule_a) {
        case Combine::average:
            return 0.5 * (a + b);
        case Combine::geometric_mean:
            return square_root(a * b);
        case Combine::minimum:
            return minimum(a, b);
        case Combine::multiply:
            return a * b;
        case Combine::maximum:
            break;
    }
    return maximum(a, b);
}

/// Surface properties of a shape.
struct Material {
    double friction = 0.5;  ///< Coulomb coefficient, 0 to 100
    /// Coefficient of restitution, 0 to 1. Impacts slower than 0.3 m/s do not bounce.
    double restitution = 0.0;
    /// Rolling and torsional resistance: the torque that a normal force of 1 N resists, in N m / N
    /// = m, 0 to 100. A pair uses the larger value. Spheres and capsules always resist torsion with
    /// at least friction * radius / 25, because elastic bodies touch in a small disc (Hertz).
    double rolling_friction = 0;
    double torsional_friction = 0;
    /// Velocity of the surface relative to the body, in the body's local frame, as for a conveyor
    /// belt. m/s, each component within 1e4. Touching bodies are driven along the tangent plane of
    /// the contact.
    Vec3 surface_velocity = {};
    Combine friction_rule = Combine::geometric_mean;  ///< how friction is combined
    Combine restitution_rule = Combine::maximum;      ///< how restitution is combined

    bool operator==(const Material&) const = default;
};

/// Collision filter. Two shapes with the same non-zero group always collide if the group is
/// positive and never if it is negative. All other pairs collide if the category of each shape has
/// a bit in the mask of the other shape.
struct Filter {
    std::uint32_t category = 1;       ///< bits of the categories that this shape belongs to
    std::uint32_t mask = 0xffffffff;  ///< bits of the categories that this shape collides with
    std::int32_t group = 0;           ///< 0: no group

    bool operator==(const Filter&) const = default;
};

/// Returns true if the filters of two shapes allow them to collide.
inline bool may_collide(const Filter& a, const Filter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

/// Description of a shape for World::create_shape() and related calls.
struct ShapeDef {
    Geometry geometry = Box{};  ///< see geometry.h for the kinds that each body type supports
    Transform pose = {};        ///< in the body's local frame
    Material material = {};     ///< surface properties
    /// Density in kg/m^3, 1e-6 to 1e6. It determines mass, centre of mass and inertia. 0 is allowed
    /// if the density is not used: for a shape with an explicit mass, a trigger, and a shape of a
    /// body that is not dynamic.
    double density = 1000;
    double mass = 0;     ///< explicit mass in kg, 1e-9 to 1e15, which replaces the density; 0: none
    Filter filter = {};  ///< which shapes it collides with
    /// If true, the shape is a trigger: it does not collide, adds no mass, and reports the shapes
    /// inside it (Events::triggers_entered). Meshes and height fields cannot be triggers because
    /// they have no inside.
    bool trigger = false;
    /// If true, Events::contacts lists the touching contacts of this shape with their impulses
    /// after each step in which one of the two bodies is awake.
    bool report_stays = false;
    std::uint64_t user_data = 0;  ///< stored, saved and returned, not interpreted
};

/// Degrees of freedom that a dynamic body does not have, as bits: translation along and rotation
/// about the world axes.
using AxisLocks = std::uint8_t;
/// Translation along the world axes.
inline constexpr AxisLocks lock_x = 1, lock_y = 2, lock_z = 4;
/// Rotation about the world axes.
inline constexpr AxisLocks lock_rotation_x = 8, lock_rotation_y = 16, lock_rotation_z = 32;

/// Description of a body for World::create_body().
struct BodyDef {
    BodyType type = BodyType::dynamic;  ///< how the body moves
    Transform pose = {};                ///< of the body's origin, world; coordinates within 1e7 m
    Vec3 linear_velocity = {};          ///< m/s, of the centre of mass, each component within 1e4
    Vec3 angular_velocity = {};         ///< rad/s, world axes, each component within 1e4
    double linear_damping = 0;          ///< 1/s, 0 to 1e4: dv/dt = -damping v
    double angular_damping = 0;         ///< 1/s, 0 to 1e4
    double gravity_scale = 1;           ///< -1e3 to 1e3; 0: no gravity, -1: inverted
    bool sleep_allowed = true;          ///< whether the body may fall asleep
    AxisLocks locks = 0;                ///< locked degrees of freedom; used by dynamic bodies only
    /// Continuous collision detection. If true, the body is swept in every step in which one of its
    /// points moves farther than half the radius of the ball that fits into its thinnest shape, so
    /// that it does not tunnel.
    bool continuous = true;
    /// Total mass in kg, 1e-9 to 1e15. Mass and inertia of the shapes are scaled to it. 0 uses the
    /// mass of the shapes.
    double mass = 0;
    std::uint64_t user_data = 0;  ///< stored, saved and returned, not interpreted
};

/// A body with its shapes, for World::create_bodies().
struct BodyAndShapes {
    BodyDef body = {};                  ///< the body
    std::vector<ShapeDef> shapes = {};  ///< its shapes, in order of creation
};

/// Algorithm of the broad phase. All produce the same results at different cost
/// (docs/records/performance.md).
enum class BroadPhase : std::uint8_t {
    dynamic_tree,    ///< a bounding volume hierarchy that is updated incrementally
    sort_and_sweep,  ///< sorting along one axis
    uniform_grid,    ///< a uniform grid of cells
};

/// The highest value of World::overload_level().
inline constexpr int max_overload_level = 3;

/// Description of a world for World::create().
struct WorldDef {
    Vec3 gravity{0, -9.81, 0};  ///< m/s^2, each component within 1e4
    /// Sub-steps per step, 1 to 64. More sub-steps make contacts and joints stiffer and more
    /// accurate. The number is scaled per island: flat and slow islands take 1/2, resting piles 3/2
    /// (if bodies may sleep), islands of more than 40 layers on a small base 2, and islands with a
    /// mass ratio of 100 or more on top 4 times as many.
    int substeps = 8;
    /// Target error in m, 1e-9 to 1e3; 0 disables error control. With a tolerance, each island
    /// takes as many sub-steps as are needed for its bodies to be within this distance of the
    /// converged solution after one simulated second: 2, 6, 16 or 48, and three to eight times as
    /// many for slender and heavily loaded islands, at most 64. `substeps` is then ignored. The
    /// error does not include the effect of the step length on the motion.
    ///
    /// To measure the error, every eighth step of an island is computed twice, first with half the
    /// sub-steps. It is not measured while a listener receives sub-steps. World::island_substeps()
    /// reports the results.
    double tolerance = 0;
    /// Budget for error control: sub-steps per step, summed over the bodies with contacts or
    /// joints. 0 to 4294967295; 0: unlimited. If the budget is insufficient, islands take fewer
    /// sub-steps where this increases the error least. Every island takes the minimum number of
    /// sub-steps regardless of the budget.
    std::int64_t substep_budget = 0;
    /// Budget for the work of a step (StepProfile::work, units of about 0.1 us), 0 to 4294967295;
    /// 0: unlimited. Each step that exceeds the budget raises the overload level
    /// (World::overload_level()) by one for the next step. The level falls by one after 30
    /// consecutive steps below 60 % of the budget. Cannot be combined with a tolerance. Work is
    /// counted, not timed, so results are the same on every machine.
    ///
    /// Each level includes the previous ones:
    /// - Level 1: manifolds are reused over more motion, 16 mm instead of 4 mm, at any speed.
    /// - Level 2: impacts between moving bodies are left to the contact solver, so small and fast
    ///   bodies may pass through moving ones. No body passes through static and kinematic bodies.
    /// - Level 3: islands take half of their sub-steps, except slender, tall and heavily loaded
    ///   islands.
    std::int64_t step_budget = 0;
    /// Limits the tracked pairs of shapes (StepProfile::pairs, without the additional manifolds) to
    /// 4096 plus this number for each shape. 0 to 1000000; 0: unlimited. Bounds the memory and the
    /// time of a step if many bodies overlap; 16 is far above what bodies that only touch need. New
    /// pairs beyond the limit are skipped (StepProfile::pairs_skipped): these bodies pass through
    /// each other until one of them leaves its fat box. Pairs with static or kinematic bodies have
    /// priority.
    int max_pairs_per_shape = 0;
    /// Threads per step, 1 to 64. Results are bit-identical for any number. A step after one with
    /// little work (StepProfile::work) uses one thread (profile.h: share_short_steps()).
    int threads = 1;
    bool sleeping = true;    ///< whether resting bodies fall asleep and leave the step
    bool continuous = true;  ///< whether fast bodies are swept (BodyDef::continuous)
    /// If true, the world is two-dimensional: bodies move along x and y and rotate about z. Shapes
    /// are their outlines along z, 1 m deep; only spheres (discs), capsules, boxes, hulls and
    /// planes are supported. Poses, velocities and gravity out of the plane are rejected.
    bool planar = false;
    BroadPhase broad_phase = BroadPhase::dynamic_tree;  ///< algorithm of the broad phase
    /// Contacts that begin at this speed or faster are listed in Events::hits. m/s, 0 to 1e6.
    double hit_speed = 1;
    /// Solver of the joints whose JointDef::solver is empty (joint_solver.h).
    JointSolver joint_solver = JointSolver::automatic;
};

}  // namespace jostle::physics
