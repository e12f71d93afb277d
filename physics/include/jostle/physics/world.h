// SPDX-License-Identifier: MIT
//
// World: a simulation of rigid bodies, and the entry point of the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/constraint_system.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/events.h"
#include "jostle/physics/force_fields.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/joint_defs.h"
#include "jostle/physics/profile.h"
#include "jostle/physics/queries.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

class Module;
class StepListener;
struct WorldState;
struct StepScratch;

/// The current state of a body (World::body).
struct BodyState {
    BodyId id;                          ///< the body
    BodyType type = BodyType::dynamic;  ///< how the body moves
    Transform pose;                     ///< of the body's origin, world
    Vec3 center;                        ///< centre of mass, m, world
    Vec3 linear_velocity;               ///< m/s, of the centre of mass
    Vec3 angular_velocity;              ///< rad/s, world axes
    double mass = 0;                    ///< kg; 0 for static and kinematic bodies
    /// Inertia about the centre of mass, kg m^2, world axes; zero for static and kinematic bodies.
    Mat3 inertia;
    bool awake = false;           ///< false for static and sleeping bodies
    bool sleep_allowed = true;    ///< BodyDef::sleep_allowed
    AxisLocks locks = 0;          ///< locked degrees of freedom
    std::uint64_t user_data = 0;  ///< BodyDef::user_data
};

/// The current state of a shape (World::shape).
struct ShapeState {
    ShapeId id;                   ///< the shape
    BodyId body;                  ///< the body that the shape belongs to
    Geometry geometry;            ///< as stored; the normal of a plane has unit length
    Transform pose;               ///< in the body's local frame
    Material material;            ///< surface properties
    double density = 0;           ///< kg/m^3
    double mass = 0;              ///< explicit mass in kg; 0: the mass follows from the density
    Filter filter;                ///< which shapes it collides with
    bool trigger = false;         ///< ShapeDef::trigger
    bool report_stays = false;    ///< ShapeDef::report_stays
    std::uint64_t user_data = 0;  ///< ShapeDef::user_data
};

/// Returns the definition that creates an identical shape.
inline ShapeDef def_of(const ShapeState& shape) {
    return {.geometry = shape.geometry,
            .pose = shape.pose,
            .material = shape.material,
            .density = shape.density,
            .mass = shape.mass,
            .filter = shape.filter,
            .trigger = shape.trigger,
            .report_stays = shape.report_stays,
            .user_data = shape.user_data};
}

/// A current contact manifold, for debug views and tests.
struct ContactInfo {
    ShapeId shape_a, shape_b;  ///< the shapes
    BodyId body_a, body_b;     ///< their bodies; a is dynamic
    Vec3 normal;               ///< unit vector from a to b
    int count = 0;             ///< number of points, 0 to 4
    Vec3 point[4];             ///< m, world
    double gap[4] = {};        ///< m; negative: overlap
    double impulse[4] = {};    ///< along the normal, N s, of the last sub-step
    bool touching = false;     ///< whether the shapes touch; false if they are only close
    bool asleep = false;       ///< whether the manifold belongs to a sleeping island
};

/// Totals over the world, for reports and tests (World::summary).
struct WorldSummary {
    /// Counts; awake_bodies includes all kinematic bodies.
    int bodies = 0, dynamic_bodies = 0, awake_bodies = 0, shapes = 0;
    int contacts = 0;  ///< touching contacts, awake and asleep
    int joints = 0;    ///< number of joints
    /// Largest position error of a joint, m: distance of its ends from where it allows them.
    double max_joint_error = 0;
    double kinetic_energy = 0;    ///< J
    double potential_energy = 0;  ///< J, zero at the origin
    Vec3 linear_momentum;         ///< kg m/s
    Vec3 angular_momentum;        ///< kg m^2/s, about the origin
    double max_penetration = 0;   ///< m, deepest current overlap of two shapes
};

