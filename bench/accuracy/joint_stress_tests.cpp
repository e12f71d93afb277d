// SPDX-License-Identifier: MIT
//
// S6 to S8, S14, S16, S17 and S21: chains, loops, springs and contradictory joints.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/run_row.h"
#include "bench/accuracy/stress_test.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

std::function<Verdict(const EngineKind&, const std::string&)> runner(StressRun run) {
    return [run = std::move(run)](const EngineKind& kind, const std::string& mode) {
        return run_stress(run, kind, mode);
    };
}

// Primary: widest joint gap divided by a length.
class LooseMeter final : public Meter {
public:
    LooseMeter(const Scene& scene, double length) : gaps_(scene), length_(length) {}
    void sample(double, const Engine& engine) override { gaps_.sample(engine); }
    Errors errors() const override { return {gaps_.most() / length_, 0}; }

private:
    GapMeter gaps_;
    double length_;
};

// --- S6 to S8 ---

// Links of 0.2 m and 0.1 kg; the last one is a ball of 100 kg.
ExperimentRun hanging_chain(int count, double degrees, double seconds) {
    constexpr double link = 0.2;
    const double angle = degrees * pi / 180;
    const Vec3 along{std::sin(angle), 0, -std::cos(angle)};
    Scene scene{.name = "chain", .planar = true};
    for (int k = 0; k < count; k++) {
        Body body = k == count - 1 ? solid_sphere(100, 0.1, {})
                                   : solid_box(0.1, {0.02, 0.02, 0.5 * link}, {});
        body = without_shape(std::move(body));
        body.pose = {along * (link * (k + 0.5)), physics::from_axis_angle({0, 1, 0}, -angle)};
        scene.bodies.push_back(std::move(body));
        scene.joints.push_back(ball_at(k - 1, k, along * (link * k)));
    }
    auto meter = std::make_unique<LooseMeter>(scene, link);
    return {std::move(scene), seconds, std::move(meter)};
}

StressTest chain(const char* id, int count, double degrees, double rate_hz, double seconds) {
    // The end falls by its excess height and by the allowed gap; a link has a thousandth of its
    // mass and may get all of that energy.
    const double height = 0.2 * count * (1 - std::cos(degrees * pi / 180)) + 0.05 * 0.2;
    std::string about = std::to_string(count) + " links carry 100 kg";
    if (degrees > 0) about += ", 1 degree off the vertical";
    return {.id = id,
            .about = about + ", " + std::to_string(static_cast<int>(rate_hz)) + " Hz, " +
                     std::to_string(static_cast<int>(seconds)) + " s",
            .figure = "widest joint gap / link length",
            .limit = 0.05,
            .run = runner({.start = [=] { return hanging_chain(count, degrees, seconds); },
                           .rate_hz = rate_hz,
                           .speed_bound = std::sqrt(2 * g * height * 1000),
                           .limit = 0.05})};
}

// --- S14 ---

// Chains with heavy ends at every rate. Bullet's conjugate gradients are known to fail in this
// test.
Verdict loaded_chains(const EngineKind& kind, const std::string& mode) {
    const bool bullet = std::string(kind.name) == "bullet";
    int blown = 0;
    for (const char* name : {"j3-r100", "j3-r1000"})
        for (const double rate_hz : {30.0, 60.0, 120.0, 240.0, 480.0}) {
            const auto outcome =
                run_once(find_experiment(name)->start(0), kind, bullet ? "nncg10" : mode, rate_hz);
            if (!outcome) return {.unsupported = outcome.error().message};
            blown += !outcome->failed.empty();
        }
    return {.pass = blown == 0, .figure = static_cast<double>(blown)};
}

// --- S16 ---

// Parallel rods between the ground and one coupler: each one after the second is redundant.
ExperimentRun parallel_cranks(int count) {
    const double angle = pi / 3, pitch = 0.5;
    const Vec3 down{std::sin(angle), 0, -std::cos(angle)};
    Scene scene{.name = "cranks", .planar = true};
    const double half_width = 0.5 * pitch * (count - 1);
    scene.bodies.push_back(
        without_shape(solid_box(2, {half_width, 0.05, 0.05}, down + Vec3{half_width, 0, 0})));
    for (int k = 0; k < count; k++) {
        const Vec3 upper{pitch * k, 0, 0};
        Body rod = without_shape(solid_box(1, {0.05, 0.05, 0.5}, upper + down * 0.5));
        rod.pose.rotation = physics::from_axis_angle({0, 1, 0}, -angle);
        scene.bodies.push_back(std::move(rod));
        scene.joints.push_back(hinge_at(ground, k + 1, upper));
        scene.joints.push_back(hinge_at(k + 1, 0, upper + down));
    }
    auto meter = std::make_unique<LooseMeter>(scene, 1);
    return {std::move(scene), 5, std::move(meter)};
}

