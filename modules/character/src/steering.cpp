// SPDX-License-Identifier: MIT
#include "modules/character/src/steering.h"

#include "modules/character/src/environment_query.h"

namespace jostle::modules::character_detail {

using namespace physics;

namespace {

constexpr double turn_speed = 12;  // rad/s

double wrapped(double angle) {
    return angle - 2 * pi * std::floor((angle + pi) / (2 * pi));
}

}  // namespace

CharacterControls current_controls(CharacterData& record, double dt) {
    CharacterControls controls = record.controls;
    if (record.stroll <= 0) return controls;
    record.stroll_angle = wrapped(record.stroll_angle + record.stroll_turn * dt);
    const SinCos turn = sin_cos(record.stroll_angle);
    controls.walk = Vec3{-turn.sin, 0, -turn.cos} * record.stroll;
    return controls;
}

Vec3 acceleration_step(Vec3 velocity, Vec3 desired, double acceleration, double dt) {
    const Vec3 change = horizontal(desired - velocity);
    const double size = length(change), most = acceleration * dt;
    return size > most ? change * (most / size) : change;
}

bool should_jump(CharacterData& record, bool jump) {
    const bool off = jump && record.jump_armed && record.ground == GroundKind::on_ground;
    record.jump_armed = !jump || (record.jump_armed && !off);
    return off;
}

void turn_to_walk_direction(CharacterData& record, Vec3 walk, double dt) {
    if (length_squared(horizontal(walk)) < 1e-6) return;
    const double off = wrapped(arc_tangent(-walk.x, -walk.z) - record.heading);
    const double most = turn_speed * dt;
    turn_by(record, clamp(off, -most, most));
}

void turn_by(CharacterData& record, double angle) {
    record.heading = wrapped(record.heading + angle);
}

// Replaces the first shape by the capsule of the current height. The feet do not move.
void update_shape(World& world, const CharacterData& record) {
    std::vector<ShapeDef> shapes;
    for (const ShapeId id : world.shapes_of(record.body))
        if (const auto shape = world.shape(id); shape.ok()) shapes.push_back(def_of(*shape));
    const Result<BodyState> body = world.body(record.body);
    if (shapes.empty() || !body.ok()) return;
    const double height = current_height(record);
    shapes[0].geometry = capsule_of(record, height);
    shapes[0].pose.position.y = 0.5 * height - record.foot_height;
    if (body->type == BodyType::dynamic && shapes.size() == 1) shapes[0].mass = body->mass;
    static_cast<void>(world.set_shapes(record.body, shapes));
}

void update_crouch(World& world, CharacterData& record, bool crouch) {
    if (crouch == record.crouched) return;
    if (!crouch) {
        const Capsule tall = capsule_of(record, record.height);
        // Slightly above the floor, which a rigid character touches.
        const Vec3 center = record.feet + up * (0.5 * record.height + 0.005);
        if (!make_environment_query(world, record).is_free(tall, center)) return;
    }
    record.crouched = crouch;
    update_shape(world, record);
}

Vec3 ground_velocity_at(const World& world, const BodyState& ground, ShapeId shape, Vec3 point,
                        double dt) {
    Vec3 belt;
    if (const auto surface = world.shape(shape); surface.ok())
        belt = rotate(ground.pose.rotation, surface->material.surface_velocity);
    const Vec3 arm = point - ground.center;
    const Vec3 turned = rotate(from_rotation_vector(ground.angular_velocity * dt), arm);
    return ground.linear_velocity + belt + (turned - arm) * (1 / dt);
}

void apply_ground_impulse(World& world, CharacterData& record, Vec3 impulse) {
    const Result<BodyState> ground = world.body(record.ground_body);
    if (!ground.ok() || ground->type != BodyType::dynamic) return;
    if (world.apply_impulse(record.ground_body, impulse, record.ground_point).ok())
        record.applied_impulse += impulse;
}

// The support of the ground resists tilting, so only its mass counts.
Vec3 push_off(World& world, CharacterData& record, Vec3 change) {
    const double mass = record.abilities.mass;
    const Result<BodyState> ground = world.body(record.ground_body);
    if (!ground.ok() || ground->type != BodyType::dynamic) return change;
    const double give = 1 / (1 / mass + 1 / ground->mass);
    apply_ground_impulse(world, record, change * -give);
    return change * (give / mass);
}

Quat orientation(const CharacterData& record) {
    return from_rotation_vector(up * record.heading);
}

}  // namespace jostle::modules::character_detail
