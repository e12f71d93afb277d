// SPDX-License-Identifier: MIT
//
// World: rigid bodies that move, collide and rest. The library's one entry.
//
// Thread rule: one thread at a time may call non-const functions; const functions may be called by
// many threads at once between steps. step() may use threads of its own (WorldDef::threads); its
// result has the same bits for any number.
//
// Error rule: every call checks its arguments; one that returns an Error has changed nothing. The
// message names the argument, its value and its range.
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
#include "jostle/physics/island_substeps.h"
#include "jostle/physics/joint_defs.h"
#include "jostle/physics/profile.h"
#include "jostle/physics/queries.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

class Module;
class StepListener;
struct WorldState;
struct StepScratch;

// What a body is doing now.
struct BodyState {
    BodyId id;
    BodyType type = BodyType::dynamic;
    Transform pose;         // of the body's origin
    Vec3 center;            // of mass, m, world
    Vec3 linear_velocity;   // m/s, of the centre of mass
    Vec3 angular_velocity;  // rad/s, world axes
    double mass = 0;        // kg; 0 for static and kinematic bodies
    Mat3 inertia;  // kg m^2 about the centre of mass, world axes; zero for fixed and kinematic
                   // bodies
    bool awake = false;  // false for static bodies and for what sleeps
    bool sleep_allowed = true;
    AxisLocks locks = 0;
    std::uint64_t user_data = 0;
};

struct ShapeState {
    ShapeId id;
    BodyId body;
    Geometry geometry;
    Transform pose;  // of the shape in its body
    Material material;
    double density = 0;  // kg/m^3
    double mass = 0;     // kg, when the shape was given one instead of a density
    Filter filter;
    bool trigger = false;
    bool report_stays = false;
    std::uint64_t user_data = 0;
};

// As it was made, so that it can be made again.
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

// A contact of the present moment, for debug views and tests.
struct ContactInfo {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 normal;  // unit, from a to b
    int count = 0;
    Vec3 point[4];           // m, world
    double gap[4] = {};      // m; negative: overlap
    double impulse[4] = {};  // N s along the normal, of the last sub-step
    bool touching = false;
    bool asleep = false;
};

// Sums over the world, for reports and tests.
struct WorldSummary {
    int bodies = 0, dynamic_bodies = 0, awake_bodies = 0, shapes = 0;
    int contacts = 0;  // touching manifolds, awake and asleep
    int joints = 0;
    double max_joint_error = 0;   // m: furthest that two anchors that belong together are apart
    double kinetic_energy = 0;    // J
    double potential_energy = 0;  // J, zero at the origin
    Vec3 linear_momentum;         // kg m/s
    Vec3 angular_momentum;        // kg m^2/s about the origin
    double max_penetration = 0;   // m, deepest overlap of any two shapes now
};

class World {
public:
    World();  // of WorldDef{}
    // For a def of your own making: one that is out of range ends the program with the reason. Who
    // does not know it calls create().
    explicit World(const WorldDef& def);
    static Result<World> create(const WorldDef& def = {});
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    // --- bodies and shapes ---
    Result<BodyId> create_body(const BodyDef& def);
    // A body with one shape: the common case.
    Result<BodyId> create_body(const BodyDef& def, const ShapeDef& shape);
    Result<BodyId> create_body(const BodyDef& def, std::span<const ShapeDef> shapes);
    // All or none, in their order. The error names the body: "bodies[3]: ...".
    Result<std::vector<BodyId>> create_bodies(std::span<const BodyAndShapes> bodies);
    Result<ShapeId> create_shape(BodyId body, const ShapeDef& def);
    // Replaces all shapes of a body. Its origin and the velocity of its points stay.
    Result<std::vector<ShapeId>> set_shapes(BodyId body, std::span<const ShapeDef> shapes);
    // With its shapes, contacts and joints. What rested on it wakes.
    Status destroy_body(BodyId body);
    // All or none. An id that is unknown, or named twice, is an error.
    Status destroy_bodies(std::span<const BodyId> bodies);
    Status destroy_shape(ShapeId shape);

