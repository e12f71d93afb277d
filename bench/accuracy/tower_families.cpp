// SPDX-License-Identifier: MIT
//
// Families of stacks: graded masses, cans, and steps of varying length.
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/row_family.h"
#include "bench/accuracy/stack_scenes.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;
using Scale = Parameter::Scale;

// The largest displacement relative to the size of a body; 1 for stacks that fell, whose pieces may
// lie anywhere.
class RelativeRestMeter final : public Meter {
public:
    RelativeRestMeter(const Scene& scene, double size)
        : moved_(rest_meter(scene, When::ever)), size_(size) {}
    void sample(double t, const Engine& engine) override { moved_->sample(t, engine); }
    Errors errors() const override {
        const Errors moved = moved_->errors();
        return {std::min(moved.primary / size_, 1.0), std::min(moved.secondary / size_, 1.0)};
    }

private:
    std::unique_ptr<Meter> moved_;
    double size_;
};

ExperimentRun standing_tower(Scene scene, double size, double seconds) {
    auto meter = std::make_unique<RelativeRestMeter>(scene, size);
    return {std::move(scene), seconds, std::move(meter)};
}

// Masses from the floor up, between 1 g and 1000 t; the first is 1 kg.
std::vector<double> graded_masses(const Values& v) {
    constexpr double least = 1e-3, most = 1e6;
    const std::string& pattern = v.choice("pattern");
    const int count = v.whole("boxes");
    std::mt19937 random{static_cast<std::uint32_t>(v.whole("order"))};
    std::vector<double> masses = {1};
    for (int k = 1; k < count; k++) {
        double ratio = v["ratio"];
        const bool upper = 2 * k > count;
        if (pattern == "lighter" || (pattern == "heavy middle" && upper) ||
            (pattern == "alternating" && k % 2 == 0) || (pattern == "light middle" && !upper))
            ratio = 1 / ratio;
        if (pattern == "any")
            ratio = std::pow(ratio, 2 * (static_cast<double>(random()) / 0x1p32) - 1);
        masses.push_back(std::clamp(masses.back() * ratio, least, most));
    }
    return masses;
}

ExperimentRun graded_tower(const Values& v) {
    const double half = v["half"];
    Scene scene = box_stack(v.whole("boxes"), Vec3{1, 1, 1} * half, 1);
    const std::vector<double> masses = graded_masses(v);
    for (std::size_t k = 0; k < masses.size(); k++)
        scene.bodies[k] = solid_box(masses[k], Vec3{1, 1, 1} * half, scene.bodies[k].pose.position);
    return standing_tower(std::move(scene), 2 * half, 5);
}

ExperimentRun can_tower(const Values& v) {
    const double radius = v["radius"], half = radius * v["aspect"];
    Scene scene{.name = "cans", .friction = 0.5};
    for (int k = 0; k < v.whole("cans"); k++) {
        Body can = solid_cylinder(v["mass"], radius, half, {0, 0, half * (2 * k + 1)});
        can.pose.rotation = physics::from_axis_angle({1, 0, 0}, 0.5 * pi);
        scene.bodies.push_back(std::move(can));
    }
    scene.bodies.push_back(fixed_plane());
    return standing_tower(std::move(scene), 2 * half, 5);
}

// Lengths relative to the step of the rate, at 60 Hz between 1/15 and 1/1000 s.
double step_factor(const std::string& sequence, double spread, long k) {
    const double cycle = 0.5 - 0.5 * std::cos(2 * pi * static_cast<double>(k) / 48);  // 0 to 1
    if (sequence == "alternating") return k % 2 == 0 ? std::sqrt(spread) : 1 / std::sqrt(spread);
    if (sequence == "slow wave") return std::pow(spread, cycle - 0.5);
    if (sequence == "pauses") return k % 20 == 19 ? 4 : 4 / spread;
    std::mt19937 random{static_cast<std::uint32_t>(k) + 1};
    return std::pow(spread, static_cast<double>(random()) / 0x1p32 - 0.5);  // any
}

ExperimentRun tower_with_varying_steps(const Values& v) {
    const double half = v["half"], spread = v["spread"];
    ExperimentRun run = standing_tower(
        box_stack(v.whole("boxes"), Vec3{1, 1, v["aspect"]} * half, v["mass"]), 2 * half, 5);
    run.step_length = [sequence = v.choice("sequence"), spread](long k, double dt) {
        return std::clamp(dt * step_factor(sequence, spread, k), 1e-3, 1.0 / 15);
    };
    return run;
}

}  // namespace

std::vector<RowFamily> tower_families() {
    constexpr const char* moved =
        "largest displacement / size, 1: fell; the same in the horizontal plane";
    return {
        {.name = "graded",
         .about = "a stack of boxes of graded masses stands for 5 s",
         .measures = moved,
         .tolerances = {0.1, 0.01, 0.001},
         .parameters = {{.name = "pattern",
                         .choices = {"heavier", "lighter", "heavy middle", "light middle",
                                     "alternating", "any"}},
                        {"boxes", 2, 12, Scale::whole},
                        {"ratio", 1, 1000, Scale::logarithmic},
                        {"half, m", 0.1, 0.5},
                        {"order", 1, 1000, Scale::whole}},
         .drawn = 10,
         .limit = 0.01,
         .start = [](const Values& v, double) { return graded_tower(v); }},
        {.name = "cans",
         .about = "a stack of centred cans stands for 5 s",
         .measures = moved,
         .tolerances = {0.1, 0.01, 0.001},
         .parameters = {{"cans", 2, 10, Scale::whole},
                        {"radius, m", 0.1, 0.5},
                        {"aspect", 0.3, 1},
                        {"mass, kg", 0.1, 1000, Scale::logarithmic}},
         .examples = {{10, 0.5, 1, 1}},
         .limit = 0.1,
         .start = [](const Values& v, double) { return can_tower(v); }},
        {.name = "steps",
         .about = "a stack of boxes stands for 5 s while the length of the step varies",
         .measures = moved,
         .tolerances = {0.1, 0.02},
         .parameters = {{.name = "sequence",
                         .choices = {"alternating", "slow wave", "pauses", "any"}},
                        {"boxes", 10, 10, Scale::whole},
                        {"spread", 2, 64, Scale::logarithmic},
                        {"half, m", 0.1, 0.5},
                        {"aspect", 0.5, 1},
                        {"mass, kg", 0.1, 1000, Scale::logarithmic}},
         .examples = {{0, 10, 5, 0.5, 1, 1}},
         .drawn = 8,
         .limit = 0.1,
         .start = [](const Values& v, double) { return tower_with_varying_steps(v); }},
    };
}

}  // namespace jostle::bench::accuracy