/// A simulation of rigid bodies, shapes, joints and force fields.
///
/// Thread rule: one thread at a time may call non-const functions. Between steps, any number of
/// threads may call const functions concurrently. step() may use additional threads
/// (WorldDef::threads); its results are bit-identical for any number.
///
/// Error rule: every call checks its arguments. A call that returns an Error has not changed the
/// world. The message names the argument, its value and its range. Errors common to all calls:
/// not_found for an id that is unknown or destroyed, invalid_argument for a value out of range,
/// failed_precondition for a call that the type of the body or the state of the world does not
/// allow.
///
///     World world;
///     BodyId ball = world.create_body({.pose = {{0, 5, 0}}}, {.geometry = Sphere{0.5}}).value();
///     world.step(1.0 / 60).expect();
///     const Vec3 position = world.body(ball)->pose.position;
class World {
public:
    /// Creates a world with the default WorldDef.
    World();
    /// Creates a world. Prints the error and aborts if the definition is out of range; use create()
    /// to get an Error instead.
    explicit World(const WorldDef& def);
    /// Creates a world. Errors: invalid_argument if the definition is out of range.
    static Result<World> create(const WorldDef& def = {});
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    // --- bodies and shapes ---
    /// Creates a body without shapes. A dynamic body has no mass until it has a shape.
    Result<BodyId> create_body(const BodyDef& def);
    /// Creates a body with one shape.
    Result<BodyId> create_body(const BodyDef& def, const ShapeDef& shape);
    /// Creates a body with its shapes. Cheaper than adding shapes one by one, because mass and
    /// bounds are computed once. An error names the shape: "shapes[2]: ...".
    Result<BodyId> create_body(const BodyDef& def, std::span<const ShapeDef> shapes);
    /// Creates several bodies in order, or none if one is invalid. The error names the body:
    /// "bodies[3]: ...".
    Result<std::vector<BodyId>> create_bodies(std::span<const BodyAndShapes> bodies);
    /// Adds a shape to a body and wakes the body. Mass and centre of mass change; the body's origin
    /// and the velocity of its material points do not.
    Result<ShapeId> create_shape(BodyId body, const ShapeDef& def);
    /// Replaces all shapes of a body. The body's origin and the velocity of its material points do
    /// not change. A dynamic body needs at least one shape.
    Result<std::vector<ShapeId>> set_shapes(BodyId body, std::span<const ShapeDef> shapes);
    /// Destroys a body with its shapes, contacts and joints. Wakes the bodies that touched it.
    Status destroy_body(BodyId body);
    /// Destroys several bodies, or none if an id is unknown or listed twice.
    Status destroy_bodies(std::span<const BodyId> bodies);
    /// Destroys a shape. Errors: failed_precondition for the last shape of a dynamic body, which
    /// needs a mass.
    Status destroy_shape(ShapeId shape);

    /// Returns true if the id names an existing object.
    bool contains(BodyId body) const;
    bool contains(ShapeId shape) const;
    /// Returns the current state of a body.
    Result<BodyState> body(BodyId body) const;
    /// Returns the definition that recreates the body with its current pose and velocity. `mass` is
    /// 0 if the shapes determine the mass.
    Result<BodyDef> definition(BodyId body) const;
    /// Returns the current state of a shape.
    Result<ShapeState> shape(ShapeId shape) const;
    /// Returns the shapes of a body in order of creation; empty for an unknown id.
    std::vector<ShapeId> shapes_of(BodyId body) const;
    /// Copies the states of all bodies, sorted by index. Reuses the memory of `out`.
    void copy_bodies(std::vector<BodyState>& out) const;
    /// Copies the states of all bodies that a step can move, in no particular order: dynamic bodies
    /// that are awake or sleep in place, and all kinematic bodies. Reuses the memory of `out`.
    void copy_awake_bodies(std::vector<BodyState>& out) const;
    /// Returns a revision counter. It changes when a call may have moved static or sleeping bodies;
    /// all poses must then be refreshed. Not saved.
    std::uint64_t static_revision() const;
    /// Returns an upper bound (exclusive) of the indices of all bodies, to size arrays by index.
    std::uint32_t body_index_end() const;
    /// Returns the ids of all bodies, sorted by index.
    std::vector<BodyId> bodies() const;

