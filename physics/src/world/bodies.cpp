// SPDX-License-Identifier: MIT
//
// Create, destroy, move and push bodies.
#include <algorithm>

#include "jostle/physics/limits.h"
#include "jostle/physics/world.h"
#include "state/body_sets.h"
#include "state/contact_graph.h"
#include "state/islands.h"
#include "state/joint_graph.h"
#include "state/shape_proxy.h"
#include "state/wake.h"
#include "world/checks.h"
#include "world/mass.h"

namespace jostle::physics {
namespace {

double look_ahead_dt(const WorldState& world) {
    return world.last_dt > 0 ? world.last_dt : 1.0 / 60;
}

// After the pose or velocity of an awake body changed from outside.
void touch_up(WorldState& world, std::uint32_t body) {
    update_motion_bound(world, body, look_ahead_dt(world));
    const BodyWarm& warm = warm_of(world, body);
    for (std::uint32_t s = world.bodies.cold[body].first_shape; s != none;
         s = world.shapes.shapes[s].next)
        enlarge_proxy(world, s, warm, look_ahead_dt(world));
}

// After the velocity of an awake body changed from outside: what it will meet in the next step must
// be among its pairs.
void speed_up(WorldState& world, std::uint32_t body) {
    update_motion_bound(world, body, look_ahead_dt(world));
    const BodyWarm& warm = warm_of(world, body);
    for (std::uint32_t s = world.bodies.cold[body].first_shape; s != none;
         s = world.shapes.shapes[s].next)
        if (!fits_fat_aabb(world.shapes.shapes[s], warm, look_ahead_dt(world)))
            enlarge_proxy(world, s, warm, look_ahead_dt(world));
}

// Velocities along and about locked axes are none. Kinematic bodies know no locks.
void obey_locks(const BodyCold& cold, BodyWarm& warm) {
    if (cold.locks == 0 || cold.type != BodyType::dynamic) return;
    warm.v = scaled(warm.v, free_directions(cold));
    warm.w = scaled(warm.w, free_turns(cold));
}

// The body awake and its velocity about to change.
BodyWarm& stir(WorldState& world, std::uint32_t body) {
    wake_body(world, body);
    return warm_of(world, body);
}

Status check_dynamic(const WorldState& world, BodyId id) {
    if (Status s = check_id(world, id); !s.ok()) return s;
    if (world.bodies.cold[id.index].type == BodyType::dynamic) return {};
    return Error{ErrorCode::failed_precondition,
                 "body {" + std::to_string(id.index) + ", " + std::to_string(id.generation) +
                     "} is not dynamic; forces and impulses move dynamic bodies only"};
}

BodyState state_of(const WorldState& world, std::uint32_t index) {
    const BodyCold& cold = world.bodies.cold[index];
    const BodyWarm& warm = warm_of(world, index);
    return {.id = body_id(world, index),
            .type = cold.type,
            .pose = pose_of(warm, cold),
            .center = warm.center,
            .linear_velocity = warm.v,
            .angular_velocity = warm.w,
            .mass = cold.mass,
            .inertia = warm.axes * cold.inertia * transpose(warm.axes),
            .awake = cold.set == BodySet::awake && !cold.asleep_in_place,
            .locks = cold.locks,
            .user_data = cold.user_data};
}

void remove_body(WorldState& world, std::uint32_t body) {
    BodyCold& cold = world.bodies.cold[body];
    // What rested on it, or beside it, falls; what it was part of may fall apart.
    wake_neighbours(world, body);
    wake_body(world, body);
    destroy_contacts_of(world, body, world.events.pending.ended);
    while (cold.first_joint != none) destroy_joint(world, cold.first_joint / 2);
    for (std::uint32_t s = cold.first_shape; s != none;) {
        const std::uint32_t next = world.shapes.shapes[s].next;
        destroy_proxy(world, s);
        world.shapes.shapes[s] = ShapeRecord{};
        world.shapes.ids.give_back(s);
        s = next;
    }
    if (cold.island != none) remove_from_island(world, body);
    leave_set(world, body);
    cold = BodyCold{};
    world.bodies.motion[body] = {};
    world.bodies.ids.give_back(body);
}

}  // namespace

Result<BodyId> World::create_body(const BodyDef& def) {
    if (Status s = check_body(def); !s.ok()) return s.error();
    WorldState& world = *state_;
    if (world.def.planar)
        if (Status s = check_flat_body(def); !s.ok()) return s.error();
    constexpr AxisLocks out_of_plane = lock_z | lock_turn_x | lock_turn_y;
    const std::uint32_t index = world.bodies.ids.take();
    if (index == world.bodies.cold.size()) {
        world.bodies.cold.emplace_back();
        world.bodies.motion.emplace_back();
    }
    world.bodies.cold[index] =
        BodyCold{.type = def.type,
                 .may_sleep = def.may_sleep,
                 .continuous = def.continuous,
                 .locks = static_cast<AxisLocks>(def.locks | (world.def.planar ? out_of_plane : 0)),
                 .linear_damping = def.linear_damping,
                 .angular_damping = def.angular_damping,
                 .gravity_scale = def.gravity_scale,
                 .wanted_mass = def.mass,
                 .user_data = def.user_data};
    world.bodies.motion[index] = {};
    BodyWarm warm{.body = index,
                  .center = def.pose.position,
                  .rotation = unit(def.pose.rotation),
                  .v = def.linear_velocity,
                  .w = def.angular_velocity};
    warm.axes = to_matrix(warm.rotation);
    obey_locks(world.bodies.cold[index], warm);
    if (def.type == BodyType::fixed)
        enter_static(world, warm);
    else
        enter_awake(world, warm);
    if (def.type == BodyType::dynamic) add_to_island(world, create_island(world), index);
    update_motion_bound(world, index, look_ahead_dt(world));
    return body_id(world, index);
}

Result<BodyId> World::create_body(const BodyDef& def, const ShapeDef& shape) {
    // Both checked before anything is made: half a body is worse than none.
    if (Status s = check_body(def); !s.ok()) return s.error();
    if (Status s = check_shape(shape, def.type); !s.ok()) return s.error();
    if (state_->def.planar)
        if (Status s = check_flat_shape(shape); !s.ok()) return s.error();
    Result<BodyId> body = create_body(def);
    if (!body.ok()) return body.error();
    if (Result<ShapeId> made = create_shape(*body, shape); !made.ok()) return made.error();
    return body;
}

Result<ShapeId> World::create_shape(BodyId body, const ShapeDef& def) {
    WorldState& world = *state_;
    if (Status s = check_id(world, body); !s.ok()) return s.error();
    BodyCold& cold = world.bodies.cold[body.index];
    if (Status s = check_shape(def, cold.type); !s.ok()) return s.error();
    if (world.def.planar)
        if (Status s = check_flat_shape(def); !s.ok()) return s.error();
    wake_body(world, body.index);

    const std::uint32_t index = world.shapes.ids.take();
    if (index == world.shapes.shapes.size()) world.shapes.shapes.emplace_back();
    ShapeRecord& shape = world.shapes.shapes[index];
    shape = ShapeRecord{.geometry = stored(def.geometry),
                        .pose = {def.pose.position, unit(def.pose.rotation)},
                        .material = def.material,
                        .density = def.density,
                        .mass = def.mass,
                        .filter = def.filter,
                        .trigger = def.trigger,
                        .report_stays = def.report_stays,
                        .body = body.index};
    if (cold.last_shape == none)
        cold.first_shape = index;
    else
        world.shapes.shapes[cold.last_shape].next = index;
    cold.last_shape = index;
    // The centre of mass moves, so manifolds of the body's other shapes must be built anew.
    if (cold.type == BodyType::dynamic)
        destroy_contacts_of(world, body.index, world.events.pending.ended);
    update_mass(world, body.index);
    touch_up(world, body.index);
    create_proxy(world, index);
    return shape_id(world, index);
}

Status World::destroy_shape(ShapeId id) {
    WorldState& world = *state_;
    if (Status s = check_id(world, id); !s.ok()) return s;
    const std::uint32_t body = world.shapes.shapes[id.index].body;
    BodyCold& cold = world.bodies.cold[body];
    if (cold.type == BodyType::dynamic && cold.first_shape == cold.last_shape)
        return Error{
            ErrorCode::failed_precondition,
            "the last shape of a dynamic body gives it its mass; destroy the body instead"};
    wake_neighbours(world, body);
    wake_body(world, body);
    destroy_contacts_of(world, body, world.events.pending.ended);
    destroy_proxy(world, id.index);
    std::uint32_t previous = none;
    for (std::uint32_t s = cold.first_shape; s != id.index; s = world.shapes.shapes[s].next)
        previous = s;
    const std::uint32_t next = world.shapes.shapes[id.index].next;
    (previous == none ? cold.first_shape : world.shapes.shapes[previous].next) = next;
    if (cold.last_shape == id.index) cold.last_shape = previous;
    world.shapes.shapes[id.index] = ShapeRecord{};
    world.shapes.ids.give_back(id.index);
    update_mass(world, body);
    touch_up(world, body);
    return {};
}

Status World::destroy_body(BodyId body) {
    if (Status s = check_id(*state_, body); !s.ok()) return s;
    remove_body(*state_, body.index);
    return {};
}

bool World::contains(BodyId body) const {
    return check_id(*state_, body).ok();
}
bool World::contains(ShapeId shape) const {
    return check_id(*state_, shape).ok();
}

Result<BodyState> World::body(BodyId body) const {
    if (Status s = check_id(*state_, body); !s.ok()) return s.error();
    return state_of(*state_, body.index);
}

Result<ShapeState> World::shape(ShapeId id) const {
    if (Status s = check_id(*state_, id); !s.ok()) return s.error();
    const ShapeRecord& shape = state_->shapes.shapes[id.index];
    return ShapeState{.id = id,
                      .body = body_id(*state_, shape.body),
                      .geometry = shape.geometry,
                      .pose = shape.pose,
                      .material = shape.material,
                      .density = shape.density,
                      .mass = shape.mass,
                      .filter = shape.filter,
                      .trigger = shape.trigger,
                      .report_stays = shape.report_stays};
}

std::vector<ShapeId> World::shapes_of(BodyId body) const {
    std::vector<ShapeId> shapes;
    if (!contains(body)) return shapes;
    for (std::uint32_t s = state_->bodies.cold[body.index].first_shape; s != none;
         s = state_->shapes.shapes[s].next)
        shapes.push_back(shape_id(*state_, s));
    return shapes;
}

void World::copy_bodies(std::vector<BodyState>& out) const {
    out.clear();
    for (std::uint32_t i = 0; i < state_->bodies.ids.size(); i++)
        if (state_->bodies.ids.alive(i)) out.push_back(state_of(*state_, i));
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    for (std::uint32_t i = 0; i < state_->bodies.ids.size(); i++)
        if (state_->bodies.ids.alive(i)) ids.push_back(body_id(*state_, i));
    return ids;
}

Status World::set_pose(BodyId body, const Transform& pose) {
    WorldState& world = *state_;
    if (Status s = check_id(world, body); !s.ok()) return s;
    if (Status s = check_pose("pose", pose); !s.ok()) return s;
    if (world.def.planar)
        if (Status s = check_flat("pose", pose); !s.ok()) return s;
    wake_neighbours(world, body.index);
    BodyWarm& warm = stir(world, body.index);
    // A jump, not a motion: whatever touched it here does not touch it there.
    destroy_contacts_of(world, body.index, world.events.pending.ended);
    warm.rotation = unit(pose.rotation);
    warm.axes = to_matrix(warm.rotation);
    warm.center = pose.position + warm.axes * world.bodies.cold[body.index].local_center;
    touch_up(world, body.index);
    return {};
}

Status World::set_velocity(BodyId body, Vec3 linear, Vec3 angular) {
    WorldState& world = *state_;
    if (Status s = check_id(world, body); !s.ok()) return s;
    if (Status s = check_vector("linear", linear, limits::max_speed); !s.ok()) return s;
    if (Status s = check_vector("angular", angular, limits::max_speed); !s.ok()) return s;
    if (world.bodies.cold[body.index].type == BodyType::fixed)
        return Error{ErrorCode::failed_precondition,
                     "a fixed body has no velocity; make it kinematic instead"};
    // A platform that begins to move takes along what rests on it.
    if (world.bodies.cold[body.index].type == BodyType::kinematic)
        wake_neighbours(world, body.index);
    BodyWarm& warm = stir(world, body.index);
    warm.v = linear;
    warm.w = angular;
    obey_locks(world.bodies.cold[body.index], warm);
    speed_up(world, body.index);
    return {};
}

Status World::move_to(BodyId body, const Transform& pose, double dt) {
    WorldState& world = *state_;
    if (Status s = check_id(world, body); !s.ok()) return s;
    if (Status s = check_pose("pose", pose); !s.ok()) return s;
    if (Status s = check_range("dt", dt, 1e-5, 0.25); !s.ok()) return s;
    const BodyCold& cold = world.bodies.cold[body.index];
    if (cold.type != BodyType::kinematic)
        return Error{
            ErrorCode::failed_precondition,
            "body {" + std::to_string(body.index) + ", " + std::to_string(body.generation) +
                "} is not kinematic; move dynamic bodies by forces, fixed ones not at all"};
    const BodyWarm& warm = warm_of(world, body.index);
    const Quat q = unit(pose.rotation) * conjugate(warm.rotation);
    const Vec3 axis{q.x, q.y, q.z};
    const double l = length(axis), sign = q.w < 0 ? -1 : 1;  // the shorter way round
    const Vec3 turn = l > 1e-15 ? axis * (2 * sign * arc_tangent(l, q.w * sign) / l) : Vec3{};
    const Vec3 way = pose.position - warm.center;  // kinematic bodies turn about their origin
    return set_velocity(body, way * (1 / dt), turn * (1 / dt));
}

Status World::set_material(ShapeId shape, const Material& material) {
    WorldState& world = *state_;
    if (Status s = check_id(world, shape); !s.ok()) return s;
    if (Status s = check_material(material); !s.ok()) return s;
    ShapeRecord& record = world.shapes.shapes[shape.index];
    wake_neighbours(world, record.body);
    wake_body(world, record.body);
    // Manifolds hold what the two materials make together: they are built anew.
    destroy_contacts_of_shape(world, shape.index, world.events.pending.ended);
    record.material = material;
    buffer_move(world, shape.index);
    return {};
}

Status World::set_filter(ShapeId shape, const Filter& filter) {
    WorldState& world = *state_;
    if (Status s = check_id(world, shape); !s.ok()) return s;
    ShapeRecord& record = world.shapes.shapes[shape.index];
    wake_neighbours(world, record.body);
    wake_body(world, record.body);
    destroy_contacts_of_shape(world, shape.index, world.events.pending.ended);
    destroy_proxy(world, shape.index);
    record.filter = filter;
    create_proxy(world, shape.index);
    return {};
}

Status World::set_damping(BodyId body, double linear, double angular) {
    WorldState& world = *state_;
    if (Status s = check_id(world, body); !s.ok()) return s;
    if (Status s = check_range("linear", linear, 0, 1e4); !s.ok()) return s;
    if (Status s = check_range("angular", angular, 0, 1e4); !s.ok()) return s;
    wake_body(world, body.index);
    world.bodies.cold[body.index].linear_damping = linear;
    world.bodies.cold[body.index].angular_damping = angular;
    return {};
}

Status World::set_gravity_scale(BodyId body, double scale) {
    WorldState& world = *state_;
    if (Status s = check_id(world, body); !s.ok()) return s;
    if (Status s = check_range("scale", scale, -1e3, 1e3); !s.ok()) return s;
    wake_body(world, body.index);
    world.bodies.cold[body.index].gravity_scale = scale;
    update_motion_bound(world, body.index, look_ahead_dt(world));
    return {};
}

Status World::set_locks(BodyId body, AxisLocks locks) {
    WorldState& world = *state_;
    if (Status s = check_id(world, body); !s.ok()) return s;
    if (locks >= 64)
        return Error{ErrorCode::invalid_argument, "locks has bits beyond the six axes"};
    wake_neighbours(world, body.index);
    BodyWarm& warm = stir(world, body.index);
    destroy_contacts_of(world, body.index, world.events.pending.ended);
    world.bodies.cold[body.index].locks =
        static_cast<AxisLocks>(locks | (world.def.planar ? lock_z | lock_turn_x | lock_turn_y : 0));
    obey_locks(world.bodies.cold[body.index], warm);
    update_mass(world, body.index);
    touch_up(world, body.index);
    return {};
}

Status World::apply_impulse(BodyId body, Vec3 impulse, Vec3 point) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world, body); !s.ok()) return s;
    if (Status s = check_vector("impulse", impulse, 1e12); !s.ok()) return s;
    if (Status s = check_vector("point", point, limits::max_coordinate); !s.ok()) return s;
    const BodyCold& cold = world.bodies.cold[body.index];
    BodyWarm& warm = stir(world, body.index);
    warm.v += scaled(impulse, free_directions(cold)) * cold.inverse_mass;
    warm.w += world_inverse_inertia(warm, cold) * cross(point - warm.center, impulse);
    speed_up(world, body.index);
    return {};
}