    bool contains(BodyId body) const;
    bool contains(ShapeId shape) const;
    Result<BodyState> body(BodyId body) const;
    // As it could be made again, where it is and as fast; `mass` is 0 if its shapes decide.
    Result<BodyDef> definition(BodyId body) const;
    Result<ShapeState> shape(ShapeId shape) const;
    std::vector<ShapeId> shapes_of(
        BodyId body) const;  // in order of creation; empty for an unknown id
    // Every body in order of index. Reuses `out`, so a caller that keeps it allocates nothing.
    void copy_bodies(std::vector<BodyState>& out) const;
    // The dynamic ones that are awake or sleep beside what moves, and all kinematic ones, in no
    // order: a step moves no others.
    void copy_awake_bodies(std::vector<BodyState>& out) const;
    // Another number when a call may have moved what is static or sleeps: all may be elsewhere,
    // then. Not saved.
    std::uint64_t static_revision() const;
    // Above the index of every body that there is: for lists by index.
    std::uint32_t body_index_end() const;
    std::vector<BodyId> bodies() const;

    // --- changing what a body or a shape is; each wakes the body ---
    // Contacts begin anew. Shapes and joints must suit the type: a dynamic body has a solid shape,
    // a joint at least one dynamic body. A body that becomes static stops.
    Status set_type(BodyId body, BodyType type);
    // kg, 1e-9 to 1e15; 0: back to what its shapes give. Inertia scales with it.
    Status set_mass(BodyId body, double mass);
    Status set_material(ShapeId shape, const Material& material);
    Status set_filter(ShapeId shape, const Filter& filter);
    Status set_damping(BodyId body, double linear, double angular);
    Status set_gravity_scale(BodyId body, double scale);
    Status set_locks(BodyId body, AxisLocks locks);  // what is locked stops
    // Kept, saved and returned, never read. These wake nobody.
    Status set_user_data(BodyId body, std::uint64_t data);
    Status set_user_data(ShapeId shape, std::uint64_t data);
    Status set_user_data(JointId joint, std::uint64_t data);

    // --- sleep ---
    Status wake(BodyId body);
    // true: as wake(). false: the body sleeps at once, with its island (all that touches or is
    // jointed to it), until something disturbs one of them. Dynamic bodies only.
    Status set_awake(BodyId body, bool awake);
    // Whether the body may fall asleep by itself (BodyDef::sleep_allowed).
    Status set_sleep_allowed(BodyId body, bool allowed);

    // --- joints ---
    Result<JointId> create_joint(const JointDef& def);
    Status destroy_joint(JointId joint);
    // Other limits, motor or spring for a joint of the same kind.
    Status set_joint(JointId joint, const JointKind& kind);
    // How it is solved from the next step on; empty: as the world says. Wakes nobody.
    Status set_joint_solver(JointId joint, std::optional<JointSolver> solver);
    bool contains(JointId joint) const;
    Result<JointState> joint(JointId joint) const;
    std::vector<JointId> joints() const;
    std::vector<JointId> joints_of(BodyId body) const;

    // --- pushing bodies about; each wakes the body ---
    Status set_pose(BodyId body, const Transform& pose);
    Status set_velocity(BodyId body, Vec3 linear, Vec3 angular);  // m/s, rad/s
    Status set_linear_velocity(BodyId body, Vec3 velocity);       // m/s, of the centre of mass
    Status set_angular_velocity(BodyId body, Vec3 velocity);      // rad/s, world axes
    // Gives a kinematic body the velocity that takes it to the pose within dt (a step): unlike
    // set_pose it pushes what is in the way.
    Status move_to(BodyId body, const Transform& pose, double dt);
    Status apply_impulse(BodyId body, Vec3 impulse, Vec3 point);  // N s at a world point, at once
    Status apply_angular_impulse(BodyId body, Vec3 impulse);      // N m s, at once
    Status apply_force(BodyId body, Vec3 force,
                       Vec3 point);                 // N at a world point, during the next step
    Status apply_torque(BodyId body, Vec3 torque);  // N m, during the next step

    // --- force fields: force_fields.h ---
    // Each call wakes what is in the region that the field has, and in that which it had.
    Result<FieldId> create_field(const FieldDef& def);
    Status set_field(FieldId field, const FieldDef& def);
    Status destroy_field(FieldId field);
    bool contains(FieldId field) const;
    Result<FieldDef> field(FieldId field) const;
    std::vector<FieldId> fields() const;

