// SPDX-License-Identifier: MIT
//
// S9, S12, S13, S15 and S19: long steps, fast bodies and fast spins.
#include <cmath>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/run_row.h"
#include "bench/accuracy/stress_test.h"

namespace jostle::bench::accuracy {
namespace {

// An experiment at one rate with a limit on its error.
StressTest experiment(const char* id, const char* name, double rate_hz, double limit,
                      double speed_bound) {
    const Experiment* found = find_experiment(name);
    const StressRun run{.start = [found] { return found->start(0); },
                        .rate_hz = rate_hz,
                        .speed_bound = speed_bound,
                        .limit = limit};
    return {.id = id,
            .about = found->about + ", " + std::to_string(static_cast<int>(rate_hz)) + " Hz",
            .figure = found->measures.substr(0, found->measures.find(';')),
            .limit = limit,
            .run = [run](const EngineKind& kind, const std::string& mode) {
                return run_stress(run, kind, mode);
            }};
}

// Every start of the bullet at every rate.
Verdict bullets(const EngineKind& kind, const std::string& mode) {
    const Experiment& bullet = *find_experiment("c15");
    double passed = 0;
    for (const double rate_hz : {15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0, 1920.0})
        for (int phase = 0; phase < bullet.phases; phase++) {
            const double shift = phase / rate_hz / bullet.phases;
            const auto outcome = run_once(bullet.start(shift), kind, mode, rate_hz);
            if (!outcome) return {.unsupported = outcome.error().message};
            if (!outcome->failed.empty()) return {.why = outcome->failed};
            passed += outcome->errors.primary;
        }
    return {.pass = passed == 0, .figure = passed};
}

// A thin disk spins on a pin along z for ten minutes.
class SpinMeter final : public Meter {
public:
    explicit SpinMeter(Vec3 spin) : spin_(spin) {}
    void sample(double, const Engine& engine) override {
        const Vec3 now = engine.state(0).spin;
        most_ = std::max(most_, length(now - spin_) / length(spin_));
    }
    Errors errors() const override { return {most_, 0}; }

private:
    Vec3 spin_;
    double most_ = 0;
};

ExperimentRun fast_disk() {
    Scene scene{.name = "disk"};
    Body disk = without_shape(solid_cylinder(1, 0.1, 0.005, {}));
    disk.pose.rotation = physics::from_axis_angle({1, 0, 0}, 0.5 * physics::pi);
    disk.spin = {0, 0, 1000};
    scene.bodies = {disk};
    scene.joints = {hinge_at(ground, 0, {}, {0, 0, 1})};
    return {std::move(scene), 600, std::make_unique<SpinMeter>(disk.spin)};
}

}  // namespace

std::vector<StressTest> motion_stress_tests() {
    std::vector<StressTest> all = {experiment("s9-j1", "j1", 15, 0.1, std::sqrt(2 * g * 0.5)),
                                   experiment("s9-j4", "j4", 15, 0.1, std::sqrt(2 * g * 0.5)),
                                   experiment("s9-c8", "c8", 15, 0.5, std::sqrt(2 * g * 10)),
                                   experiment("s13", "f4-600", 60, 0.01, 0),
                                   experiment("s15", "f5", 60, 0.1, 0)};
    all.push_back({.id = "s12",
                   .about = "bullets of 200 m/s against 2 cm, 16 starts at 15 to 1920 Hz",
                   .figure = "bullets of 128 that tunnel",
                   .limit = 1,
                   .run = bullets});
    const StressRun disk{.start = fast_disk, .limit = 0.01};
    all.push_back({.id = "s19",
                   .about = "a thin disk at 1000 rad/s on a pin, 60 Hz, 600 s",
                   .figure = "largest relative drift of the spin",
                   .limit = disk.limit,
                   .run = [disk](const EngineKind& kind, const std::string& mode) {
                       return run_stress(disk, kind, mode);
                   }});
    return all;
}

}  // namespace jostle::bench::accuracy
