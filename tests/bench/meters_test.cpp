// SPDX-License-Identifier: MIT
//
// Meters of the experiments: an engine with the exact solution has no error, and a motion with a
// known deviation has that error.
#include "bench/accuracy/meters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment_list.h"

namespace {

using namespace jostle::bench::accuracy;
using jostle::physics::pi;

// The state of a body as a function of time.
using Motion3 = std::function<BodyState(int body, double t)>;

class ScriptedEngine final : public Engine {
public:
    explicit ScriptedEngine(Motion3 motion) : motion_(std::move(motion)) {}
    jostle::Status build(const Scene&, const std::string&) override { return {}; }
    void step(double dt) override { t_ += dt; }
    BodyState state(int body) const override { return motion_(body, t_); }
    void set_damping(double) override {}
    void set_velocity(int, Vec3) override {}
    double time() const { return t_; }

private:
    Motion3 motion_;
    double t_ = 0;
};

Errors errors_of(const char* name, const Motion3& motion, double rate_hz = 60) {
    const ExperimentRun start = find_experiment(name)->start(0);
    ScriptedEngine engine(motion);
    const long steps = std::lround(start.seconds * rate_hz);
    for (long k = 0; k < steps; k++) {
        engine.step(1 / rate_hz);
        start.meter->sample(static_cast<double>(k + 1) / rate_hz, engine);
    }
    return start.meter->errors();
}

const Vec3 heading = azimuth(pi / 6);

TEST(Meters, symplectic_euler_free_fall_error_is_g_t_dt_over_2) {
    const auto exact = [](int, double t) {
        return BodyState{.position = {3 * t, 4 * t, 5 * t - 0.5 * g * t * t}};
    };
    EXPECT_LT(errors_of("f1", exact).primary, 1e-12);
    const auto euler = [&](int body, double t) {
        BodyState state = exact(body, t);
        state.position.z -= 0.5 * g * t / 60;
        return state;
    };
    EXPECT_NEAR(errors_of("f1", euler).primary, 0.1635, 1e-4);
}

TEST(Meters, measures_spring_position_and_energy_error) {
    const auto exact = [](int, double t) {
        return BodyState{.position = {std::cos(2 * pi * t), 0, 0},
                         .velocity = {-2 * pi * std::sin(2 * pi * t), 0, 0}};
    };
    EXPECT_LT(errors_of("f2-1", exact).primary, 1e-12);
    EXPECT_LT(errors_of("f2-1", exact).secondary, 1e-12);
    const auto still = [](int, double) { return BodyState{}; };
    EXPECT_NEAR(errors_of("f2-1", still).primary, std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(errors_of("f2-1", still).secondary, 1, 1e-12);
}

// Slides for 0.4854133 s, rolls at 25/7 m/s: 7.4895810 m in 2 s.
TEST(Meters, measures_sliding_and_rolling_ball) {
    const auto exact = [](int, double t) {
        const double slides = 2 * 5 / (7 * 0.3 * g), slow = std::min(t, slides);
        const double way = 5 * slow - 0.5 * 0.3 * g * slow * slow + 25.0 / 7 * (t - slow);
        return BodyState{.position = heading * way, .velocity = heading * (25.0 / 7)};
    };
    const auto [error, speed] = errors_of("c1", exact);
    EXPECT_LT(error, 1e-8);
    EXPECT_LT(speed, 1e-12);
    EXPECT_NEAR(2 * 5 / (7 * 0.3 * g), 0.4854133, 5e-8);
    EXPECT_NEAR(length(exact(0, 2).position), 7.4895810, 1e-7);
}

// 0.9396276 m/s^2 along the slope; 5 m/s end after 3.1855 m.
TEST(Meters, measures_stopping_distance_of_boxes) {
    const auto slides = [](int, double t) {
        return BodyState{.position = heading * (0.5 * 0.9396276 * t * t) + Vec3{0, 0, 0.25}};
    };
    EXPECT_LT(errors_of("c3", slides).primary, 1e-7);
    EXPECT_LT(errors_of("c3", slides).secondary, 1e-12);
    const auto stops = [](int, double) {
        return BodyState{.position = heading * 3.1855 + Vec3{0, 0, 0.04}};
    };
    EXPECT_LT(errors_of("c4", stops).primary, 1e-5);
    EXPECT_NEAR(errors_of("c4", stops).secondary, 0.01, 1e-12);
    const auto creeps = [](int, double t) {
        return BodyState{.position = {3e-3 * t / 5, 4e-3 * t / 5, 0.25}};
    };
    EXPECT_NEAR(errors_of("c2", creeps).primary, 5e-3, 1e-12);
}

// Steps that miss an apex cause no error: the parabola through three samples determines it.
TEST(Meters, measures_bounce_apexes) {
    const auto bounces = [](double keep) {
        return [keep](int, double t) {
            double speed = 0, height = 1, left = t;  // s of this flight since its start
            double flight = std::sqrt(2 / g);
            while (left > flight) {
                left -= flight;
                speed = keep * (speed == 0 ? std::sqrt(2 * g) : speed);
                height = 0;
                flight = 2 * speed / g;
            }
            return BodyState{
                .position = {0, 0, 0.1 + height + speed * left - 0.5 * g * left * left},
                .velocity = {0, 0, speed - g * left}};
        };
    };
    EXPECT_LT(errors_of("c5-e0.8", bounces(0.8)).primary, 1e-9);
    EXPECT_LT(errors_of("c5-e0.8", bounces(0.8), 30).primary, 1e-9);
    EXPECT_GT(errors_of("c5-e0.8", bounces(0.78)).primary, 0.1);
    const auto energy_of_flight = errors_of("c5-e1", bounces(1));
    EXPECT_LT(energy_of_flight.primary, 1e-9);
}

TEST(Meters, measures_velocities_after_impacts) {
    const double angle = 37 * pi / 180;
    const auto billiard = [&](int body, double) {
        const Vec3 normal = azimuth(angle + pi / 6), before = azimuth(angle) * 5;
        const Vec3 of_b = normal * dot(before, normal);
        return BodyState{.velocity = body == 1 ? of_b : before - of_b};
    };
    EXPECT_LT(errors_of("c6", billiard).primary, 1e-12);
    EXPECT_LT(errors_of("c6", billiard).secondary, 1e-12);
    const auto cradle = [](int body, double) {
        return BodyState{.velocity = {body == 4 ? 1.0 : 0.0, 0, 0}};
    };
    EXPECT_LT(errors_of("c7", cradle).primary, 1e-12);
    const auto stuck = [](int, double) { return BodyState{.velocity = {0.2, 0, 0}}; };
    EXPECT_NEAR(errors_of("c7", stuck).primary, std::sqrt(4 * 0.04 + 0.64), 1e-12);
}

TEST(Meters, measures_resting_and_falling_bodies) {
    const Scene stack = find_experiment("c8")->start(0).scene;
    const auto sunk = [&](int body, double) {
        BodyState state{.position = stack.bodies[static_cast<std::size_t>(body)].pose.position};
        if (body == 3) state.position += {0.03, 0, -0.04};
        return state;
    };
    EXPECT_NEAR(errors_of("c8", sunk).primary, 0.05, 1e-12);
    EXPECT_NEAR(errors_of("c8", sunk).secondary, 0.03, 1e-12);
    const auto fallen = [](int, double) { return BodyState{}; };
    EXPECT_EQ(errors_of("c10-mu0.17", fallen).primary, 0);
    const Scene cards = find_experiment("c10-mu0.17")->start(0).scene;
    const auto stands = [&](int body, double) {
        return BodyState{.position = cards.bodies[static_cast<std::size_t>(body)].pose.position};
    };
    EXPECT_EQ(errors_of("c10-mu0.17", stands).primary, 1);
}

TEST(Meters, measures_gaps_between_joint_anchors) {
    Scene scene;
    scene.bodies = {without_shape(solid_box(1, {0.1, 0.1, 0.5}, {0, 0, -0.5}))};
    scene.joints = {ball_at(ground, 0, {})};
    ScriptedEngine engine([](int, double) { return BodyState{.position = {0.3, 0, -0.9}}; });
    GapMeter gaps(scene);
    gaps.sample(engine);
    EXPECT_NEAR(gaps.most(), 0.5, 1e-12);
}

}  // namespace
