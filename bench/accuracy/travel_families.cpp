// SPDX-License-Identifier: MIT
//
// Families of bodies on rotating platforms, of bodies that pass triggers, and of bodies that cannot
// rotate.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/row_family.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;
using Scale = Parameter::Scale;

// Displacement of body 0 along the surface of the platform, body 1.
ExperimentRun carousel(const Values& v) {
    const double radius = v["radius"], friction = v["friction"], half = v["half"];
    const double rate = std::sqrt(v["share"] * friction * g / radius);
    const Vec3 travel = azimuth(v["heading"] * pi / 180) * v["travel"];
    const Vec3 spin{0, 0, v.choice("sense") == "left" ? rate : -rate};
    Scene scene{.name = "carousel", .friction = friction};
    Body box = solid_box(1, {half, half / v["aspect"], half / v["aspect"]},
                         {radius, 0, half / v["aspect"]});
    const Vec3 start = box.pose.position;
    box.pose.rotation = physics::from_axis_angle({0, 0, 1}, v["yaw"] * pi / 180);
    box.velocity = travel + cross(spin, start);
    box.spin = spin;
    Body platform = fixed_box({radius + 2, radius + 2, 0.5}, {0, 0, -0.5});
    platform.motion = Motion::kinematic;
    platform.velocity = travel;
    platform.spin = spin;
    scene.bodies = {std::move(box), std::move(platform)};
    auto meter = last_meter([=](double t, const Engine& engine) {
        const Vec3 place = physics::inverse_rotate(physics::from_axis_angle({0, 0, 1}, spin.z * t),
                                                   engine.state(0).position - travel * t);
        return Errors{std::hypot(place.x - start.x, place.y - start.y),
                      std::abs(place.z - start.z)};
    });
    return {std::move(scene), 4, std::move(meter)};
}

// Balls side by side fly through a plate, each at its own distance.
ExperimentRun gate(const Values& v, double shift) {
    constexpr int balls = 8;
    const double radius = v["radius"], speed = v["speed"], slant = v["slant"] * pi / 180;
    const Vec3 forward = Vec3{std::cos(slant), 0, std::sin(slant)};
    Scene scene{.name = "gate", .gravity = {}};
    const double distance = 0.5 * speed * 0.4;
    for (int k = 0; k < balls; k++) {
        const double away = distance * (0.8 + 0.4 * k / balls) + speed * shift;
        Body ball = solid_sphere(1, radius, forward * -away + Vec3{0, 3 * radius * (k - 3.5), 0});
        ball.velocity = forward * speed;
        scene.bodies.push_back(std::move(ball));
    }
    Body plate = fixed_box({0.5 * v["thickness"], 50 * radius, 50 * radius}, {});
    plate.trigger = true;
    scene.bodies.push_back(std::move(plate));
    auto meter = last_meter([](double, const Engine& engine) {
        const TriggerCounts counts = engine.trigger_counts();
        return Errors{std::abs(counts.entered - balls) / double{balls},
                      std::abs(counts.left - balls) / double{balls}};
    });
    return {std::move(scene), 0.4, std::move(meter)};
}

void set_freedom(Scene& scene, Body& body, const std::string& freedom) {
    body.rotation_locked = freedom == "locked";
    scene.planar_world = scene.planar = freedom == "planar";
}

ExperimentRun fall(const Values& v) {
    Scene scene{.name = "fall"};
    Body body = solid_box(1, Vec3{1, 1, 1} * v["half"], {});
    set_freedom(scene, body, v.choice("freedom"));
    body.velocity = {v["speed"], 0, v["up"]};
    if (v.choice("freedom") != "locked") body.spin = {0, v["spin"], 0};
    const Vec3 velocity = body.velocity;
    scene.bodies = {std::move(body)};
    auto meter = last_meter([velocity](double t, const Engine& engine) {
        const Vec3 truth = velocity * t - Vec3{0, 0, 0.5 * g * t * t};
        return Errors{length(engine.state(0).position - truth), 0};
    });
    return {std::move(scene), 2, std::move(meter)};
}

// A box slides to a stop.
ExperimentRun level(const Values& v) {
    const double friction = v["friction"], speed = v["speed"], half = v["half"];
    Scene scene{.name = "level", .friction = friction};
    Body body = solid_box(1, {2 * half, 2 * half, half}, {0, 0, half});
    set_freedom(scene, body, v.choice("freedom"));
    body.velocity = {speed, 0, 0};
    scene.bodies = {std::move(body), fixed_plane()};
    const double path = speed * speed / (2 * friction * g);
    auto meter = last_meter([=](double, const Engine& engine) {
        const Vec3 at = engine.state(0).position;
        return Errors{std::abs(at.x - path) / path, std::abs(at.z - half)};
    });
    return {std::move(scene), speed / (friction * g) + 0.3, std::move(meter)};
}

const Parameter freedom_range{.name = "freedom", .choices = {"free", "locked", "planar"}};

}  // namespace

std::vector<RowFamily> travel_families() {
    return {
        {.name = "carousel",
         .about = "a box rides on a rotating platform for 4 s",
         .measures = "drift on the platform, m; sink, m",
         .tolerances = {0.01, 0.001, 1e-4},
         .parameters = {{"radius, m", 0.3, 20, Scale::logarithmic},
                        {"share", 0.02, 0.25},  // of the friction limit
                        {.name = "sense", .choices = {"left", "right"}},
                        {"friction", 0.2, 0.9},
                        {"half, m", 0.1, 0.4},
                        {"aspect", 1, 3},
                        {"yaw, deg", 0, 180},
                        {"heading, deg", 0, 360},
                        {"travel, m/s", 0, 2}},
         .examples = {{2, 0.25, 0, 0.5, 0.5, 1, 0, 0, 0}},
         .drawn = 5,
         .limit = 0.001,
         .start = [](const Values& v, double) { return carousel(v); }},
        {.name = "gate",
         .about = "eight balls fly through a trigger",
         .measures = "share of missed entries; of missed exits",
         .tolerances = {0.01},
         .parameters = {{"speed, m/s", 5, 200, Scale::logarithmic},
                        {"thickness, m", 0.005, 0.2, Scale::logarithmic},
                        {"radius, m", 0.02, 0.2, Scale::logarithmic},
                        {"slant, deg", -60, 60}},
         .examples = {{200, 0.05, 0.05, 0}},
         .limit = 1e-9,
         .second_limit = 1e-9,
         .phases = 16,
         .start = gate},
        {.name = "fall",
         .about = "a box in free fall",
         .measures = "position error at the end, m; none",
         .tolerances = {0.1, 0.001, 1e-6},
         .parameters = {freedom_range,
                        {"half, m", 0.05, 0.5},
                        {"speed, m/s", 0, 20},
                        {"up, m/s", -10, 10},
                        {"spin, rad/s", 0, 10}},
         .drawn = 3,
         .limit = 1e-9,
         .start = [](const Values& v, double) { return fall(v); }},
        {.name = "level",
         .about = "a box that may not rotate slides to a stop",
         .measures = "position error at the end / path; sink, m",
         .tolerances = {0.02, 0.002, 2e-4},
         .parameters =
             {freedom_range, {"half, m", 0.05, 0.5}, {"friction", 0.2, 0.7}, {"speed, m/s", 2, 8}},
         .drawn = 3,
         .limit = 0.02,
         .start = [](const Values& v, double) { return level(v); }},
    };
}

}  // namespace jostle::bench::accuracy
