// SPDX-License-Identifier: MIT
//
// What to create, with defaults that work. Units are SI: metres, kilograms, seconds, radians. A Def
// is a constant description: the world copies what it needs and keeps no pointer to it. A value out
// of its range is refused with an Error that names it.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/joint_solver.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

enum class BodyType {
    static_body,  // never moves: floors, walls
    kinematic,    // moves by its velocity alone and pushes others: platforms
    dynamic,      // moves by forces, impulses and contacts
};

// How a pair of shapes makes one coefficient of its two. When their materials ask for different
// rules the one further down this list wins.
enum class Combine : std::uint8_t {
    average,
    geometric_mean,
    minimum,
    multiply,
    maximum,
};

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

struct Material {
    double friction = 0.5;  // Coulomb coefficient, 0 to 100
    // Share of the approach speed that comes back, 0 to 1. What meets at less than 0.3 m/s does not
    // bounce.
    double restitution = 0.0;
    // Resistance against rolling, and against turning on the spot: the torque that a normal force
    // of 1 N holds, N m / N = m, 0 to 100. A pair uses the larger. Balls and capsules always hold
    // friction * radius / 25 against turning: elastic bodies touch in a small disc (Hertz).
    double rolling_friction = 0;
    double torsional_friction = 0;
    // Of the surface against its body, in the body's axes: a conveyor belt. m/s, each component
    // within 1e4. What touches is driven along the tangent plane of the contact.
    Vec3 surface_velocity = {};
    Combine friction_rule = Combine::geometric_mean;
    Combine restitution_rule = Combine::maximum;

    bool operator==(const Material&) const = default;
};

// Which shapes meet. Two shapes of one group, other than 0, always meet when it is positive and
// never when it is negative. All others meet when each one's category has a bit in the other's
// mask.
struct Filter {
    std::uint32_t category = 1;
    std::uint32_t mask = 0xffffffff;
    std::int32_t group = 0;

    bool operator==(const Filter&) const = default;
};

inline bool may_collide(const Filter& a, const Filter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

struct ShapeDef {
    Geometry geometry = Box{};
    Transform pose = {};  // of the shape in its body
    Material material = {};
    // kg/m^3, 1e-6 to 1e6: mass, centre of mass and inertia follow from it. May be 0 for what needs
    // no density: a shape with a mass of its own, a trigger, a shape of a body that is not dynamic.
    double density = 1000;
    double mass = 0;  // kg, 0 or 1e-9 to 1e15; above 0 it replaces the density
    Filter filter = {};
    // Touches nothing, adds no mass, and reports what is inside it (Events::triggers_entered). Not
    // for meshes and height fields, which have no inside.
    bool trigger = false;
    // Its touching contacts are listed in Events::contacts after each step, with their impulses,
    // while one of the two bodies is awake.
    bool report_stays = false;
    std::uint64_t user_data = 0;  // kept, saved and returned, never read
};

// Directions in which a dynamic body cannot move, as bits: along the world's axes, and about them.
using AxisLocks = std::uint8_t;
inline constexpr AxisLocks lock_x = 1, lock_y = 2, lock_z = 4;  // motion along
inline constexpr AxisLocks lock_rotation_x = 8, lock_rotation_y = 16,
                           lock_rotation_z = 32;  // turns about

struct BodyDef {
    BodyType type = BodyType::dynamic;
    Transform pose = {};         // of the body's origin; coordinates within 1e7 m
    Vec3 linear_velocity = {};   // m/s, of the centre of mass, each component within 1e4
    Vec3 angular_velocity = {};  // rad/s, world axes, each component within 1e4
    double linear_damping = 0;   // 1/s, 0 to 1e4: dv/dt = -damping v
    double angular_damping = 0;  // 1/s, 0 to 1e4
    double gravity_scale = 1;    // within 1e3: 0 floats, -1 rises
    bool sleep_allowed = true;
    AxisLocks locks = 0;
    // Swept, so that it passes through nothing, in a step in which a point of it moves further than
    // half the radius of the ball that fits into its thinnest shape.
    bool continuous = true;
    // kg, 0 or 1e-9 to 1e15; above 0: mass and inertia of the shapes are scaled to it.
    double mass = 0;
    std::uint64_t user_data = 0;  // kept, saved and returned, never read
};

// A body with its shapes, for World::create_bodies.
struct BodyAndShapes {
    BodyDef body = {};
    std::vector<ShapeDef> shapes = {};
};

// How pairs are found. The result is the same, the cost is not: docs/records/performance.md.
enum class BroadPhase : std::uint8_t {
    dynamic_tree,
    sort_and_sweep,
    uniform_grid,
};

// The highest level of World::strain().
inline constexpr int max_overload_level = 3;

struct WorldDef {
    Vec3 gravity{0, -9.81, 0};  // m/s^2, each component within 1e4
    // Sub-steps per step, 1 to 64: more is stiffer and more exact. Multiplied per island: flat and
    // slow x1/2, heaps at rest x3/2 (where bodies may sleep), more than 40 layers on little ground
    // x2, mass ratio of 100 or more on top x4.
    int substeps = 8;
    // m, 0 or 1e-9 to 1e3. Above 0: each island takes as many sub-steps as keep its bodies within
    // so far, after a second, of where endlessly many would bring them: 2, 6, 16 or 48, three to
    // eight times as many where it is slender or carries what is heavy, at most 64; `substeps` is
    // not read. What the length of the step itself does to the motion is not part of it. Every
    // eighth step of an island is then taken twice, with half of its sub-steps first: that measures
    // it. Not where a listener hears of sub-steps. World::island_substeps() says what was found and
    // spent.
    double tolerance = 0;
    // With a tolerance: sub-steps that a step may take, summed over the bodies with contacts or
    // joints; 0: any number; up to 4294967295. Where it does not suffice, islands go without in
    // which that does least harm; the least above they all take, whatever the budget.
    std::int64_t substep_budget = 0;
    // Work of a step (StepProfile::work, in units of about 0.1 microseconds), 0 to 4294967295; 0:
    // any amount. After a step of more the next one gives something up, one level for each such
    // step (World::strain()); it is taken back, level by level, after 30 steps in a row of less
    // than 60 %. 1: manifolds are used again over more motion, 16 mm instead of 4, however fast. 2:
    // also, impacts of moving bodies on each other are left to the contact solver, so what is small
    // and fast may pass through what moves; through static and kinematic bodies nothing does. 3:
    // also, islands take half of their sub-steps, but for what is slender, tall or heavily loaded.
    // Work is counted, not timed: the same bits on any machine. Not with a tolerance.
    std::int64_t step_budget = 0;
    // Threads per step, 1 to 64. The result has the same bits for any number. Steps of less than
    // two milliseconds use them only where a trial shows that they help (thread_trials.h).
    int threads = 1;
    bool sleeping = true;    // bodies at rest leave the step
    bool continuous = true;  // fast bodies are swept, so that nothing tunnels
    // All happens in the xy plane: bodies move along x and y and turn about z. Shapes are their
    // outlines seen along z, 1 m deep: spheres (discs), capsules, boxes, hulls and planes only.
    // Poses, velocities and gravity that leave the plane are refused.
    bool planar = false;
    BroadPhase broad_phase = BroadPhase::dynamic_tree;
    // m/s, 0 to 1e6: contacts that begin at this speed or faster are listed in Events::hits.
    double hit_speed = 1;
    // How joints are solved that do not say so themselves (JointDef::solver): joint_solver.h.
    JointSolver joint_solver = JointSolver::automatic;
};

}  // namespace jostle::physics