Status World::apply_angular_impulse(BodyId body, Vec3 impulse) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world, body); !s.ok()) return s;
    if (Status s = check_vector("impulse", impulse, 1e12); !s.ok()) return s;
    BodyWarm& warm = stir(world, body.index);
    warm.w += world_inverse_inertia(warm, world.bodies.cold[body.index]) * impulse;
    speed_up(world, body.index);
    return {};
}

Status World::apply_force(BodyId body, Vec3 force, Vec3 point) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world, body); !s.ok()) return s;
    if (Status s = check_vector("force", force, 1e12); !s.ok()) return s;
    if (Status s = check_vector("point", point, limits::max_coordinate); !s.ok()) return s;
    BodyWarm& warm = stir(world, body.index);
    warm.force += force;
    warm.torque += cross(point - warm.center, force);
    update_motion_bound(world, body.index, look_ahead_dt(world));
    return {};
}

Status World::apply_torque(BodyId body, Vec3 torque) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world, body); !s.ok()) return s;
    if (Status s = check_vector("torque", torque, 1e12); !s.ok()) return s;
    stir(world, body.index).torque += torque;
    return {};
}

Status World::wake(BodyId body) {
    if (Status s = check_id(*state_, body); !s.ok()) return s;
    wake_body(*state_, body.index);
    return {};
}

}  // namespace jostle::physics
