// SPDX-License-Identifier: MIT
//
// S1 to S5, S10 and S11: stacks.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/stack_scenes.h"
#include "bench/accuracy/stress_test.h"

namespace jostle::bench::accuracy {
namespace {

ExperimentRun resting(Scene scene, double seconds) {
    auto meter = rest_meter(scene, When::ever);
    return {std::move(scene), seconds, std::move(meter)};
}

// Speed of a body that fell from this height.
double fall_speed(double height) {
    return std::sqrt(2 * g * height);
}

StressTest stack(const char* id, int count, double rate_hz, double seconds, double limit) {
    const StressRun run{.start = [=] { return resting(box_stack(count, half_cube, 1), seconds); },
                        .rate_hz = rate_hz,
                        .speed_bound = fall_speed(count),
                        .limit = limit};
    return {.id = id,
            .about = std::to_string(count) + " boxes at " +
                     std::to_string(static_cast<int>(rate_hz)) + " Hz for " +
                     std::to_string(static_cast<int>(seconds)) + " s",
            .figure = "largest displacement, m",
            .limit = limit,
            .run = [run](const EngineKind& kind, const std::string& mode) {
                return run_stress(run, kind, mode);
            }};
}

StressTest ratio_of_1000() {
    const StressRun run{.start =
                            [] {
                                Scene scene = box_stack(2, half_cube, 1);
                                scene.bodies[1] =
                                    solid_box(1000, half_cube, scene.bodies[1].pose.position);
                                auto meter = rest_meter(scene);
                                return ExperimentRun{std::move(scene), 5, std::move(meter)};
                            },
                        .speed_bound = fall_speed(2),
                        .limit = 0.01};
    return {.id = "s5",
            .about = "a box carries one of 1000 times its mass, 60 Hz, 5 s",
            .figure = "largest displacement at the end, m",
            .limit = run.limit,
            .run = [run](const EngineKind& kind, const std::string& mode) {
                return run_stress(run, kind, mode);
            }};
}

// Primary: highest speed. Second: highest centre.
class BurstMeter final : public Meter {
public:
    explicit BurstMeter(int bodies) : bodies_(bodies) {}
    void sample(double, const Engine& engine) override {
        for (int k = 0; k < bodies_; k++) {
            const BodyState now = engine.state(k);
            most_.primary = std::max(most_.primary, length(now.velocity));
            most_.secondary = std::max(most_.secondary, now.position.z);
        }
    }
    Errors errors() const override { return most_; }

private:
    int bodies_;
    Errors most_;
};

ExperimentRun overlapping() {
    constexpr int count = 5;
    Scene scene{.name = "overlap", .friction = 0.5, .planar = true};
    for (int k = 0; k < count; k++)
        scene.bodies.push_back(solid_box(1, half_cube, {0, 0, 0.5 + 0.5 * k}));
    scene.bodies.push_back(fixed_plane());
    return {std::move(scene), 3, std::make_unique<BurstMeter>(count)};
}

StressTest overlap(const char* id, double rate_hz) {
    return {
        .id = id,
        .about = "five boxes start half overlapping, " + std::to_string(static_cast<int>(rate_hz)) +
                 " Hz, 3 s",
        .figure = "highest speed, m/s; the top stays below 4.6 m",
        .limit = 5,
        .run = [rate_hz](const EngineKind& kind, const std::string& mode) {
            const StressRun speed{.start = overlapping, .rate_hz = rate_hz, .limit = 5};
            Verdict verdict = run_stress(speed, kind, mode);
            const StressRun height{
                .start = overlapping, .rate_hz = rate_hz, .limit = 4.6, .figure = Figure::second};
            if (verdict.pass && !run_stress(height, kind, mode).pass) {
                verdict.pass = false;
                verdict.why = "a box is thrown above 4.6 m";
            }
            return verdict;
        }};
}

StressTest thin_plates() {
    const StressRun run{.start =
                            [] {
                                return resting(box_stack(20, {0.5, 0.5, 0.005}, 0.1), 10);
                            },
                        .speed_bound = fall_speed(0.2),
                        .limit = 0.05};
    return {.id = "s11",
            .about = "twenty plates of 1 cm, 60 Hz, 10 s",
            .figure = "largest displacement, m",
            .limit = run.limit,
            .run = [run](const EngineKind& kind, const std::string& mode) {
                return run_stress(run, kind, mode);
            }};
}

}  // namespace

std::vector<StressTest> stack_stress_tests() {
    return {stack("s1", 10, 60, 5, 0.1),
            stack("s2", 20, 60, 5, 0.1),
            stack("s3", 50, 60, 10, 1),
            stack("s3b", 50, 240, 10, 0.2),
            stack("s4", 100, 60, 10, 1),
            ratio_of_1000(),
            overlap("s10", 60),
            overlap("s10-240", 240),
            thin_plates()};
}

}  // namespace jostle::bench::accuracy
