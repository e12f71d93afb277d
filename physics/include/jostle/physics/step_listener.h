// SPDX-License-Identifier: MIT
//
// Step listeners: user code that runs at defined points of a step.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "jostle/physics/ids.h"
#include "jostle/physics/mat3.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

class World;

/// Selects the optional calls of a listener. before_step() and after_step() are always called.
/// Calls that no listener selects cost nothing.
struct StepHooks {
    bool substeps = false;   ///< before_substep() and after_substep()
    bool pre_solve = false;  ///< pre_solve()
    /// Allows concurrent calls of before_substep() and after_substep() for different groups, from
    /// several threads. They may share read-only data only. If all listeners that select `substeps`
    /// set this, groups are smaller and are solved by all threads.
    bool concurrent = false;
};

/// The state of a body during a step.
struct MovingBody {
    BodyId id = {};              ///< the body
    Transform pose = {};         ///< of the body's origin, world
    Vec3 center = {};            ///< centre of mass, m, world
    Vec3 linear_velocity = {};   ///< m/s, of the centre of mass
    Vec3 angular_velocity = {};  ///< rad/s, world axes
    double mass = 0;             ///< kg
};

/// How a body responds to impulses and what accelerates it without them: everything that a module
/// needs to solve its own matter together with the body.
struct BodyResponse {
    Vec3 inverse_mass = {};  ///< 1/kg along the world axes; 0 along locked ones
    /// Inverse inertia about the centre of mass, 1/(kg m^2), world axes; 0 about locked ones.
    Mat3 inverse_inertia = diagonal({0, 0, 0});
    /// By gravity and the forces of this step, m/s^2. The solver adds it in the sub-step.
    Vec3 acceleration = {};
};

/// Returns the velocity change of a body's point per impulse at that point, 1/kg. `arm` is the
/// point relative to the centre of mass, m, world.
Mat3 point_response(const BodyResponse& body, Vec3 arm);
/// Returns the effective mass of a body at a point in a direction of unit length, kg: impulse per
/// velocity change. Infinite if the body cannot move that way.
double effective_mass(const BodyResponse& body, Vec3 arm, Vec3 direction);

/// One sub-step of one group of bodies. The number of sub-steps depends on the group: tall or
/// heavily loaded islands take more. Each awake dynamic body is in exactly one group; sleeping
/// bodies are in none. Bodies that touch or are connected by joints are in the same group; others
/// may be. Groups depend on the world and on the hooks, not on the number of threads.
class SubstepContext {
public:
    virtual ~SubstepContext() = default;

    virtual double h() const = 0;   ///< duration of the sub-step, s
    virtual int index() const = 0;  ///< index of the sub-step, from 0
    virtual int count() const = 0;  ///< number of sub-steps of the group in this step
    /// Simulation time at the start of the sub-step, s.
    virtual double time() const = 0;
    /// The world as it was at the start of the step, for queries. Modifying it through a cast is
    /// undefined behaviour.
    virtual const World& world() const = 0;

    /// Bodies of the group, in a deterministic order.
    virtual std::span<const BodyId> bodies() const = 0;
    virtual bool contains(BodyId body) const = 0;  ///< whether the body is in the group
    /// Returns the current state of a body of the group. In before_substep(), a body without
    /// contacts or joints is shown at its extrapolated position in the middle of the sub-step.
    /// Position-dependent forces are then of second order and conserve energy.
    virtual MovingBody body(BodyId body) const = 0;
    /// Returns the response to impulses of a body of the group, as add_impulse() applies them.
    virtual BodyResponse response(BodyId body) const = 0;
    /// Returns the velocity of a body of the group at a world point, m/s, world.
    virtual Vec3 velocity_at(BodyId body, Vec3 point) const = 0;

    /// Apply an impulse in N s at a world point, or an angular impulse in N m s, to a body of the
    /// group. A force F over the sub-step is the impulse F * h(). Returns false, without effect, if
    /// the body is not in the group.
    virtual bool add_impulse(BodyId body, Vec3 impulse, Vec3 point) = 0;
    virtual bool add_angular_impulse(BodyId body, Vec3 impulse) = 0;

    /// Same as World::parallel_for(), on the threads that solve this group.
    virtual void parallel_for(int count, int grain,
                              const std::function<void(int first, int last)>& function) const = 0;
};

/// Two shapes that are about to touch, and the properties of their contact. Called once when their
/// manifold begins (for a mesh, once per manifold), before the manifold is solved; the properties
/// apply until the manifold ends. For bodies that collide between sub-steps it is called for each
/// impact, and surface_velocity is then ignored.
struct PreSolve {
    const World& world;                  ///< for reading
    ShapeId shape_a = {}, shape_b = {};  ///< the shapes
    BodyId body_a = {}, body_b = {};     ///< their bodies
    Vec3 normal = {};                    ///< unit vector from a to b
    Vec3 point = {};                     ///< m, world, mean of the contact points
    /// Velocity of b relative to a at `point`, m/s; separating if > 0 along the normal.
    Vec3 velocity = {};

    // Properties of the contact. Their initial values come from the materials.
    double friction = 0;     ///< Coulomb coefficient, >= 0
    double restitution = 0;  ///< 0 to 1
    /// Of b's surface relative to a's surface, m/s, world (conveyor belt).
    Vec3 surface_velocity = {};
    bool enabled = true;  ///< if false, the shapes pass through each other
};

/// Base class of code that takes part in a step. Listeners are called in the order in which they
/// were added:
///
///     before_step                       every listener
///     pre_solve                         per new manifold, and per impact between sub-steps
///     before_substep, after_substep     per group of bodies and sub-step
///     after_step                        every listener
///
/// Thread rule: all calls are on the thread that called World::step(), except sub-step calls of
/// listeners that allow concurrent calls (StepHooks::concurrent).
///
/// Determinism: results are bit-identical for any number of threads if a listener depends only on
/// its arguments, its own state and the world. State that the next step depends on belongs into a
/// Module (module.h), which is saved and hashed with the world.
///
/// Listeners must not throw.
class StepListener {
public:
    virtual ~StepListener() = default;

    /// Returns the optional calls that this listener needs. Called when the listener is added and
    /// in every step after all before_step() calls, so a listener without work can select nothing.
    /// The result may depend only on saved state.
    virtual StepHooks hooks() const { return {}; }

    /// Called at the start of a step of dt seconds. May change the world in any way, but must not
    /// call step().
    virtual void before_step(World& world, double dt) {
        static_cast<void>(world), static_cast<void>(dt);
    }
    /// Called before the solver for a contact that begins, if StepHooks::pre_solve is set.
    virtual void pre_solve(PreSolve& pair) { static_cast<void>(pair); }
    /// Called before forces act, and after the last pass of the sub-step, if StepHooks::substeps is
    /// set. Impulses applied in before_substep() take part in the solve of that sub-step.
    virtual void before_substep(SubstepContext& substep) { static_cast<void>(substep); }
    virtual void after_substep(SubstepContext& substep) { static_cast<void>(substep); }
    /// Called at the end of a step. World::events() returns the events of this step.
    virtual void after_step(World& world, double dt) {
        static_cast<void>(world), static_cast<void>(dt);
    }
};

}  // namespace jostle::physics
