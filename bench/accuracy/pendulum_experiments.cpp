// SPDX-License-Identifier: MIT
//
// J1 to J4: pendulums, chains and a parallelogram in the xz plane.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/reference.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

constexpr Vec3 rod_half{0.05, 0.05, 0.5};

Vec3 hanging(double angle) {
    return {std::sin(angle), 0, -std::cos(angle)};
}

// The body's z axis is along the link; the upper end is at +z.
Body hung(Body body, double angle, Vec3 upper, double half_length) {
    body.pose = {upper + hanging(angle) * half_length, physics::from_axis_angle({0, 1, 0}, -angle)};
    return without_shape(std::move(body));
}

ExperimentRun pendulum(double degrees) {
    const double angle = degrees * pi / 180;
    Scene scene{.name = "j1", .planar = true};
    scene.bodies = {hung(solid_box(1, rod_half, {}), angle, {}, 0.5)};
    scene.joints = {hinge_at(ground, 0, {})};
    const double rate = std::sqrt(g * 0.5 / (scene.bodies[0].inertia.y + 0.25));
    const auto truth = [=](double t) { return hanging(pendulum_angle(rate, angle, t)) * 0.5; };
    auto meter = track_meter(scene, 0, truth, 1, 1);
    return {std::move(scene), 5, std::move(meter)};
}

struct Link {
    Body body;
    double half_length;
};

// Links connected in a chain and released at rest, all horizontal.
ExperimentRun chain(const std::string& name, const std::vector<Link>& links, JointKind kind,
                    double total_length, double gap_length) {
    Scene scene{.name = name, .planar = true};
    std::vector<ChainLink> truth_links;
    Vec3 upper;
    for (const Link& link : links) {
        const int index = static_cast<int>(scene.bodies.size());
        scene.bodies.push_back(hung(link.body, pi / 2, upper, link.half_length));
        scene.joints.push_back({.kind = kind, .a = index - 1, .b = index, .anchor = upper});
        truth_links.push_back(
            {link.body.mass, link.body.inertia.y, 2 * link.half_length, link.half_length});
        upper += hanging(pi / 2) * (2 * link.half_length);
    }
    const std::size_t last = links.size() - 1;
    const auto track =
        cached_trajectory(name, [&] { return planar_chain(truth_links, pi / 2, 2, last); });
    auto meter = track_meter(
        scene, static_cast<int>(last), [track](double t) { return at_time(*track, t); },
        total_length, gap_length);
    return {std::move(scene), 2, std::move(meter)};
}

ExperimentRun double_pendulum(double) {
    const Link rod{solid_box(1, rod_half, {}), 0.5};
    return chain("j2", {rod, rod}, JointKind::hinge, 2, 1);
}

// Ten links of 0.2 m; with a ratio the last one is a ball of ratio * 0.1 kg.
ExperimentRun loaded_chain(const std::string& name, double ratio) {
    std::vector<Link> links(10, {solid_box(0.1, {0.02, 0.02, 0.1}, {}), 0.1});
    if (ratio > 1) links.back().body = solid_sphere(0.1 * ratio, 0.1, {});
    return chain(name, links, JointKind::ball, 2, 0.2);
}

// Two rods on the ground, a coupler between their lower ends. The coupler only translates: theta''
// = -rate^2 sin(theta), rate^2 = (2 m d + mc) g / (2 Ip + mc).
ExperimentRun parallelogram(double) {
    const double angle = pi / 3, width = 1.5;
    const Vec3 right{width, 0, 0}, lower = hanging(angle);
    Scene scene{.name = "j4", .planar = true};
    const Body rod = solid_box(1, rod_half, {});
    Body coupler = without_shape(solid_box(2, {0.5 * width, 0.05, 0.05}, lower + right * 0.5));
    const double at_pivot = rod.inertia.y + 0.25;
    const double rate =
        std::sqrt((2 * rod.mass * 0.5 + coupler.mass) * g / (2 * at_pivot + coupler.mass));
    scene.bodies = {hung(rod, angle, {}, 0.5), std::move(coupler), hung(rod, angle, right, 0.5)};
    scene.joints = {hinge_at(ground, 0, {}), hinge_at(0, 1, lower), hinge_at(1, 2, lower + right),
                    hinge_at(ground, 2, right)};
    const auto truth = [=](double t) {
        return hanging(pendulum_angle(rate, angle, t)) + right * 0.5;
    };
    auto meter = track_meter(scene, 1, truth, 1, 1);
    return {std::move(scene), 5, std::move(meter)};
}

}  // namespace

std::vector<Experiment> pendulum_experiments() {
    std::vector<Experiment> all;
    const auto add = [&](const std::string& name, const std::string& about,
                         const std::string& measures, std::vector<double> tolerances,
                         std::function<ExperimentRun(double)> start) {
        all.push_back({.name = name,
                       .about = about,
                       .measures = measures,
                       .tolerances = std::move(tolerances),
                       .start = std::move(start)});
    };
    for (const double degrees : {90.0, 5.0, 30.0, 150.0, 170.0}) {
        const std::string angle = std::to_string(static_cast<int>(degrees));
        add(degrees == 90 ? "j1" : "j1-" + angle,
            "a rod on a hinge, released at " + angle + " degrees, 5 s",
            "RMS position error, m; widest joint gap, m", {0.01, 0.001, 1e-5},
            [degrees](double) { return pendulum(degrees); });
    }
    add("j2", "a double pendulum, released horizontal, 2 s",
        "RMS position error of the second rod / 2 m; widest joint gap, m", {0.01, 0.001, 1e-5},
        double_pendulum);
    for (const int ratio : {1, 100, 1000}) {
        const std::string name = "j3-r" + std::to_string(ratio);
        add(name,
            "a chain of ten links, the last one with " + std::to_string(ratio) +
                " times the mass, 2 s",
            "RMS position error of the last link / 2 m; widest joint gap / link length",
            {0.1, 0.01, 0.001}, [name, ratio](double) { return loaded_chain(name, ratio); });
    }
    add("j4", "a parallelogram of four hinges with three redundant rows, 5 s",
        "RMS position error of the coupler, m; widest joint gap, m", {0.01, 0.001, 1e-4},
        parallelogram);
    return all;
}

}  // namespace jostle::bench::accuracy
