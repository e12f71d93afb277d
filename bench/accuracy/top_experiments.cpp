// SPDX-License-Identifier: MIT
//
// F5, F6 and J9: bodies that precess about a fixed point.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

// A centre that moves on a cone.
PointInTime on_cone(double arm, double tilt, double rate, double height_sign) {
    return [=](double t) {
        const Vec3 along = azimuth(rate * t) * std::sin(tilt);
        return (along + Vec3{0, 0, height_sign * std::cos(tilt)}) * arm;
    };
}

struct Top {
    Body body;
    Vec3 axis;
    double precession;
};

// Steady precession: I1 cos(tilt) Om^2 - I3 w3 Om + m g l = 0 with the pivot's I1, the slow root.
Top heavy_top() {
    const double tilt = pi / 3, arm = 0.5, spin = 40, moment = 0.1, across = 0.05 + arm * arm;
    const double momentum = moment * spin;
    const double rate =
        (momentum - std::sqrt(momentum * momentum - 4 * across * std::cos(tilt) * g * arm)) /
        (2 * across * std::cos(tilt));
    Top top{.body = {.mass = 1, .inertia = {0.05, 0.05, moment}},
            .axis = {std::sin(tilt), 0, std::cos(tilt)},
            .precession = rate};
    top.body.pose = {top.axis * arm, physics::from_axis_angle({0, 1, 0}, tilt)};
    top.body.spin = Vec3{0, 0, rate} + top.axis * (spin - rate * std::cos(tilt));
    top.body.velocity = cross(top.body.spin, top.body.pose.position);
    return top;
}

ExperimentRun top_on_ball_joint(double) {
    const Top top = heavy_top();
    Scene scene{.name = "f5"};
    scene.bodies = {top.body};
    scene.joints = {ball_at(ground, 0, {})};
    auto meter = track_meter(scene, 0, on_cone(0.5, pi / 3, top.precession, 1), 0.5, 0.5);
    return {std::move(scene), 5, std::move(meter)};
}

// The rings have a mass of 1 g each: enough for engines that divide by mass, negligible for the
// top.
ExperimentRun top_in_gimbals(double) {
    const Top top = heavy_top();
    Scene scene{.name = "j9"};
    Body ring = without_shape(solid_box(1e-3, {0.1, 0.1, 0.1}, {}));
    ring.spin = {0, 0, top.precession};
    scene.bodies = {top.body, ring, ring};
    scene.joints = {hinge_at(ground, 2, {}, {0, 0, 1}), hinge_at(2, 1, {}, {0, 1, 0}),
                    hinge_at(1, 0, {}, top.axis)};
    auto meter = track_meter(scene, 0, on_cone(0.5, pi / 3, top.precession, 1), 0.5, 0.5);
    return {std::move(scene), 5, std::move(meter)};
}

// The rod rotates as a whole about z: (Ip - Ia) cos(tilt) Om^2 = m g d.
ExperimentRun conical_pendulum(double) {
    const double tilt = pi / 6, arm = 0.5;
    Scene scene{.name = "f6"};
    Body rod = without_shape(solid_box(1, {0.05, 0.05, 0.5}, {}));
    const double at_pivot = rod.inertia.x + arm * arm;
    const double rate = std::sqrt(g * arm / ((at_pivot - rod.inertia.z) * std::cos(tilt)));
    rod.pose = {Vec3{std::sin(tilt), 0, -std::cos(tilt)} * arm,
                physics::from_axis_angle({0, 1, 0}, -tilt)};
    rod.spin = {0, 0, rate};
    rod.velocity = cross(rod.spin, rod.pose.position);
    scene.bodies = {rod};
    scene.joints = {ball_at(ground, 0, {})};
    auto meter = track_meter(scene, 0, on_cone(arm, tilt, rate, -1), arm, arm);
    return {std::move(scene), 10, std::move(meter)};
}

}  // namespace

std::vector<Experiment> top_experiments() {
    constexpr const char* measures =
        "RMS position error / arm length; widest joint gap / arm length";
    return {
        {.name = "f5",
         .about = "a heavy top precesses on a ball joint for 5 s",
         .measures = measures,
         .tolerances = {0.1, 0.01, 0.001},
         .start = top_on_ball_joint},
        {.name = "f6",
         .about = "a conical pendulum for 10 s",
         .measures = measures,
         .tolerances = {0.1, 0.01, 0.001},
         .start = conical_pendulum},
        {.name = "j9",
         .about = "the top of f5 in two light gimbals",
         .measures = measures,
         .tolerances = {0.1, 0.01, 0.001},
         .start = top_in_gimbals},
    };
}

}  // namespace jostle::bench::accuracy
