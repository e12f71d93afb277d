// SPDX-License-Identifier: MIT
#include "bench/accuracy/stress_test.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "bench/accuracy/run_row.h"
#include "bench/result_file.h"

namespace jostle::bench::accuracy {
namespace {

// Second error: the highest speed of any free body.
class SpeedGuard final : public Meter {
public:
    SpeedGuard(const Scene& scene, std::unique_ptr<Meter> inner, Figure figure)
        : inner_(std::move(inner)), figure_(figure) {
        for (std::size_t k = 0; k < scene.bodies.size(); k++)
            if (scene.bodies[k].motion == Motion::free) free_.push_back(static_cast<int>(k));
    }
    void sample(double t, const Engine& engine) override {
        inner_->sample(t, engine);
        for (const int body : free_)
            fastest_ = std::max(fastest_, length(engine.state(body).velocity));
    }
    Errors errors() const override {
        const Errors inner = inner_->errors();
        return {figure_ == Figure::primary ? inner.primary : inner.secondary, fastest_};
    }

private:
    std::unique_ptr<Meter> inner_;
    Figure figure_;
    std::vector<int> free_;
    double fastest_ = 0;
};

}  // namespace

std::span<const StressTest> all_stress_tests() {
    static const std::vector<StressTest> all = [] {
        std::vector<StressTest> tests;
        for (const auto& family :
             {stack_stress_tests(), joint_stress_tests(), motion_stress_tests(),
              pile_stress_tests(), input_stress_tests()})
            tests.insert(tests.end(), family.begin(), family.end());
        // Sorted by number, then by suffix: s3b after s3, s10 after s9.
        std::stable_sort(tests.begin(), tests.end(), [](const auto& a, const auto& b) {
            return std::stoi(a.id.substr(1)) < std::stoi(b.id.substr(1));
        });
        return tests;
    }();
    return all;
}

Verdict run_stress(const StressRun& run, const EngineKind& kind, const std::string& mode) {
    ExperimentRun start = run.start();
    start.meter = std::make_unique<SpeedGuard>(start.scene, std::move(start.meter), run.figure);
    const auto outcome = run_once(std::move(start), kind, mode, run.rate_hz);
    if (!outcome) return {.unsupported = outcome.error().message};
    if (!outcome->failed.empty()) return {.why = outcome->failed};
    Verdict verdict{.pass = outcome->errors.primary < run.limit, .figure = outcome->errors.primary};
    if (run.speed_bound > 0 && outcome->errors.secondary > 2 * run.speed_bound) {
        char text[64];
        std::snprintf(text, sizeof text, "a body reaches %.3g m/s", outcome->errors.secondary);
        verdict.pass = false;
        verdict.why = text;
    }
    return verdict;
}

nlohmann::ordered_json to_json(const StressTest& test, const EngineKind& kind,
                               const std::string& mode, const Verdict& verdict) {
    nlohmann::ordered_json json = {{"id", test.id}, {"engine", kind.name}, {"mode", mode}};
    if (!verdict.unsupported.empty()) {
        json["lacks"] = verdict.unsupported;
        return json;
    }
    json["pass"] = verdict.pass;
    if (verdict.figure) json["figure"] = rounded(*verdict.figure);
    json["limit"] = test.limit;
    if (!verdict.why.empty()) json["why"] = verdict.why;
    return json;
}

}  // namespace jostle::bench::accuracy
