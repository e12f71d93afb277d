// SPDX-License-Identifier: MIT
#include "modules/character/src/character_steps.h"

#include "modules/character/src/footing.h"
#include "modules/character/src/steering.h"

namespace jostle::modules::character_detail {
namespace {

using namespace physics;

constexpr double ground_gap_max = 0.01;         // m, largest gap at which it stands
constexpr double ground_probe_distance = 0.03;  // m
constexpr double lift_off_speed = 0.5;        // m/s: a lift may decelerate by this much in one step
constexpr double velocity_change_min = 1e-9;  // m/s: a smaller change must not keep the body awake

Footing find_ground(const World& world, CharacterData& self, const BodyState& body) {
    const EnvironmentQuery near = make_environment_query(world, self);
    const Vec3 center = self.feet + up * (0.5 * current_height(self));
    const auto contacts =
        near.contacts(capsule_of(self, current_height(self)), center, ground_probe_distance);
    Footing footing = find_footing(near, self, self.feet, contacts, ground_gap_max);
    if (footing.kind == GroundKind::in_air) return footing;
    const Vec3 ground = surface_velocity(world, footing.body, footing.shape, footing.point);
    if (dot(footing.normal, body.linear_velocity - ground) > lift_off_speed) return {};
    return footing;
}

void store_ground(const World& world, CharacterData& self, const Footing& footing, double dt) {
    self.ground = footing.kind;
    self.ground_body = footing.body;
    self.ground_shape = footing.shape;
    self.ground_normal = footing.normal;
    self.ground_point = footing.point;
    self.ground_velocity = {};
    const Result<BodyState> ground = world.body(footing.body);
    if (footing.kind == GroundKind::on_ground && ground.ok())
        self.ground_velocity = ground_velocity_at(world, *ground, footing.shape, self.feet, dt);
}

// Velocity change, m/s, along the floor. The horizontal velocity keeps the full desired speed on
// slopes.
Vec3 ground_velocity_change(const CharacterData& self, Vec3 velocity, Vec3 walk, double dt) {
    const Vec3 n = self.ground_normal, over = velocity - self.ground_velocity;
    Vec3 change = acceleration_step(over, walk, self.abilities.ground_acceleration, dt);
    const Vec3 next = horizontal(over + change);
    const double most = self.abilities.ground_acceleration * dt;
    change.y = clamp(-dot(horizontal(n), next) / n.y - over.y, -most, most);
    return change;
}

// Compensates the component of gravity along the floor by a force over the whole step: the feet
// hold the character.
void apply_holding_force(World& world, CharacterData& self, const BodyState& body, double dt) {
    const Vec3 n = self.ground_normal, gravity = world.gravity();
    const Vec3 along = gravity - n * dot(gravity, n);
    if (length(along) * dt < velocity_change_min) return;
    static_cast<void>(world.apply_force(self.body, along * -body.mass, body.center));
}

Vec3 air_velocity_change(const CharacterData& self, Vec3 velocity, Vec3 walk, double dt) {
    if (horizontal(walk) == Vec3{}) return {};
    Vec3 change = acceleration_step(velocity, walk, self.abilities.air_acceleration, dt);
    if (self.ground == GroundKind::on_steep_ground) {
        const Vec3 wall = normalized(horizontal(self.ground_normal), Vec3{});
        change -= wall * minimum(dot(change, wall), 0);
    }
    return change;
}

void turn_with_ground(const World& world, CharacterData& self, double dt) {
    const Result<BodyState> ground = world.body(self.ground_body);
    if (ground.ok()) turn_by(self, ground->angular_velocity.y * dt);
}

}  // namespace

void rigid_step(World& world, CharacterData& self, double dt) {
    self.applied_impulse = {};
    const Result<BodyState> body = world.body(self.body);
    if (!body.ok()) return;
    const CharacterControls controls = current_controls(self, dt);
    self.feet = body->pose.position - up * self.foot_height;
    update_crouch(world, self, controls.crouch);
    const Vec3 velocity = body->linear_velocity;
    store_ground(world, self, find_ground(world, self, *body), dt);
    Vec3 change;
    if (should_jump(self, controls.jump)) {
        // Jumps relative to the moving ground, but not relative to ground that is knocked away.
        const double from = clamp(self.ground_velocity.y - velocity.y, -1, 1);
        change.y = self.abilities.jump_speed + from;
        self.ground = GroundKind::in_air;
    } else if (self.ground == GroundKind::on_ground) {
        change = ground_velocity_change(self, velocity, controls.walk, dt);
        apply_holding_force(world, self, *body, dt);
        turn_with_ground(world, self, dt);
    } else {
        change = air_velocity_change(self, velocity, controls.walk, dt);
    }
    turn_to_walk_direction(self, controls.walk, dt);
    if (length(change) < velocity_change_min) return;
    const Vec3 impulse = change * body->mass;
    static_cast<void>(world.apply_impulse(self.body, impulse, body->center));
    apply_ground_impulse(world, self, -impulse);
}

}  // namespace jostle::modules::character_detail
