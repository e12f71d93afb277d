// SPDX-License-Identifier: MIT
//
// C17: three bodies on the figure-eight orbit, whose trajectory is known; a rope and a cloth, which
// are compared with the finest run of the same engine.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/reference.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

// --- three bodies ---

constexpr int suns = 3;

// Chenciner and Montgomery, "A remarkable periodic solution of the three-body problem in the case
// of equal masses", 2000; the numbers are by Carles Simo. Masses and the gravitational constant are
// 1.
Scene figure_eight() {
    const Vec3 at{0.97000436, -0.24308753, 0}, velocity{-0.93240737, -0.86473146, 0};
    const Vec3 places[suns] = {at, -at, {}};
    const Vec3 velocities[suns] = {velocity * -0.5, velocity * -0.5, velocity};
    Scene scene{.name = "c17-eight", .gravity = {}, .mutual_pull = 1};
    for (int k = 0; k < suns; k++) {
        Body body = without_shape(solid_sphere(1, 0.05, places[k]));
        body.velocity = velocities[k];
        scene.bodies.push_back(std::move(body));
    }
    return scene;
}

// Trajectory of one of the three bodies; those of the others are the same, time-shifted.
Trajectory way_of_first(double seconds) {
    const Scene scene = figure_eight();
    const std::vector<double> masses(suns, 1);
    State y;
    for (const Body& body : scene.bodies)
        for (int i = 0; i < 3; i++) y.push_back(body.pose.position[i]);
    for (const Body& body : scene.bodies)
        for (int i = 0; i < 3; i++) y.push_back(body.velocity[i]);
    const auto position_of = [](const State& from, int k) {
        const auto first = static_cast<std::size_t>(3 * k);
        return Vec3{from[first], from[first + 1], from[first + 2]};
    };
    const auto rate = [&](const State& now, State& dy) {
        std::vector<Vec3> at;
        for (int k = 0; k < suns; k++) at.push_back(position_of(now, k));
        const std::vector<Vec3> forces = mutual_forces(masses, at, 1);
        dy.assign(now.begin() + 3 * suns, now.end());
        for (const Vec3 force : forces)
            for (int i = 0; i < 3; i++) dy.push_back(force[i]);
    };
    Trajectory track;
    const long ticks = std::lround(seconds * reference_hz);
    for (long k = 0; k <= ticks; k++) {
        track.push_back(position_of(y, 0));
        runge_kutta_step(y, 1.0 / reference_hz, rate);
    }
    return track;
}

ExperimentRun eight(double) {
    constexpr double seconds = 5;
    Scene scene = figure_eight();
    const auto track = cached_trajectory(scene.name, [] { return way_of_first(seconds); });
    auto meter = last_meter([track](double t, const Engine& engine) {
        Vec3 center;
        for (int k = 0; k < suns; k++) center += engine.state(k).position / suns;
        return Errors{length(engine.state(0).position - at_time(*track, t)), length(center)};
    });
    return {std::move(scene), seconds, std::move(meter)};
}

// --- a rope ---

class GapsMeter final : public Meter {
public:
    explicit GapsMeter(const Scene& scene) : gaps_(scene) {}
    void sample(double, const Engine& engine) override { gaps_.sample(engine); }
    Errors errors() const override { return {0, gaps_.most()}; }

private:
    GapMeter gaps_;
};

// A hundred links of 5 cm, released 30 degrees off the vertical.
ExperimentRun rope(double) {
    constexpr int links = 100;
    constexpr double length = 0.05;
    const double angle = pi / 6;
    const Vec3 along{std::sin(angle), 0, -std::cos(angle)};
    Scene scene{.name = "c17-rope", .planar = true};
    for (int k = 0; k < links; k++) {
        Body link = without_shape(
            solid_box(0.02, {0.005, 0.005, 0.5 * length}, along * (length * (k + 0.5))));
        link.pose.rotation = physics::from_axis_angle({0, 1, 0}, -angle);
        scene.bodies.push_back(std::move(link));
        scene.joints.push_back(ball_at(k - 1, k, along * (length * k)));
    }
    auto meter = std::make_unique<GapsMeter>(scene);
    return {std::move(scene), 5, std::move(meter)};
}

// --- a cloth ---

// Points of 10 g at 5 cm, on springs to their neighbours along both edges; springs also hold two
// corners. With springs of 400 N/m it sags by a few centimetres.
ExperimentRun cloth(double) {
    constexpr int side = 32;
    constexpr double pitch = 0.05, stiffness = 400, damping = 0.02;
    Scene scene{.name = "c17-cloth"};
    const auto grid_position = [](int i, int j) { return Vec3{pitch * i, pitch * j, 0}; };
    const auto spring = [&](int a, int b, Vec3 from, Vec3 to) {
        scene.joints.push_back({.kind = JointKind::spring,
                                .a = a,
                                .b = b,
                                .anchor = from,
                                .anchor_b = to,
                                .stiffness = stiffness,
                                .damping = damping,
                                .rest_length = pitch});
    };
    for (int i = 0; i < side; i++)
        for (int j = 0; j < side; j++) {
            const int here = side * i + j;
            scene.bodies.push_back(without_shape(solid_sphere(0.01, 0.01, grid_position(i, j))));
            if (i > 0) spring(here - side, here, grid_position(i - 1, j), grid_position(i, j));
            if (j > 0) spring(here - 1, here, grid_position(i, j - 1), grid_position(i, j));
        }
    for (const int j : {0, side - 1}) spring(ground, j, grid_position(-1, j), grid_position(0, j));
    auto meter = std::make_unique<GapsMeter>(scene);
    return {std::move(scene), 2, std::move(meter)};
}

}  // namespace

std::vector<Experiment> chaos_experiments() {
    return {
        {.name = "c17-eight",
         .about = "three mutually attracting bodies on a figure-eight orbit, 5 s",
         .measures = "position error of the first at the end, m; of the common centre, m",
         .tolerances = {0.1, 0.01, 0.001},
         .start = eight},
        {.name = "c17-rope",
         .about = "a rope of 100 links swings from 30 degrees for 5 s",
         .measures = "RMS distance from the same engine's run at 1920 Hz, m; widest joint gap, m",
         .tolerances = {0.1, 0.01, 0.001},
         .max_hz = 480,
         .finest_hz = 1920,
         .start = rope},
        {.name = "c17-cloth",
         .about = "a cloth of 32 by 32 points falls from two corners, 2 s",
         .measures = "RMS distance from the same engine's run at 960 Hz, m; none",
         .tolerances = {0.1, 0.01, 0.001},
         .max_hz = 240,
         .finest_hz = 960,
         .start = cloth},
    };
}

}  // namespace jostle::bench::accuracy
