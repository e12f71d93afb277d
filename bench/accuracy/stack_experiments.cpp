// SPDX-License-Identifier: MIT
//
// C8 to C11: scenes that should stand, and two that should fall.
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/stack_scenes.h"

namespace jostle::bench::accuracy {
namespace {

ExperimentRun standing(Scene scene, double seconds) {
    auto meter = rest_meter(scene);
    return {std::move(scene), seconds, std::move(meter)};
}

// Primary: 1 if no body moved by 0.1 m, so the structure still stands.
class FallMeter final : public Meter {
public:
    explicit FallMeter(const Scene& scene) : moved_(rest_meter(scene)) {}
    void sample(double t, const Engine& engine) override { moved_->sample(t, engine); }
    Errors errors() const override {
        const double moved = moved_->errors().primary;
        return {moved < 0.1 ? 1.0 : 0.0, moved};
    }

private:
    std::unique_ptr<Meter> moved_;
};

ExperimentRun falling(Scene scene, double seconds) {
    auto meter = std::make_unique<FallMeter>(scene);
    return {std::move(scene), seconds, std::move(meter)};
}

ExperimentRun loaded_box(double ratio) {
    Scene scene = box_stack(2, half_cube, 1);
    scene.bodies[1] = solid_box(ratio, half_cube, scene.bodies[1].pose.position);
    return standing(std::move(scene), 5);
}

}  // namespace

std::vector<Experiment> stack_experiments() {
    constexpr const char* moved = "largest displacement, m; the same in the horizontal plane, m";
    constexpr const char* fell = "1 when it stands, 0 when it fell; largest displacement, m";
    std::vector<Experiment> all;
    const auto add = [&](const char* name, const char* about, const char* measures,
                         std::vector<double> tolerances,
                         std::function<ExperimentRun(double)> start) {
        all.push_back({.name = name,
                       .about = about,
                       .measures = measures,
                       .tolerances = std::move(tolerances),
                       .start = std::move(start)});
    };
    add("c8", "a stack of ten boxes stands for 5 s", moved, {0.1, 0.01, 0.001},
        [](double) { return standing(box_stack(10, half_cube, 1), 5); });
    add("c9-r100", "a box carries one of 100 times its mass for 5 s", moved, {0.01, 0.001, 1e-4},
        [](double) { return loaded_box(100); });
    add("c9-r1000", "a box carries one of 1000 times its mass for 5 s", moved, {0.01, 0.001, 1e-4},
        [](double) { return loaded_box(1000); });
    add("c10", "two cards lean against each other for 5 s, friction 0.6", moved,
        {0.01, 0.001, 1e-4}, [](double) { return standing(leaning_cards(0.6), 5); });
    add("c10-mu0.17", "the cards with friction 0.17, less than they need", fell, {0.01},
        [](double) { return falling(leaning_cards(0.17), 5); });
    add("c11", "an arch of 15 wedges stands for 10 s", moved, {0.1, 0.01, 0.001},
        [](double) { return standing(arch(2, 2.4), 10); });
    add("c11-thin", "an arch too thin to stand", fell, {0.01},
        [](double) { return falling(arch(2, 2.1), 10); });
    return all;
}

}  // namespace jostle::bench::accuracy
