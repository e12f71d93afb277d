// SPDX-License-Identifier: MIT
//
// F1 to F4: free motion, springs and force fields.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/reference.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

ExperimentRun free_fall(double) {
    Scene scene{.name = "f1"};
    Body ball = without_shape(solid_sphere(1, 0.1, {}));
    ball.velocity = {3, 4, 5};
    scene.bodies = {ball};
    auto meter = last_meter([](double t, const Engine& engine) {
        const Vec3 truth{3 * t, 4 * t, 5 * t - 0.5 * g * t * t};
        return Errors{length(engine.state(0).position - truth), 0};
    });
    return {std::move(scene), 2, std::move(meter)};
}

class SpringMeter final : public Meter {
public:
    explicit SpringMeter(double stiffness) : stiffness_(stiffness) {}

    void sample(double t, const Engine& engine) override {
        const BodyState now = engine.state(0);
        const double truth = std::cos(std::sqrt(stiffness_) * t);
        distance_.add(length_squared(now.position - Vec3{truth, 0, 0}));
        const double share = (dot(now.velocity, now.velocity) / stiffness_ +
                              dot(now.position, now.position));  // of the energy at the start
        drift_ = std::max(drift_, std::abs(share - 1));
    }
    Errors errors() const override { return {distance_.value(), drift_}; }

private:
    double stiffness_, drift_ = 0;
    Rms distance_;
};

// The other end of the spring is 10 m away along its line, so that its length is never zero.
ExperimentRun spring(double hertz) {
    const double stiffness = std::pow(2 * pi * hertz, 2);
    Scene scene{.name = "f2", .gravity = {}, .planar = true};
    scene.bodies = {without_shape(solid_sphere(1, 0.1, {1, 0, 0}))};
    scene.joints = {{.kind = JointKind::spring,
                     .b = 0,
                     .anchor = {-10, 0, 0},
                     .anchor_b = {1, 0, 0},
                     .stiffness = stiffness,
                     .rest_length = 10}};
    return {std::move(scene), 10, std::make_unique<SpringMeter>(stiffness)};
}

class KeplerMeter final : public Meter {
public:
    void sample(double, const Engine& engine) override {
        const BodyState now = engine.state(0);
        const double pull = 4 * pi * pi, truth = -0.5 * pull;  // -pull / (2 a), a = 1
        const double found = 0.5 * dot(now.velocity, now.velocity) - pull / length(now.position);
        errors_.primary = length(now.position - Vec3{0.5, 0, 0});
        errors_.secondary = std::max(errors_.secondary, std::abs(found / truth - 1));
    }
    Errors errors() const override { return errors_; }

private:
    Errors errors_;
};

ExperimentRun kepler(double) {
    Scene scene{.name = "f3", .gravity = {}, .central_pull = 4 * pi * pi};
    Body body = without_shape(solid_sphere(1, 0.1, {0.5, 0, 0}));
    body.velocity = {0, 2 * pi * std::sqrt(3), 0};
    scene.bodies = {body};
    return {std::move(scene), 10, std::make_unique<KeplerMeter>()};
}

class TumbleMeter final : public Meter {
public:
    TumbleMeter(const Body& body, std::shared_ptr<const Trajectory> axis_y)
        : body_(body),
          energy_(kinetic_energy(body, {}, {}, body.spin)),
          momentum_(spin_momentum(body, {}, body.spin)),
          axis_y_(std::move(axis_y)) {}

    void sample(double t, const Engine& engine) override {
        const BodyState now = engine.state(0);
        const double energy = kinetic_energy(body_, now.rotation, {}, now.spin);
        const Vec3 momentum = spin_momentum(body_, now.rotation, now.spin);
        most_ = std::max({most_, std::abs(energy / energy_ - 1),
                          length(momentum - momentum_) / length(momentum_)});
        if (!axis_y_) return;
        const Vec3 found = rotate(now.rotation, {0, 1, 0}), truth = at_time(*axis_y_, t);
        const double angle = std::atan2(length(cross(found, truth)), dot(found, truth));
        angle_.add(angle * angle);
    }
    Errors errors() const override { return {most_, angle_.value()}; }

private:
    Body body_;
    double energy_, most_ = 0;
    Vec3 momentum_;
    Rms angle_;
    std::shared_ptr<const Trajectory> axis_y_;
};

ExperimentRun tumble(double seconds) {
    Scene scene{.name = "f4", .gravity = {}};
    const Body body{.mass = 1, .inertia = {0.1, 0.2, 0.28}, .spin = {0.01, 5, 0.01}};
    scene.bodies = {body};
    std::shared_ptr<const Trajectory> axis;  // ten minutes of it would take 300 MB
    if (seconds <= 10)
        axis =
            cached_trajectory("f4", [&] { return free_axis_y(body.inertia, body.spin, seconds); });
    return {std::move(scene), seconds, std::make_unique<TumbleMeter>(body, axis)};
}

}  // namespace

std::vector<Experiment> free_experiments() {
    return {
        {.name = "f1",
         .about = "free fall for 2 s",
         .measures = "position error at the end, m; none",
         .tolerances = {0.1, 0.01, 1e-6},
         .start = free_fall},
        {.name = "f2-1",
         .about = "1 kg on a spring without damping, 1 Hz, 10 s",
         .measures = "RMS position error, m; largest drift of energy",
         .tolerances = {0.1, 0.01, 0.001},
         .start = [](double) { return spring(1); }},
        {.name = "f2-100",
         .about = "the same, 100 Hz",
         .measures = "RMS position error, m; largest drift of energy",
         .tolerances = {0.1, 0.01, 0.001},
         .start = [](double) { return spring(100); }},
        {.name = "f3",
         .about = "ten orbits of eccentricity 0.5",
         .measures = "distance from the start at the end, m; largest drift of energy",
         .tolerances = {0.1, 0.01, 0.001},
         .start = kepler},
        {.name = "f4",
         .about = "a body tumbles about its middle axis for 10 s",
         .measures = "largest drift of energy or momentum; RMS angle, rad",
         .tolerances = {0.01, 0.001, 1e-5},
         .start = [](double) { return tumble(10); }},
        {.name = "f4-600",
         .about = "the same for 600 s",
         .measures = "largest drift of energy or momentum; none",
         .tolerances = {0.01, 0.001, 1e-5},
         .max_hz = 240,
         .start = [](double) { return tumble(600); },
         .short_max_hz = 120},
    };
}

}  // namespace jostle::bench::accuracy
