// SPDX-License-Identifier: MIT
//
// What takes part in a step: called at stated points of it, in the order in which listeners were
// added, on the thread that called World::step() but for sub-steps of those who say that they may
// be called at once (StepHooks::concurrent).
//
// A step calls:
//     before_step            of every listener
//     pre_solve              for each manifold that begins, and each impact between sub-steps
//     before_substep, after_substep     for each group of bodies and each of its sub-steps
//     after_step             of every listener
//
// Determinism: a listener whose calls depend on nothing but what it is given, its own state and the
// world keeps the promise of the same bits for any number of threads. State that the next step
// depends on belongs into a Module (module.h), which is saved and hashed with the world.
//
// Listeners do not throw.
#pragma once

#include <cstdint>
#include <span>

#include "jostle/physics/ids.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

class World;

// Which of the calls a listener wants besides before_step() and after_step(). What nobody wants
// costs nothing.
struct StepHooks {
    bool substeps = false;
    bool pre_solve = false;
    // Calls of before_substep() and after_substep() for different groups may come at once, from
    // several threads: they share nothing but what they only read. Where all who want sub-steps say
    // so, groups are smaller, and solved by all threads.
    bool concurrent = false;
};

// A body within a step.
struct MovingBody {
    BodyId id = {};
    Transform pose = {};         // of the body's origin
    Vec3 center = {};            // of mass, m, world
    Vec3 linear_velocity = {};   // m/s, of the centre of mass
    Vec3 angular_velocity = {};  // rad/s, world axes
    double mass = 0;             // kg
};

// One sub-step of one group of bodies. How many sub-steps there are depends on the group: the
// solver works harder on what is tall or unevenly loaded. Each awake dynamic body is in one group;
// what sleeps is in none. Bodies that touch or are jointed are in the same group, others may be:
// the groups follow from the world and the hooks, not from the number of threads.
class SubstepContext {
public:
    virtual ~SubstepContext() = default;

    virtual double h() const = 0;   // s, of the sub-step
    virtual int index() const = 0;  // from 0
    virtual int count() const = 0;  // sub-steps of the group in this step
    // s since the start of the world, at the start of the sub-step.
    virtual double time() const = 0;
    // To ask it: as it was when the step began. Changes through casts are undefined.
    virtual const World& world() const = 0;

    virtual std::span<const BodyId> bodies() const = 0;  // of the group, in a stated order
    virtual bool contains(BodyId body) const = 0;
    // As it is at this moment of the step. The body is in the group. Before a sub-step, what
    // touches nothing is shown where it is in the middle of the sub-step if nothing pushes: forces
    // that follow from positions are then of second order and keep their energy.
    virtual MovingBody body(BodyId body) const = 0;
    virtual Vec3 velocity_at(BodyId body, Vec3 point) const = 0;  // m/s, world

    // N s at a world point, N m s. A force F over the sub-step is F * h(). Of a body in the group;
    // false, and nothing done, for any other.
    virtual bool add_impulse(BodyId body, Vec3 impulse, Vec3 point) = 0;
    virtual bool add_angular_impulse(BodyId body, Vec3 impulse) = 0;
};

// Two shapes that are about to touch, and how they shall. Asked once when their manifold begins (of
// a mesh: for each manifold), before anything pushes; the answer holds until the manifold ends.
// Two bodies that meet between sub-steps are asked about at each impact, where the surface velocity
// does not count.
struct PreSolve {
    const World& world;
    ShapeId shape_a = {}, shape_b = {};
    BodyId body_a = {}, body_b = {};
    Vec3 normal = {};    // unit, from a to b
    Vec3 point = {};     // m, world: the middle of where they touch
    Vec3 velocity = {};  // m/s of b against a there; along the normal: > 0 parts

    // The answer. It begins as what the materials give.
    double friction = 0;         // >= 0
    double restitution = 0;      // 0 to 1
    Vec3 surface_velocity = {};  // m/s, world: of b's surface against a's, a conveyor belt
    bool enabled = true;         // false: they pass through each other
};

class StepListener {
public:
    virtual ~StepListener() = default;

    // Read when the listener is added and in each step, after all before_step(): who has nothing to
    // do asks for nothing, and costs nothing. What it says may depend only on what it saves.
    virtual StepHooks hooks() const { return {}; }

    // The world may be changed in any way but step(). dt in s.
    virtual void before_step(World& world, double dt) {
        static_cast<void>(world), static_cast<void>(dt);
    }
    virtual void pre_solve(PreSolve& pair) { static_cast<void>(pair); }
    // Before forces act, and after the sub-step's last pass. Pushes of the first take part in its
    // solve.
    virtual void before_substep(SubstepContext& substep) { static_cast<void>(substep); }
    virtual void after_substep(SubstepContext& substep) { static_cast<void>(substep); }
    // events() are those of this step.
    virtual void after_step(World& world, double dt) {
        static_cast<void>(world), static_cast<void>(dt);
    }
};

}  // namespace jostle::physics
