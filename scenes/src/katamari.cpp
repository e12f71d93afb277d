// SPDX-License-Identifier: MIT
#include "scenes/src/katamari.h"

#include <cmath>

#include "jostle/modules/settings.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr double half_yard = 11;  // m from the centre; the player stays within it
constexpr double eagerness = 4;   // 1/s, rate at which it approaches the target speed
constexpr double jump_speed = 5;  // m/s
constexpr double player_half = 0.75;

}  // namespace

void Katamari::visit(StateVisitor& v) {
    v.field("player", player_);
    modules::bounded(v, "speed", speed_, 0, 20);
    modules::bounded(v, "reach", reach_, 0.1, 20);
    modules::bounded(v, "pull", pull_, 0, 100);
    v.field("random", random_);
    modules::bounded(v, "until", decision_end_, 0, 1e12);
    modules::bounded(v, "heading", heading_, -1e3, 1e3);
    v.field("jumps", jumps_);
}

Status Katamari::configure(World& world, const ModuleSettings& given) {
    double seed = 1;
    modules::SettingsReader settings(given);
    settings.number("seed", seed, 0, 4294967295.0);
    settings.number("speed", speed_, 0, 20);
    settings.number("reach", reach_, 0.1, 20);
    settings.number("pull", pull_, 0, 100);
    settings.body("player", player_);
    if (Status read = settings.finish(); !read.ok()) return read;
    random_ = static_cast<std::uint32_t>(seed);
    const Result<BodyState> player = world.body(player_);
    if (!player.ok())
        return Error{ErrorCode::invalid_argument, "has no body \"player\"; it is required"};
    if (player->type != BodyType::dynamic)
        return Error{ErrorCode::invalid_argument,
                     "player is not dynamic; it must be a dynamic body"};
    return world.set_sleep_allowed(player_, false);
}

double Katamari::random_in(double low, double high) {
    random_ = random_ * 1664525u + 1013904223u;
    return low + (high - low) * (random_ >> 8) / 16777216.0;
}

void Katamari::decide(Vec3 position, double now) {
    // Back to the centre from the edge, otherwise in any direction.
    const bool outside = std::abs(position.x) > half_yard || std::abs(position.z) > half_yard;
    heading_ =
        outside ? arc_tangent(-position.z, -position.x) + random_in(-0.5, 0.5) : random_in(-pi, pi);
    decision_end_ = now + random_in(0.6, 2.5);
    jumps_ = random_in(0, 1) < 0.35;
}

void Katamari::before_step(World& world, double) {
    const Result<BodyState> player = world.body(player_);
    if (!player.ok()) return;
    const Vec3 at = player->center;
    if (world.time() >= decision_end_) decide(at, world.time());
    const SinCos direction = sin_cos(heading_);
    Vec3 velocity_error = Vec3{direction.cos, 0, direction.sin} * speed_ - player->linear_velocity;
    velocity_error.y = 0;
    // Applied above the centre, so that the player tumbles instead of sliding.
    static_cast<void>(world.apply_force(player_, velocity_error * (eagerness * player->mass),
                                        at + Vec3{0, 0.5 * player_half, 0}));
    if (jumps_ && at.y < 1.5 * player_half) {
        jumps_ = false;
        static_cast<void>(world.apply_impulse(player_, {0, jump_speed * player->mass, 0}, at));
    }
    world.copy_bodies(bodies_);
    for (const BodyState& body : bodies_) {
        const Vec3 away = body.center - at;
        if (body.id == player_ || body.type != BodyType::dynamic ||
            dot(away, away) > reach_ * reach_)
            continue;
        const double far = length(away);
        if (far < 1e-6) continue;
        static_cast<void>(
            world.apply_force(body.id, away * (-pull_ * body.mass / far), body.center));
    }
}

SceneDescription katamari() {
    SceneDescription scene{.bodies = {ground()}};
    for (int z = 0; z < 30; z++)
        for (int x = 0; x < 30; x++)
            scene.bodies.push_back(
                colored(dynamic_body("cube", {0.8 * (x - 14.5), 0.2, 0.8 * (z - 14.5)},
                                     Box{{0.2, 0.2, 0.2}}),
                        (x + z) % 2 == 0 ? 0xf2cc8f : 0x81b29a));
    scene.bodies.push_back(colored(dynamic_body("player", {0, player_half + 2, 0},
                                                Box{{player_half, player_half, player_half}}),
                                   0xe07a5f));
    scene.modules.push_back({.tag = "katamari",
                             .settings = {{"seed", 2026}, {"reach", 4}, {"speed", 3}},
                             .bodies = {{"player", scene.bodies.size() - 1}},
                             .state = {}});
    return scene;
}

}  // namespace jostle::scenes