    // --- body and shape properties; each call wakes the body ---
    /// Changes the type of a body and restarts its contacts. Errors: failed_precondition if shapes
    /// or joints do not allow the type: a dynamic body needs a solid shape, a joint at least one
    /// dynamic body. A body that becomes static stops.
    Status set_type(BodyId body, BodyType type);
    /// Sets the total mass of a dynamic body in kg, 1e-9 to 1e15; 0 restores the mass of its
    /// shapes. The inertia is scaled with it.
    Status set_mass(BodyId body, double mass);
    /// Sets the material of a shape and restarts its contacts.
    Status set_material(ShapeId shape, const Material& material);
    /// Sets the collision filter of a shape and restarts its contacts.
    Status set_filter(ShapeId shape, const Filter& filter);
    /// Sets the damping of a body, 1/s, 0 to 1e4.
    Status set_damping(BodyId body, double linear, double angular);
    /// Sets the factor by which gravity acts on a body, -1e3 to 1e3.
    Status set_gravity_scale(BodyId body, double scale);
    /// Sets the locked degrees of freedom of a body. Motion along or about locked axes stops.
    Status set_locks(BodyId body, AxisLocks locks);
    /// Set the user data, which is stored, saved and returned but not interpreted. Wake no bodies.
    Status set_user_data(BodyId body, std::uint64_t data);
    Status set_user_data(ShapeId shape, std::uint64_t data);
    Status set_user_data(JointId joint, std::uint64_t data);

    // --- sleep ---
    /// Wakes a body and its island.
    Status wake(BodyId body);
    /// Wakes a body, or puts it to sleep immediately with its island (all bodies connected to it by
    /// contacts or joints), until one of them is disturbed. Sleeping requires a dynamic body and
    /// WorldDef::sleeping.
    Status set_awake(BodyId body, bool awake);
    /// Sets whether the body may fall asleep (BodyDef::sleep_allowed). Wakes the body if false.
    Status set_sleep_allowed(BodyId body, bool allowed);

    // --- joints ---
    /// Creates a joint and wakes its bodies.
    Result<JointId> create_joint(const JointDef& def);
    /// Destroys a joint and wakes its bodies.
    Status destroy_joint(JointId joint);
    /// Changes the parameters of a joint, such as limits, motor or spring. The kind must be the
    /// same. Wakes the bodies if a parameter changes.
    Status set_joint(JointId joint, const JointKind& kind);
    /// Sets the solver of a joint from the next step on; empty: the world's default. Wakes no
    /// bodies.
    Status set_joint_solver(JointId joint, std::optional<JointSolver> solver);
    bool contains(JointId joint) const;
    /// Returns the current state of a joint.
    Result<JointState> joint(JointId joint) const;
    /// Returns the ids of all joints, sorted by index.
    std::vector<JointId> joints() const;
    /// Returns the joints of a body, sorted by id; empty for an unknown id.
    std::vector<JointId> joints_of(BodyId body) const;
    /// Returns a revision counter. It changes when a joint is created or destroyed, also by a step.
    /// Not saved.
    std::uint64_t joint_revision() const;

