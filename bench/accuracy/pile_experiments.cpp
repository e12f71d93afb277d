// SPDX-License-Identifier: MIT
//
// C12 to C14: many bodies, with aggregate error measures.
#include <cmath>
#include <random>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/meters.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

constexpr double pile_ball_radius = 0.1;

// Unlike the distributions of the standard library, it generates the same numbers in every
// implementation.
class Jitter {
public:
    explicit Jitter(unsigned seed) : engine_(seed) {}
    double operator()(double most) {  // -most to most
        return most * (2 * (static_cast<double>(engine_()) / 4294967295.0) - 1);
    }

private:
    std::mt19937 engine_;
};

// --- C12 and C13 ---

Scene lattice_of_balls(double restitution, double height) {
    Scene scene{.name = "balls", .restitution = restitution};
    Jitter jitter(42);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++)
            for (int k = 0; k < 6; k++) {
                const double x = 0.21 * i + jitter(1e-3), y = 0.21 * j + jitter(1e-3);
                scene.bodies.push_back(
                    solid_sphere(10, pile_ball_radius, {x, y, 0.101 + 0.21 * k + height}));
            }
    scene.bodies.push_back(fixed_plane());
    return scene;
}

class PenetrationMeter final : public Meter {
public:
    explicit PenetrationMeter(std::size_t balls) : at_(balls) {}

    void sample(double, const Engine& engine) override {
        for (std::size_t k = 0; k < at_.size(); k++)
            at_[k] = engine.state(static_cast<int>(k)).position;
        double deepest = 0;
        for (std::size_t i = 0; i < at_.size(); i++) {
            deepest = std::max(deepest, pile_ball_radius - at_[i].z);
            for (std::size_t j = 0; j < i; j++) {
                const double distance_squared = length_squared(at_[i] - at_[j]);
                if (distance_squared < 4 * pile_ball_radius * pile_ball_radius)
                    deepest = std::max(deepest, 2 * pile_ball_radius - std::sqrt(distance_squared));
            }
        }
        sum_ += deepest;
        most_ = std::max(most_, deepest);
        count_++;
    }
    Errors errors() const override {
        return {sum_ / count_ / pile_ball_radius, most_ / pile_ball_radius};
    }

private:
    std::vector<Vec3> at_;
    double sum_ = 0, most_ = 0;
    int count_ = 0;
};

class EnergyMeter final : public Meter {
public:
    explicit EnergyMeter(const Scene& scene) : scene_(scene) {
        for (const Body& body : scene.bodies)
            if (body.motion == Motion::free) start_ += body.mass * g * body.pose.position.z;
    }
    void sample(double, const Engine& engine) override {
        const double error = std::abs(energy(scene_, engine) / start_ - 1);
        sum_ += error;
        most_ = std::max(most_, error);
        count_++;
    }
    Errors errors() const override { return {sum_ / count_, most_}; }

private:
    Scene scene_;
    double start_ = 0, sum_ = 0, most_ = 0;
    int count_ = 0;
};

ExperimentRun settling(double) {
    Scene scene = lattice_of_balls(0, 0);
    auto meter = std::make_unique<PenetrationMeter>(scene.bodies.size() - 1);
    return {std::move(scene), 5, std::move(meter)};
}

ExperimentRun elastic(double) {
    Scene scene = lattice_of_balls(1, 1);
    auto meter = std::make_unique<EnergyMeter>(scene);
    return {std::move(scene), 3, std::move(meter)};
}

// --- C14 ---

Scene imploding_boxes(double late) {
    Scene scene{.name = "c14", .gravity = {}, .friction = 0.5, .restitution = 0.5};
    Jitter jitter(7);
    const auto vector = [&](double most) {
        const double x = jitter(most), y = jitter(most);
        return Vec3{x, y, jitter(most)};
    };
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 4; k++) {
                const Vec3 half = Vec3{0.15, 0.15, 0.15} + vector(0.05);
                const Vec3 at = Vec3{i - 1.5, j - 1.5, k - 1.5} + vector(0.1);
                Body box = solid_box(8000 * half.x * half.y * half.z, half, at);
                const Vec3 axis = vector(1);
                box.pose.rotation = physics::from_axis_angle(axis, jitter(pi));
                box.velocity = at * -2.0 + vector(0.3);
                box.spin = vector(3);
                box.pose.position += box.velocity * late;
                scene.bodies.push_back(box);
            }
    return scene;
}

struct Momenta {
    Vec3 linear, angular;
    double linear_sizes = 0, angular_sizes = 0;

    void add(const Body& body, const BodyState& now) {
        const Vec3 p = now.velocity * body.mass;
        const Vec3 l = cross(now.position, p) + spin_momentum(body, now.rotation, now.spin);
        linear += p;
        angular += l;
        linear_sizes += length(p);
        angular_sizes += length(l);
    }
};

class MomentumMeter final : public Meter {
public:
    explicit MomentumMeter(const Scene& scene) : bodies_(scene.bodies) {
        for (const Body& body : bodies_)
            start_.add(body, {body.pose.position, body.pose.rotation, body.velocity, body.spin});
    }
    void sample(double, const Engine& engine) override {
        Momenta now;
        for (std::size_t k = 0; k < bodies_.size(); k++)
            now.add(bodies_[k], engine.state(static_cast<int>(k)));
        const double angular = length(now.angular - start_.angular) / start_.angular_sizes;
        const double linear = length(now.linear - start_.linear) / start_.linear_sizes;
        most_ = {std::max(most_.primary, angular), std::max(most_.secondary, linear)};
    }
    Errors errors() const override { return most_; }

private:
    std::vector<Body> bodies_;
    Momenta start_;
    Errors most_;
};

ExperimentRun implosion(double shift) {
    Scene scene = imploding_boxes(shift);
    auto meter = std::make_unique<MomentumMeter>(scene);
    return {std::move(scene), 3, std::move(meter)};
}

}  // namespace

std::vector<Experiment> pile_experiments() {
    return {
        {.name = "c12",
         .about = "216 balls without friction settle and spread for 5 s",
         .measures = "mean of the deepest overlap / radius; the deepest",
         .tolerances = {0.1, 0.03, 0.01},
         .max_hz = 480,
         .start = settling,
         .short_max_hz = 120},
        {.name = "c13",
         .about = "216 elastic balls fall from 1 m, 3 s",
         .measures = "mean error of the energy; the largest",
         .tolerances = {0.1, 0.01, 0.001},
         .max_hz = 480,
         .start = elastic,
         .short_max_hz = 120},
        {.name = "c14",
         .about = "64 boxes fly into each other, 3 s",
         .measures = "largest drift of angular momentum; of linear momentum",
         .tolerances = {0.01, 1e-6, 1e-12},
         .phases = 16,
         .max_hz = 960,
         .start = implosion,
         .short_max_hz = 120},
    };
}

}  // namespace jostle::bench::accuracy
