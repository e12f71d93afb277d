// SPDX-License-Identifier: MIT
//
// C1 to C4 and C16: one body that rolls, sticks or slides. Never along a world axis, where a
// friction pyramid would look like a cone.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

const Vec3 heading = azimuth(pi / 6);

Vec3 flat(Vec3 v) {
    return {v.x, v.y, 0};
}

// Slides until the velocity of the contact point is zero, at 2 v0 / (7 mu g); then rolls at 5/7 v0.
ExperimentRun roll(double) {
    const double speed = 5, friction = 0.3, seconds = 2;
    Scene scene{.name = "c1", .friction = friction};
    Body ball = solid_sphere(1, 0.1, {0, 0, 0.1});
    ball.velocity = heading * speed;
    scene.bodies = {ball, fixed_plane()};
    const double slides = 2 * speed / (7 * friction * g), rolling = 5.0 / 7 * speed;
    const double travelled =
        speed * slides - 0.5 * friction * g * slides * slides + rolling * (seconds - slides);
    auto meter = last_meter([=](double, const Engine& engine) {
        const BodyState now = engine.state(0);
        return Errors{length(flat(now.position) - heading * travelled) / travelled,
                      length(flat(now.velocity) - heading * rolling) / rolling};
    });
    return {std::move(scene), seconds, std::move(meter)};
}

// Gravity is tilted instead of the plane.
Scene tilted(const char* name, double friction) {
    const double slope = std::atan(0.3);
    Scene scene{.name = name, .friction = friction};
    scene.gravity = heading * (g * std::sin(slope)) - Vec3{0, 0, g * std::cos(slope)};
    scene.bodies = {solid_box(1, {0.5, 0.5, 0.25}, {0, 0, 0.25}), fixed_plane()};
    return scene;
}

ExperimentRun stick(double) {
    auto meter = last_meter([](double, const Engine& engine) {
        const Vec3 at = engine.state(0).position;
        return Errors{length(flat(at)), std::abs(at.z - 0.25)};
    });
    return {tilted("c2", 0.5), 5, std::move(meter)};
}

ExperimentRun slide(double) {
    const double slope = std::atan(0.3), seconds = 2;
    const double acceleration = g * (std::sin(slope) - 0.2 * std::cos(slope));
    const double travelled = 0.5 * acceleration * seconds * seconds;
    auto meter = last_meter([=](double t, const Engine& engine) {
        const Vec3 at = engine.state(0).position;
        const Vec3 truth = heading * (0.5 * acceleration * t * t);
        return Errors{length(flat(at) - truth) / travelled, std::abs(at.z - 0.25)};
    });
    return {tilted("c3", 0.2), seconds, std::move(meter)};
}

ExperimentRun stop(double) {
    const double speed = 5, friction = 0.4, travelled = speed * speed / (2 * friction * g);
    Scene scene{.name = "c4", .friction = friction};
    Body box = solid_box(1, {0.5, 0.5, 0.05}, {0, 0, 0.05});
    box.velocity = heading * speed;
    scene.bodies = {box, fixed_plane()};
    auto meter = last_meter([=](double, const Engine& engine) {
        const Vec3 at = engine.state(0).position;
        return Errors{length(flat(at) - heading * travelled) / travelled, std::abs(at.z - 0.05)};
    });
    return {std::move(scene), 2, std::move(meter)};
}

// Steady rolling of a thin disk whose centre rests: Om^2 = 4 g / (R sin tilt). The spin points
// along the radius to the contact point, so both that point and the centre are at rest.
ExperimentRun euler_disk(double) {
    const double radius = 0.1, half_height = 0.005, tilt = 20 * pi / 180;
    Scene scene{.name = "c16", .friction = 1};
    const double rate = std::sqrt(4 * g / (radius * std::sin(tilt)));
    const double height = radius * std::sin(tilt) + half_height * std::cos(tilt);
    Body disk = solid_cylinder(1, radius, half_height, {0, 0, height});
    // The cylinder's y axis is rotated upright, then tilted towards +x, where its lowest point is.
    disk.pose.rotation =
        physics::from_axis_angle({0, 1, 0}, tilt) * physics::from_axis_angle({1, 0, 0}, 0.5 * pi);
    disk.spin = Vec3{std::cos(tilt), 0, -std::sin(tilt)} * (-rate * std::sin(tilt));
    scene.bodies = {disk, fixed_plane()};
    auto meter = last_meter([=](double, const Engine& engine) {
        const Vec3 axis = rotate(engine.state(0).rotation, {0, 1, 0});
        const double found = std::atan2(std::hypot(axis.x, axis.y), std::abs(axis.z));
        return Errors{std::abs(found - tilt), 0};
    });
    return {std::move(scene), 2, std::move(meter)};
}

}  // namespace

std::vector<Experiment> friction_experiments() {
    return {
        {.name = "c1",
         .about = "a sliding ball starts to roll, 2 s",
         .measures = "position error at the end / distance travelled; relative error of the speed",
         .tolerances = {0.01, 0.001, 1e-4},
         .start = roll},
        {.name = "c2",
         .about = "a box sticks to a slope for 5 s",
         .measures = "creep, m; sink, m",
         .tolerances = {0.001, 1e-5, 1e-7},
         .start = stick,
         .short_max_hz = 480},
        {.name = "c3",
         .about = "a box slides down a slope for 2 s",
         .measures = "position error at the end / distance travelled; sink, m",
         .tolerances = {0.01, 0.001, 1e-4},
         .start = slide},
        {.name = "c4",
         .about = "a sliding box stops",
         .measures = "position error at the end / distance travelled; sink, m",
         .tolerances = {0.01, 0.001, 1e-4},
         .start = stop},
        {.name = "c16",
         .about = "a disk rolls round on its rim for 2 s, friction 1",
         .measures = "drift of the tilt, rad; none",
         .tolerances = {0.1, 0.01, 0.001},
         .start = euler_disk},
    };
}

}  // namespace jostle::bench::accuracy