    // --- motion, forces and impulses; each call wakes the body ---
    /// Teleports a body to a pose and restarts its contacts.
    Status set_pose(BodyId body, const Transform& pose);
    /// Sets both velocities, m/s and rad/s, each component within 1e4. Errors: failed_precondition
    /// for static bodies.
    Status set_velocity(BodyId body, Vec3 linear, Vec3 angular);
    Status set_linear_velocity(BodyId body, Vec3 velocity);   ///< m/s, of the centre of mass
    Status set_angular_velocity(BodyId body, Vec3 velocity);  ///< rad/s, world axes
    /// Sets the velocity of a kinematic body so that it reaches the pose after dt seconds (one
    /// step; 1e-5 to 0.25). Unlike set_pose(), it pushes bodies that are in its path.
    Status move_to(BodyId body, const Transform& pose, double dt);
    /// Applies an impulse in N s at a world point immediately. Each component within 1e12; dynamic
    /// bodies only.
    Status apply_impulse(BodyId body, Vec3 impulse, Vec3 point);
    /// Applies an angular impulse in N m s immediately. Each component within 1e12; dynamic bodies
    /// only.
    Status apply_angular_impulse(BodyId body, Vec3 impulse);
    /// Applies a force in N at a world point during the next step. Each component within 1e12;
    /// dynamic bodies only.
    Status apply_force(BodyId body, Vec3 force, Vec3 point);
    /// Applies a torque in N m during the next step. Each component within 1e12; dynamic bodies
    /// only.
    Status apply_torque(BodyId body, Vec3 torque);

    // --- force fields: force_fields.h ---
    /// Creates a force field and wakes the bodies in its region. Cost: linear in the number of
    /// bodies.
    Result<FieldId> create_field(const FieldDef& def);
    /// Changes a force field and wakes the bodies in its old and its new region. Cost: linear in
    /// the number of bodies.
    Status set_field(FieldId field, const FieldDef& def);
    /// Destroys a force field and wakes the bodies in its region. Cost: linear in the number of
    /// bodies.
    Status destroy_field(FieldId field);
    bool contains(FieldId field) const;
    /// Returns the current definition of a force field.
    Result<FieldDef> field(FieldId field) const;
    /// Returns the ids of all force fields, sorted by index.
    std::vector<FieldId> fields() const;

    // --- listeners and modules: step_listener.h, module.h ---
    /// Adds a listener. Listeners and modules are called in the order in which they were added. The
    /// caller keeps the listener alive until it is removed or the world is destroyed. Listeners are
    /// not part of saved worlds and restore points.
    ///
    /// Errors of this and the following three calls: failed_precondition during a step.
    Status add_listener(StepListener& listener);
    /// Removes a listener. Errors: not_found if it was not added; failed_precondition for a module.
    Status remove_listener(StepListener& listener);
    /// Adds a module, which the world owns. Errors: failed_precondition if the world has a module
    /// with this tag.
    Status add_module(std::unique_ptr<Module> module);
    /// Removes and destroys a module.
    Status remove_module(std::string_view tag);
    /// Returns the module with this tag; null if there is none.
    Module* module(std::string_view tag);
    const Module* module(std::string_view tag) const;
    /// Returns the tags of the modules, in order.
    std::vector<std::string> modules() const;

    // --- time ---
    /// Advances the world by dt seconds, 1e-5 to 0.25. Errors: failed_precondition within a step
    /// (from a listener); aborted after stop_stepping().
    Status step(double dt);
    /// Aborts the current step from any thread. The step skips its remaining sub-steps and sweeps,
    /// so the world is consistent but differs from the state after a complete step. step() then
    /// fails until resume_stepping() is called.
    void stop_stepping();
    /// Allows step() again after stop_stepping().
    void resume_stepping();
    /// Returns the number of steps.
    std::uint64_t step_count() const;
    /// Returns the simulation time in s: the sum of all dt.
    double time() const;
    /// Returns the gravity in m/s^2.
    Vec3 gravity() const;
    /// Sets the gravity in m/s^2, each component within 1e4. Wakes all bodies if it changes.
    Status set_gravity(Vec3 gravity);
    int substeps() const;                 ///< WorldDef::substeps
    double tolerance() const;             ///< WorldDef::tolerance, m; 0: none
    std::int64_t substep_budget() const;  ///< WorldDef::substep_budget; 0: unlimited
    std::int64_t step_budget() const;     ///< WorldDef::step_budget; 0: unlimited
    int max_pairs_per_shape() const;      ///< WorldDef::max_pairs_per_shape; 0: unlimited
    /// Takes effect in the next step. Pairs that are already tracked stay tracked.
    Status set_max_pairs_per_shape(int pairs);
    /// Returns the overload level of the next step, 0 to max_overload_level
    /// (WorldDef::step_budget).
    int overload_level() const;
    JointSolver joint_solver() const;  ///< WorldDef::joint_solver
    /// Sets the default joint solver from the next step on. Wakes no bodies.
    Status set_joint_solver(JointSolver solver);
    /// Sets the number of threads, 1 to 64. Not part of the state: it affects only the duration of
    /// a step.
    Status set_threads(int threads);

