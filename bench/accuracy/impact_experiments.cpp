// SPDX-License-Identifier: MIT
//
// C5 to C7 and C15: impacts. The time of an impact within its step determines its error, so each
// experiment runs from 16 starts.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

constexpr double impact_ball_radius = 0.1;
constexpr int phases = 16;

// --- C5 ---

Scene bouncing(double restitution, double late) {
    Scene scene{.name = "c5", .restitution = restitution, .planar = true};
    Body ball =
        solid_sphere(1, impact_ball_radius, {0, 0, 1 + impact_ball_radius - 0.5 * g * late * late});
    ball.velocity = {0, 0, -g * late};
    scene.bodies = {ball, fixed_plane()};
    return scene;
}

// An apex is that of the parabola through the highest sample and its two neighbours, so steps that
// miss the apex do not count as errors.
class ApexMeter final : public Meter {
public:
    void sample(double, const Engine& engine) override {
        const double height = engine.state(0).position.z - impact_ball_radius;
        if (heights_ >= 2 && last_ > before_ && last_ >= height) {
            const double bend = before_ - 2 * last_ + height, rise = 0.5 * (height - before_);
            apexes_.push_back(bend < 0 ? last_ - 0.5 * rise * rise / bend : last_);
        }
        before_ = last_;
        last_ = height;
        heights_++;
        deepest_ = std::max(deepest_, -height);
    }
    Errors errors() const override {
        constexpr std::size_t apex_count = 5;
        double sum = 0;
        for (std::size_t n = 0; n < apex_count; n++) {
            const double truth = std::pow(0.64, static_cast<double>(n + 1));
            sum += std::abs((n < apexes_.size() ? apexes_[n] : 0) - truth) / truth;
        }
        return {sum / static_cast<double>(apex_count), deepest_};
    }

private:
    double before_ = 0, last_ = 0, deepest_ = 0;
    int heights_ = 0;
    std::vector<double> apexes_;
};

class BounceEnergyMeter final : public Meter {
public:
    explicit BounceEnergyMeter(const Scene& scene) : scene_(scene) {}
    void sample(double, const Engine& engine) override {
        last_ = energy(scene_, engine) / (g * (1 + impact_ball_radius)) - 1;
        error_.add(last_ * last_);
    }
    Errors errors() const override { return {error_.value(), std::abs(last_)}; }

private:
    Scene scene_;
    Rms error_;
    double last_ = 0;
};

ExperimentRun bounce(double shift) {
    return {bouncing(0.8, shift), 3, std::make_unique<ApexMeter>()};
}

ExperimentRun elastic_bounce(double shift) {
    Scene scene = bouncing(1, shift);
    auto meter = std::make_unique<BounceEnergyMeter>(scene);
    return {std::move(scene), 20, std::move(meter)};
}

// --- C6 and C7 ---

// B's centre is one radius off A's path, so the line of centres is 30 degrees off it.
ExperimentRun billiard(double shift) {
    const double speed = 5, angle = 37 * pi / 180;
    const Vec3 along = azimuth(angle), aside = azimuth(angle + 0.5 * pi);
    Scene scene{.name = "c6", .gravity = {}, .restitution = 1};
    Body a = solid_sphere(1, impact_ball_radius, along * (-2 + speed * shift));
    a.velocity = along * speed;
    scene.bodies = {a, solid_sphere(1, impact_ball_radius, aside * impact_ball_radius)};
    const Vec3 normal = along * std::cos(pi / 6) + aside * std::sin(pi / 6);
    const Vec3 of_b = normal * (speed * std::cos(pi / 6)), of_a = along * speed - of_b;
    auto meter = last_meter([=](double, const Engine& engine) {
        const Vec3 va = engine.state(0).velocity, vb = engine.state(1).velocity;
        return Errors{(length(va - of_a) + length(vb - of_b)) / speed,
                      std::abs((dot(va, va) + dot(vb, vb)) / (speed * speed) - 1)};
    });
    return {std::move(scene), 1, std::move(meter)};
}

// Four touching balls in a row; a fifth one arrives at 1 m/s.
ExperimentRun cradle(double shift) {
    constexpr int count = 5;
    Scene scene{.name = "c7", .gravity = {}, .restitution = 1, .planar = true};
    Body first = solid_sphere(1, impact_ball_radius, {-0.5 - 2 * impact_ball_radius + shift, 0, 0});
    first.velocity = {1, 0, 0};
    scene.bodies = {first};
    for (int k = 0; k < count - 1; k++)
        scene.bodies.push_back(
            solid_sphere(1, impact_ball_radius, {2 * impact_ball_radius * k, 0, 0}));
    auto meter = last_meter([](double, const Engine& engine) {
        double squares = 0, motion = 0;
        for (int k = 0; k < count; k++) {
            const Vec3 v = engine.state(k).velocity;
            squares += length_squared(v - Vec3{k == count - 1 ? 1.0 : 0.0, 0, 0});
            motion += dot(v, v);
        }
        return Errors{std::sqrt(squares), std::abs(motion - 1)};
    });
    return {std::move(scene), 1, std::move(meter)};
}

// --- C15 ---

// At 15 steps per second the bullet moves 13 m per step, so later starts begin further away.
ExperimentRun bullet(double shift) {
    constexpr double speed = 200;
    Scene scene{.name = "c15", .gravity = {}, .continuous = true};
    Body ball = solid_sphere(0.1, 0.05, {-5.4 - speed * shift, 0.01, 0.02});
    ball.velocity = {speed, 0, 0};
    scene.bodies = {ball, fixed_box({0.01, 1, 1}, {})};
    auto meter = last_meter([](double, const Engine& engine) {
        const double x = engine.state(0).position.x;
        return Errors{x > 0 ? 1.0 : 0.0, std::max(x + 0.05 + 0.01, 0.0)};
    });
    return {std::move(scene), 0.1, std::move(meter)};
}

}  // namespace

std::vector<Experiment> impact_experiments() {
    return {
        {.name = "c5-e0.8",
         .about = "a ball bounces with restitution 0.8 for 3 s",
         .measures = "mean relative error of the first five apexes; deepest overlap, m",
         .tolerances = {0.05, 0.02, 0.005},
         .phases = phases,
         .start = bounce},
        {.name = "c5-e1",
         .about = "a ball bounces without loss for 20 s",
         .measures = "RMS error of the energy; the same at the end",
         .tolerances = {0.1, 0.01, 0.001},
         .phases = phases,
         .start = elastic_bounce},
        {.name = "c6",
         .about = "a ball hits another one off-centre",
         .measures = "relative errors of both velocities; error of the energy",
         .tolerances = {0.1, 0.05, 0.02},
         .phases = phases,
         .start = billiard},
        {.name = "c7",
         .about = "Newton's cradle: a ball hits a row of four touching balls",
         .measures = "norm of the errors of all velocities, m/s; error of the energy",
         .tolerances = {0.5, 0.1, 0.01},
         .phases = phases,
         .start = cradle},
        {.name = "c15",
         .about = "a bullet of 200 m/s against a wall of 2 cm",
         .measures = "1 if it passes, else 0; largest distance past the near side, m",
         .tolerances = {0.01},
         .phases = phases,
         .start = bullet},
    };
}

}  // namespace jostle::bench::accuracy