    // --- what takes part in the step: step_listener.h, module.h ---
    // Called in the order of adding, modules among listeners. The caller keeps a listener alive
    // until it is removed or the world ends; it belongs to no saved world and no restore point.
    Status add_listener(StepListener& listener);
    Status remove_listener(StepListener& listener);
    // The world owns it. One of a tag.
    Status add_module(std::unique_ptr<Module> module);
    Status remove_module(std::string_view tag);
    Module* module(std::string_view tag);  // null: none of that tag
    const Module* module(std::string_view tag) const;
    std::vector<std::string> modules() const;  // tags, in their order

    // --- time ---
    // Advances by dt seconds, 1e-5 to 0.25. From within a step (a listener): failed_precondition.
    // `aborted`: stop_stepping() was called.
    Status step(double dt);
    // Any thread, also while a step runs: a step that takes too long is to end. It leaves out the
    // sub-steps and sweeps that are still to come, so the world is whole but is not where it would
    // have been, and step() refuses until resume_stepping().
    void stop_stepping();
    void resume_stepping();
    std::uint64_t step_count() const;
    double time() const;  // s: the sum of all dt
    Vec3 gravity() const;
    Status set_gravity(Vec3 gravity);  // m/s^2; wakes every body when it changes
    int substeps() const;
    double tolerance() const;  // m; 0: none
    std::int64_t substep_budget() const;
    std::int64_t step_budget() const;  // 0: none
    // What the next step will give up to keep to the step's budget: WorldDef::step_budget.
    int overload_level() const;
    JointSolver joint_solver() const;
    Status set_joint_solver(JointSolver solver);  // from the next step on; wakes nobody
    Status set_threads(
        int threads);  // not part of the state: changes nothing but the time a step takes

    // --- reading ---
    Events events() const;
    const StepProfile& profile() const;
    WorldSummary summary() const;
    // The manifolds of one body, touching or near, awake or asleep, by shapes.
    Result<std::vector<ContactInfo>> contacts_of(BodyId body) const;
    // Who touches it, each once, by id.
    Result<std::vector<BodyId>> touching_bodies(BodyId body) const;

    // What each awake island that is not alone takes, by body; after a step.
    std::vector<IslandSubsteps> island_substeps() const;

    // --- what a step has to solve: constraint_system.h ---
    // Of all that joints and touching contacts hang together with a dynamic body, awake or asleep.
    // Contacts are as the last step left them. Errors: not_found; failed_precondition when the body
    // is not dynamic, or no row of it can act; resource_exhausted beyond constraint_rows_max rows.
    Result<ConstraintSystem> constraint_system(BodyId body,
                                               const ConstraintSystemOptions& options = {}) const;
    Result<ConstraintSystem> constraint_system(JointId joint,
                                               const ConstraintSystemOptions& options = {}) const;

    // --- queries ---
    // About the present moment: good until the world changes.
    Queries queries() const;
    // About this moment for ever: a copy that may be asked while the world steps on.
    Queries query_frame() const;

    // --- for listeners, in before_step() and after_step() ---
    // Calls part(first, last) for parts of [0, count), of `grain` or more, on all threads of the
    // world, and returns when all are done; too few stay on this one. Parts come at once and in any
    // order: each writes what is its own and no other reads, and of the world it only reads. Then
    // the bits are the same for any number of threads.
    void parallel_for(int count, int grain,
                      const std::function<void(int first, int last)>& part) const;

    // --- for debug views ---
    std::vector<ContactInfo> contacts() const;         // by shapes
    std::vector<std::vector<BodyId>> islands() const;  // each by id
    std::vector<Aabb> broad_phase_cells() const;       // how the broad phase is organised
    Result<Aabb> bounds(ShapeId shape) const;          // not of planes
    Result<Aabb> fat_bounds(ShapeId shape) const;

private:
    friend Result<World> load(std::span<const std::byte> bytes);
    friend struct WorldAccess;  // the library's own files
    explicit World(std::unique_ptr<WorldState> state);

    std::unique_ptr<WorldState> state_;
    std::unique_ptr<StepScratch> scratch_;  // memory that steps use again
};

}  // namespace jostle::physics
