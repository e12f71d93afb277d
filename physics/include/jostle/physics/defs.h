// SPDX-License-Identifier: MIT
//
// What to create, with defaults that work. SI units: metres, kilograms, seconds, radians. A Def is
// a constant description; the world copies what it needs and keeps no pointer to it.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

enum class BodyType {
    static_body,  // never moves: floors, walls
    kinematic,    // moves by its velocity alone and pushes others: platforms
    dynamic,      // moves by forces, impulses and contacts
};

// How a pair makes one coefficient of two. When the two materials ask for different rules the one
// further down this list wins.
enum class Combine : std::uint8_t {
    average,
    geometric_mean,
    minimum,
    multiply,
    maximum,
};

struct Material {
    double friction = 0.5;     // Coulomb coefficient, >= 0
    double restitution = 0.0;  // 0 (no bounce) to 1 (keeps all speed)
    // Resistance against rolling and against turning on the spot: the torque that a normal force of
    // 1 N holds, N m / N = m. A pair uses the larger. Balls and capsules always hold friction times
    // a twenty-fifth of their radius against turning: the disc in which elastic bodies touch.
    double rolling_friction = 0;
    double torsional_friction = 0;
    // Of the surface against its body, m/s in the body's axes: a conveyor belt. Contacts drive
    // what touches along their tangent plane.
    Vec3 surface_velocity = {};
    Combine friction_rule = Combine::geometric_mean;
    Combine restitution_rule = Combine::maximum;

    bool operator==(const Material&) const = default;
};

// Which shapes meet. Two shapes of the same group other than 0 always collide when it is positive
// and never when it is negative; otherwise they collide when each one's category has a bit in the
// other's mask.
struct Filter {
    std::uint32_t category = 1;
    std::uint32_t mask = 0xffffffff;
    std::int32_t group = 0;

    bool operator==(const Filter&) const = default;
};

inline bool may_meet(const Filter& a, const Filter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

struct ShapeDef {
    Geometry geometry = Box{};
    Transform pose = {};  // of the shape in its body
    Material material = {};
    double density =
        1000;  // kg/m^3, > 0 on dynamic bodies: mass, centre of mass and inertia follow from it
    double mass = 0;  // kg; above 0 it replaces the density
    Filter filter = {};
    bool trigger = false;  // touches nothing; reports what is inside it. Adds no mass
    // Its touching contacts are listed in Events::contacts after each step, with their impulses.
    bool report_stays = false;
    std::uint64_t user_data = 0;  // kept, saved and returned, never read
};

// Directions in which a body cannot move, as bits: along the world's axes, and about them.
using AxisLocks = std::uint8_t;
inline constexpr AxisLocks lock_x = 1, lock_y = 2, lock_z = 4;  // motion along
inline constexpr AxisLocks lock_rotation_x = 8, lock_rotation_y = 16,
                           lock_rotation_z = 32;  // turns about

struct BodyDef {
    BodyType type = BodyType::dynamic;
    Transform pose = {};
    Vec3 linear_velocity = {};   // m/s, of the centre of mass
    Vec3 angular_velocity = {};  // rad/s, world axes
    double linear_damping = 0;   // 1/s, >= 0: dv/dt = -damping v
    double angular_damping = 0;  // 1/s, >= 0
    double gravity_scale = 1;    // 0 floats, -1 rises
    bool sleep_allowed = true;
    AxisLocks locks = 0;
    bool continuous = true;       // swept when it moves further than its own thickness in a step
    double mass = 0;              // kg; above 0: what the shapes give is scaled to it
    std::uint64_t user_data = 0;  // kept, saved and returned, never read
};

// A body with its shapes, for World::create_bodies.
struct BodyAndShapes {
    BodyDef body = {};
    std::vector<ShapeDef> shapes = {};
};

// How pairs are found. The result is the same, the cost is not: docs/performance.md.
enum class BroadPhase : std::uint8_t {
    dynamic_tree,
    sort_and_sweep,
    uniform_grid,
};

struct WorldDef {
    Vec3 gravity{0, -9.81, 0};  // m/s^2
    // Sub-steps per step, 1 to 64: more is stiffer and more exact. Multiplied per island: flat and
    // slow x1/2, heaps that come to rest x3/2 (where bodies may sleep), more than 40 layers on
    // little ground x2, mass ratio over 100 on top x4.
    int substeps = 8;
    // Threads per step, 1 to 64. The result has the same bits for any number. Steps of less than
    // two milliseconds use them only where a trial shows that they help (thread_trials.h).
    int threads = 1;
    bool sleeping = true;    // bodies at rest leave the step
    bool continuous = true;  // fast bodies are swept, so that nothing tunnels
    // Everything happens in the xy plane: bodies move along x and y and turn about z, shapes are
    // their cross-sections, 1 m deep. Spheres (discs), capsules, boxes, hulls and planes only.
    bool planar = false;
    BroadPhase broad_phase = BroadPhase::dynamic_tree;
    double hit_speed = 1;  // m/s: contacts that begin faster are listed in Events::hits
};

}  // namespace jostle::physics
