// SPDX-License-Identifier: MIT
#include "scenes/src/asteroids.h"

#include <algorithm>
#include <cmath>

#include "jostle/modules/settings.h"
#include "jostle/physics/hull.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr double radius_of_1000 = 50;   // m, of the sphere of 1000 asteroids
constexpr double planetoid_radius = 5;  // m
// Few different sizes, which share their shapes.
constexpr double scale_min = 0.25, scale_step = 0.05;
constexpr int scales = 16;
constexpr double asteroid_radius = 0.9;  // m, at a scale of 1
constexpr double clearance = 2;          // m, at a scale of 1: no other surface is closer at first
constexpr double spin_max = pi / 4;      // rad/s
constexpr double speed_min = 1, speed_max = 4;  // m/s
constexpr double speed_tolerance = 1e-3;        // m^2/s^2, of the squared speed

// A vector with the length 0 to 1; every direction is equally likely.
Vec3 random_in_ball(Random& random) {
    for (;;) {
        const double x = random.in(-1, 1), y = random.in(-1, 1), z = random.in(-1, 1);
        const Vec3 v{x, y, z};
        if (dot(v, v) <= 1 && dot(v, v) > 1e-6) return v;
    }
}

// A regular icosahedron. Its inertia is the same about every axis, so its angular velocity is
// constant between collisions, as in the benchmark, whose engine has no gyroscopic forces.
Geometry rock(double radius) {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<Vec3> corners;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-golden, golden})
            for (const Vec3& corner : {Vec3{0, a, b}, Vec3{a, b, 0}, Vec3{b, 0, a}})
                corners.push_back(corner * (radius / length(corner)));
    return Hull{*build_hull(corners)};
}

struct Ball {
    Vec3 center;
    double radius = 0;
};

bool overlaps(const Ball& ball, const std::vector<Ball>& others) {
    return std::ranges::any_of(others, [&](const Ball& other) {
        const double reach = ball.radius + other.radius;
        const Vec3 apart = ball.center - other.center;
        return dot(apart, apart) < reach * reach;
    });
}

SceneBody asteroid(Random& random, double field_radius, std::vector<Ball>& placed) {
    const double scale = scale_min + scale_step * std::floor(random.in(0, scales));
    Ball space{random_in_ball(random) * field_radius, clearance * scale};
    const Vec3 outwards = space.center * (1 / length(space.center));
    while (overlaps(space, placed)) space.center += outwards * space.radius;
    placed.push_back({space.center, asteroid_radius * scale});
    const Quat rotation = from_axis_angle(random_in_ball(random), random.in(0, 2 * pi));
    SceneBody body =
        dynamic_body("asteroid", space.center, rock(asteroid_radius * scale), rotation);
    body.body.mass = scale * scale * scale;
    body.body.angular_velocity = random_in_ball(random) * spin_max;
    const Vec3 direction = random_in_ball(random);
    body.body.linear_velocity = direction * (random.in(speed_min, speed_max) / length(direction));
    body.body.sleep_allowed = false;
    body.shapes[0].material.friction = 0.6;
    return colored(body, 0x8d8071);
}

SceneDescription asteroid_field(int count) {
    SceneDescription scene;
    scene.world.gravity = {};
    const double radius = radius_of_1000 * std::cbrt(count / 1000.0);
    SceneBody planetoid{.name = "planetoid",
                        .body = {.type = BodyType::static_body},
                        .shapes = {{.geometry = Sphere{planetoid_radius}}},
                        .color = 0xb5651d};
    scene.bodies.push_back(planetoid);
    Random random(2323);
    std::vector<Ball> placed = {{{}, planetoid_radius}};
    for (int k = 0; k < count; k++) scene.bodies.push_back(asteroid(random, radius, placed));
    scene.modules.push_back(
        {.tag = "asteroids", .settings = {{"radius", radius}}, .bodies = {}, .state = {}});
    return scene;
}

}  // namespace

void Asteroids::visit(StateVisitor& v) {
    modules::bounded(v, "radius", radius_, 1, 1e5);
    modules::bounded(v, "acceleration", acceleration_, 0, 1000);
    modules::bounded(v, "return_acceleration", return_acceleration_, 0, 1000);
    v.all("targets", targets_, [&](Target& target) {
        v.field("body", target.body);
        modules::bounded(v, "speed", target.speed, 0, 1e5);
    });
}

Status Asteroids::configure(World& world, const ModuleSettings& given) {
    modules::SettingsReader settings(given);
    settings.number("radius", radius_, 1, 1e5);
    settings.number("acceleration", acceleration_, 0, 1000);
    settings.number("return_acceleration", return_acceleration_, 0, 1000);
    if (Status read = settings.finish(); !read.ok()) return read;
    std::vector<BodyState> bodies;
    world.copy_bodies(bodies);
    for (const BodyState& body : bodies)
        if (body.type == BodyType::dynamic)
            targets_.push_back({body.id, length(body.linear_velocity)});
    return {};
}

void Asteroids::steer(World& world, const BodyState& body, double speed, double dt) {
    const Vec3 at = body.pose.position, velocity = body.linear_velocity;
    if (dot(at, at) > radius_ * radius_) {
        const Vec3 inwards = at * (-return_acceleration_ * dt / length(at));
        static_cast<void>(world.set_linear_velocity(body.id, velocity + inwards));
        return;
    }
    const double squared = dot(velocity, velocity);
    if (std::abs(squared - speed * speed) <= speed_tolerance || squared < 1e-12) return;
    const double now = std::sqrt(squared), step = acceleration_ * dt;
    const double next = now < speed ? std::min(now + step, speed) : std::max(now - step, speed);
    static_cast<void>(world.set_linear_velocity(body.id, velocity * (next / now)));
}

void Asteroids::before_step(World& world, double dt) {
    for (const Target& target : targets_)
        if (const Result<BodyState> body = world.body(target.body); body.ok())
            steer(world, *body, target.speed, dt);
}

SceneDescription asteroids() {
    return asteroid_field(250);
}
SceneDescription asteroids_1000() {
    return asteroid_field(1000);
}
SceneDescription asteroids_10000() {
    return asteroid_field(10000);
}

}  // namespace jostle::scenes
