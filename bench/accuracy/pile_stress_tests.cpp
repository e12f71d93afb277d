// SPDX-License-Identifier: MIT
//
// S18 and S20: a compressed pile, and a pile of very unequal masses.
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/meters.h"
#include "bench/accuracy/stress_test.h"
#include "bench/measure.h"

namespace jostle::bench::accuracy {
namespace {

constexpr double rate_hz = 60;

// Uniform in [0, 1), the same with every standard library.
class Uniform {
public:
    double operator()() { return static_cast<double>(engine_()) / 4294967296.0; }

private:
    std::mt19937 engine_{18};
};

// --- S18 ---

// 200 cubes and balls of 0.2 m in a closed box, 1 m high. Its four walls move inwards until the
// solids take 95 % of its volume, stay, and move back. Solids of one size do not pack that densely:
// they must overlap without being thrown apart.
constexpr int solids = 200;
constexpr double half_size = 0.1, height = 1, wall = 0.25;
constexpr double start_half = 0.95, wall_speed = 0.2;

struct Squeeze {
    Scene scene;
    double closed_half = 0;
};

Squeeze squeezed_pile() {
    Squeeze squeeze{.scene = {.name = "jam", .friction = 0.5}};
    Uniform uniform;
    double volume = 0;
    for (int k = 0; k < solids; k++) {
        const Vec3 at{-0.77 + 0.22 * (k % 8), -0.77 + 0.22 * (k / 8 % 8), 0.12 + 0.22 * (k / 64)};
        const bool ball = k % 2 == 0;
        Body body = ball ? solid_sphere(4.2, half_size, at)
                         : solid_box(8, {half_size, half_size, half_size}, at);
        if (!ball) body.pose.rotation = physics::from_axis_angle({0, 0, 1}, 0.2 * uniform());
        volume += ball ? 4.0 / 3 * physics::pi * std::pow(half_size, 3) : std::pow(0.2, 3);
        squeeze.scene.bodies.push_back(std::move(body));
    }
    squeeze.closed_half = 0.5 * std::sqrt(volume / 0.95 / height);
    squeeze.scene.bodies.push_back(fixed_plane());
    squeeze.scene.bodies.push_back(fixed_box({3, 3, wall}, {0, 0, height + wall}));
    for (int side = 0; side < 4; side++) {
        const Vec3 out = azimuth(0.5 * physics::pi * side);
        const bool along_x = side % 2 == 0;
        Body moving = fixed_box({along_x ? wall : 2, along_x ? 2 : wall, 0.45 * height},
                                out * (start_half + wall) + Vec3{0, 0, 0.5 * height});
        moving.motion = Motion::kinematic;
        squeeze.scene.bodies.push_back(std::move(moving));
    }
    return squeeze;
}

struct Pile {
    double fastest = 0, fastest_at_end = 0;
    int outside = 0;
};

void move_walls(Engine& engine, double speed) {
    for (int side = 0; side < 4; side++)
        engine.set_velocity(solids + 2 + side, azimuth(0.5 * physics::pi * side) * speed);
}

Verdict jam(const EngineKind& kind, const std::string& mode) {
    const Squeeze squeeze = squeezed_pile();
    const auto engine = kind.make();
    if (const auto status = engine->build(squeeze.scene, mode); !status)
        return {.unsupported = status.error().message};
    const double travel = (start_half - squeeze.closed_half) / wall_speed;
    const long in = std::lround(travel * rate_hz), hold = in + 60, out = hold + in, end = out + 120;
    Pile pile;
    const double began = cpu_seconds();
    for (long k = 0; k < end; k++) {
        if (k == 0) move_walls(*engine, -wall_speed);
        if (k == in || k == out) move_walls(*engine, 0);
        if (k == hold) move_walls(*engine, wall_speed);
        engine->step(1 / rate_hz);
        pile.fastest_at_end = 0;
        for (int body = 0; body < solids; body++) {
            const BodyState now = engine->state(body);
            if (!(length(now.position) < 1e5)) return {.why = "a body is lost"};
            pile.fastest_at_end = std::max(pile.fastest_at_end, length(now.velocity));
        }
        pile.fastest = std::max(pile.fastest, pile.fastest_at_end);
        if (cpu_seconds() - began > 120) return {.why = "takes too long"};
    }
    for (int body = 0; body < solids; body++) {
        const Vec3 at = engine->state(body).position;
        const bool in_pen =
            std::abs(at.x) < start_half && std::abs(at.y) < start_half && at.z > 0 && at.z < height;
        pile.outside += !in_pen;
    }
    Verdict verdict{.pass = pile.fastest < 10, .figure = pile.fastest};
    if (pile.outside > 0) verdict.why = std::to_string(pile.outside) + " bodies are outside";
    if (pile.fastest_at_end > 1) verdict.why = "bodies do not come to rest";
    verdict.pass = verdict.pass && verdict.why.empty();
    return verdict;
}

// --- S20 ---

// A hundred balls of 0.1 m, 1 g to 1000 t, fall into a pen of 1.1 m.
constexpr double ball_radius = 0.1, pen_half = 0.55;

class PenMeter final : public Meter {
public:
    explicit PenMeter(int balls) : at_(static_cast<std::size_t>(balls)) {}