// --- S17 ---

class SpringEnergyMeter final : public Meter {
public:
    explicit SpringEnergyMeter(const Scene& scene) : scene_(scene) {}

    void sample(double, const Engine& engine) override {
        double found = energy(scene_, engine);
        for (const Joint& spring : scene_.joints) {
            const Vec3 a = spring.a == ground ? spring.anchor : engine.state(spring.a).position;
            const double longer = length(engine.state(spring.b).position - a) - spring.rest_length;
            found += 0.5 * spring.stiffness * longer * longer;
        }
        most_ = std::max(most_, found / start() - 1);
    }
    Errors errors() const override { return {most_, 0}; }

private:
    double start() const {
        double sum = 0;
        for (const Body& body : scene_.bodies)
            sum += 0.5 * body.mass * dot(body.velocity, body.velocity);
        return sum;
    }

    Scene scene_;
    double most_ = 0;
};

// Nine masses in a row on springs of 1 to 1e8 N/m, the last one pushed.
ExperimentRun spring_chain() {
    Scene scene{.name = "springs", .gravity = {}, .planar = true};
    for (int k = 0; k < 9; k++) {
        Body body = without_shape(solid_sphere(1, 0.1, {1.0 + k, 0, 0}));
        if (k == 8) body.velocity = {0.3, 0, 0};
        scene.bodies.push_back(std::move(body));
        scene.joints.push_back({.kind = JointKind::spring,
                                .a = k - 1,
                                .b = k,
                                .anchor = {1.0 * k, 0, 0},
                                .anchor_b = {1.0 + k, 0, 0},
                                .stiffness = std::pow(10, k),
                                .rest_length = 1});
    }
    auto meter = std::make_unique<SpringEnergyMeter>(scene);
    return {std::move(scene), 10, std::move(meter)};
}

// --- S21 ---

// Highest speed in the second half, m/s. Contradictory joints may rest in any pose.
class CalmMeter final : public Meter {
public:
    void sample(double t, const Engine& engine) override {
        const BodyState now = engine.state(0);
        if (t > 50) fastest_ = std::max(fastest_, length(now.velocity) + length(now.spin));
        furthest_ = std::max(furthest_, length(now.position));
    }
    Errors errors() const override { return {fastest_ + (furthest_ > 2 ? 1e3 : 0), furthest_}; }

private:
    double fastest_ = 0, furthest_ = 0;
};

ExperimentRun torn_body() {
    Scene scene{.name = "torn"};
    scene.bodies = {without_shape(solid_box(1, {0.2, 0.2, 0.2}, {}))};
    Joint unreachable = ball_at(ground, 0, {1, 0, 0});
    unreachable.misaligned_anchor_b = Vec3{0.2, 0, 0};
    scene.joints = {{.kind = JointKind::fixed, .b = 0}, unreachable};
    return {std::move(scene), 100, std::make_unique<CalmMeter>()};
}

}  // namespace

std::vector<StressTest> joint_stress_tests() {
    std::vector<StressTest> all = {chain("s6", 50, 0, 60, 5), chain("s6-tilt", 50, 1, 60, 5),
                                   chain("s7", 200, 0, 240, 1), chain("s8", 1000, 0, 240, 1)};
    all.push_back({.id = "s14",
                   .about = "chains with 100 and 1000 times the mass at the end, 30 to 480 Hz",
                   .figure = "failed runs of ten",
                   .limit = 1,
                   .run = loaded_chains});
    for (const int count : {2, 6})
        all.push_back({.id = count == 2 ? "s16" : "s16-six",
                       .about = std::to_string(count) + " parallel cranks of hinges, 240 Hz, 5 s",
                       .figure = "widest joint gap, m",
                       .limit = 1e-3,
                       .run = runner({.start = [count] { return parallel_cranks(count); },
                                      .rate_hz = 240,
                                      .speed_bound = std::sqrt(2 * g * 0.5),
                                      .limit = 1e-3})});
    all.push_back({.id = "s17",
                   .about = "nine masses on springs of 1 to 1e8 N/m, 60 Hz, 10 s",
                   .figure = "largest growth of the energy",
                   .limit = 0.01,
                   .run = runner({.start = spring_chain, .speed_bound = 0.3, .limit = 0.01})});
    all.push_back({.id = "s21",
                   .about = "a weld and a ball joint 0.8 m apart, 60 Hz, 100 s",
                   .figure = "highest speed in the second half, m/s and rad/s",
                   .limit = 0.1,
                   .run = runner({.start = torn_body, .limit = 0.1})});
    return all;
}

}  // namespace jostle::bench::accuracy