    // --- results of the last step ---
    /// Returns the events of the last step. The spans are valid until the next step or restore.
    Events events() const;
    /// Returns cost and counters of the last step.
    const StepProfile& profile() const;
    /// Computes totals over all bodies, contacts and joints. Cost: linear in their number.
    WorldSummary summary() const;
    /// Returns the contact manifolds of a body, touching or close, awake or asleep, sorted by
    /// shapes.
    Result<std::vector<ContactInfo>> contacts_of(BodyId body) const;
    /// Returns the bodies that touch a body, each once, sorted by id.
    Result<std::vector<BodyId>> touching_bodies(BodyId body) const;

    /// Returns the sub-steps and the estimated error of each awake island with contacts or joints,
    /// sorted by body. Valid after a step.
    std::vector<IslandSubsteps> island_substeps() const;

    // --- constraint system: constraint_system.h ---
    /// Builds the constraint system of all bodies that joints and touching contacts connect to a
    /// dynamic body or to a dynamic body of the joint. The bodies may be awake or asleep. Contacts
    /// are those of the last step.
    ///
    /// Errors: not_found; failed_precondition if the body is not dynamic or no row of it can act;
    /// resource_exhausted for more than constraint_rows_max rows.
    Result<ConstraintSystem> constraint_system(BodyId body,
                                               const ConstraintSystemOptions& options = {}) const;
    Result<ConstraintSystem> constraint_system(JointId joint,
                                               const ConstraintSystemOptions& options = {}) const;

    // --- queries: queries.h ---
    /// Returns queries on the current state, valid until the world changes or is destroyed.
    Queries queries() const;
    /// Returns queries on a copy of the current state. The copy can be queried while the world
    /// steps on, and remains valid after the world is destroyed.
    Queries query_frame() const;

    // --- for listeners, in before_step() and after_step() ---
    /// Calls function(first, last) for subranges of [0, count) of at least `grain` elements, on all
    /// threads of the world, and returns after all calls have returned. Small ranges stay on the
    /// calling thread. Subranges run concurrently and in any order: a call may write only data that
    /// no other call accesses, and may only read the world. The results are then bit-identical for
    /// any number of threads.
    void parallel_for(int count, int grain,
                      const std::function<void(int first, int last)>& function) const;

    /// Counts work of a module, in the units of StepProfile::work (about 0.1 us), towards this step
    /// and its budget. Call it in before_step(), with an amount that depends on state only.
    void count_work(std::int64_t work);

    // --- for debug views ---
    std::vector<ContactInfo> contacts() const;         ///< sorted by shapes
    std::vector<std::vector<BodyId>> islands() const;  ///< each sorted by id
    std::vector<Aabb> broad_phase_cells() const;       ///< structure of the broad phase
    Result<Aabb> bounds(ShapeId shape) const;          ///< not for planes
    /// Enlarged bounds that the broad phase uses. Not for planes.
    Result<Aabb> fat_bounds(ShapeId shape) const;

private:
    friend Result<World> load(std::span<const std::byte> bytes);
    friend struct WorldAccess;  // for the library's own files
    explicit World(std::unique_ptr<WorldState> state);

    std::unique_ptr<WorldState> state_;
    std::unique_ptr<StepScratch> scratch_;  // memory reused across steps
};

}  // namespace jostle::physics