    void sample(double t, const Engine& engine) override {
        if (t < 9) return;  // the pile settles until then
        for (std::size_t k = 0; k < at_.size(); k++) {
            at_[k] = engine.state(static_cast<int>(k)).position;
            const double side = std::max(std::abs(at_[k].x), std::abs(at_[k].y));
            deepest_ = std::max({deepest_, ball_radius - at_[k].z, side + ball_radius - pen_half});
            for (std::size_t j = 0; j < k; j++)
                deepest_ = std::max(deepest_, 2 * ball_radius - length(at_[k] - at_[j]));
        }
    }
    Errors errors() const override { return {deepest_ / ball_radius, 0}; }

private:
    std::vector<Vec3> at_;
    double deepest_ = 0;
};

ExperimentRun unequal_masses() {
    constexpr int count = 100;
    Scene scene{.name = "masses", .friction = 0.5};
    Uniform uniform;
    for (int k = 0; k < count; k++) {
        const Vec3 cell{-0.42 + 0.21 * (k % 5), -0.42 + 0.21 * (k / 5 % 5), 0.12 + 0.21 * (k / 25)};
        const Vec3 jitter{1e-3 * uniform(), 1e-3 * uniform(), 0};
        scene.bodies.push_back(
            solid_sphere(std::pow(10, -3 + 9 * uniform()), ball_radius, cell + jitter));
    }
    scene.bodies.push_back(fixed_plane());
    for (int side = 0; side < 4; side++) {
        const bool along_x = side % 2 == 0;
        scene.bodies.push_back(
            fixed_box({along_x ? 0.5 : 2, along_x ? 2 : 0.5, 2},
                      azimuth(0.5 * physics::pi * side) * (pen_half + 0.5) + Vec3{0, 0, 2}));
    }
    auto meter = std::make_unique<PenMeter>(count);
    return {std::move(scene), 10, std::move(meter)};
}

}  // namespace

std::vector<StressTest> pile_stress_tests() {
    const StressRun masses{.start = unequal_masses, .limit = 0.05};
    return {{.id = "s18",
             .about = "200 solids compressed to 95 % of the volume, then released, 60 Hz",
             .figure = "highest speed, m/s; all come to rest inside",
             .limit = 10,
             .run = jam},
            {.id = "s20",
             .about = "a hundred balls of 1 g to 1000 t in a pen, 60 Hz, 10 s",
             .figure = "deepest overlap of the last second / radius",
             .limit = masses.limit,
             .run = [masses](const EngineKind& kind, const std::string& mode) {
                 return run_stress(masses, kind, mode);
             }}};
}

}  // namespace jostle::bench::accuracy
