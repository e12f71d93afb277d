// SPDX-License-Identifier: MIT
//
// S22: invalid and extreme numbers. Jostle rejects numbers that are not finite, zero where zero is
// invalid, or out of range; numbers that it accepts must not affect other bodies. The peers make no
// such promise and are not tested.
#include <cmath>
#include <limits>
#include <utility>

#include "bench/accuracy/stress_test.h"
#include "jostle/physics/world.h"

namespace jostle::bench::accuracy {
namespace {

using physics::BodyDef;
using physics::Box;
using physics::ShapeDef;
using physics::Sphere;
using physics::World;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double denormal = 1e-310;

struct Input {
    BodyDef body;
    ShapeDef shape;
};

// Inputs that must be rejected.
std::vector<Input> refusable() {
    std::vector<Input> all;
    for (const double bad : {not_a_number, infinite, -infinite}) {
        all.push_back({.body = {.pose = {{bad, 0, 0}, {}}}});
        all.push_back({.body = {.pose = {{}, {bad, 0, 0, 1}}}});
        all.push_back({.body = {.linear_velocity = {0, bad, 0}}});
        all.push_back({.body = {.angular_velocity = {0, 0, bad}}});
        all.push_back({.body = {.linear_damping = bad}});
        all.push_back({.body = {.gravity_scale = bad}});
        all.push_back({.body = {.mass = bad}});
        all.push_back({.shape = {.geometry = Sphere{bad}}});
        all.push_back({.shape = {.geometry = Box{{1, bad, 1}}}});
        all.push_back({.shape = {.pose = {{bad, 0, 0}, {}}}});
        all.push_back({.shape = {.material = {.friction = bad}}});
        all.push_back({.shape = {.material = {.restitution = bad}}});
        all.push_back({.shape = {.density = bad}});
        all.push_back({.shape = {.mass = bad}});
    }
    for (const double bad : {0.0, -1.0, denormal}) {
        all.push_back({.shape = {.geometry = Sphere{bad}}});
        all.push_back({.shape = {.geometry = Box{{1, 1, bad}}}});
        all.push_back({.shape = {.density = bad}});
    }
    all.push_back({.body = {.pose = {{}, {0, 0, 0, 0}}}});
    all.push_back({.body = {.mass = -1}});
    return all;
}

// Inputs that may be accepted but must not affect other bodies.
std::vector<Input> odd() {
    return {{.body = {.linear_velocity = {denormal, 0, 0}}},
            {.body = {.angular_velocity = {denormal, denormal, denormal}}},
            {.body = {.pose = {{denormal, 0, 0}, {denormal, 0, 0, 1}}}},
            {.body = {.linear_damping = denormal, .gravity_scale = denormal}},
            {.body = {.mass = denormal}},
            {.shape = {.material = {.friction = denormal, .restitution = denormal}}}};
}

int accepted_count(World& world) {
    int count = 0;
    for (const Input& input : refusable()) count += world.create_body(input.body, input.shape).ok();
    for (const double bad : {not_a_number, infinite, 0.0, -1.0, denormal})
        count += world.step(bad).ok();
    for (const double bad : {not_a_number, infinite}) {
        count += world.set_gravity({0, bad, 0}).ok();
        count += World::create({.gravity = {bad, 0, 0}}).ok();
    }
    return count;
}

// A resting box next to bodies with extreme values moves as if they were absent.
bool harmless(const Input& input) {
    World world;
    const auto floor =
        world.create_body({.type = physics::BodyType::static_body}, {.geometry = physics::Plane{}});
    const auto box =
        world.create_body({.pose = {{0, 0.5, 0}, {}}, .sleep_allowed = false}, ShapeDef{});
    Input beside = input;
    beside.body.pose.position.x += 5;
    beside.body.pose.position.y += 0.5;
    if (!floor || !box || !world.create_body(beside.body, beside.shape)) return true;
    for (int k = 0; k < 60; k++)
        if (!world.step(1.0 / 60)) return false;
    std::vector<physics::BodyState> bodies;
    world.copy_bodies(bodies);
    for (const physics::BodyState& body : bodies)
        if (!is_finite(body.center) || !is_finite(body.pose.rotation) ||
            !is_finite(body.linear_velocity) || !is_finite(body.angular_velocity))
            return false;
    return length(world.body(*box)->center - Vec3{0, 0.5, 0}) < 1e-3;
}

Verdict inputs(const EngineKind& kind, const std::string&) {
    if (std::string(kind.name) != "jostle") return {.unsupported = "tested with jostle only"};
    World world;
    int bad = accepted_count(world);
    for (const Input& input : odd()) bad += !harmless(input);
    return {.pass = bad == 0, .figure = static_cast<double>(bad)};
}

}  // namespace

std::vector<StressTest> input_stress_tests() {
    return {{.id = "s22",
             .about = "NaN, infinities, zeros and denormals as inputs",
             .figure = "accepted inputs that affect other bodies",
             .limit = 1,
             .run = inputs}};
}

}  // namespace jostle::bench::accuracy
