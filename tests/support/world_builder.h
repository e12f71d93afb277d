// SPDX-License-Identifier: MIT
//
// Short functions that build worlds for tests: a floor, a body, some seconds. A rejected call ends
// the test with a failure.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include "jostle/physics/physics.h"

namespace jostle::test {

// Ends a test whose setup fails, by an exception with the reason where exceptions are available.
[[noreturn]] inline void give_up(const std::string& why) {
#if defined(__cpp_exceptions)
    throw std::runtime_error(why);
#else
    std::fprintf(stderr, "%s\n", why.c_str());
    std::abort();
#endif
}
// The value, or an exception whose message gtest reports.
template <class T>
T must(physics::Result<T> result) {
    if (!result.ok()) give_up(result.error().message);
    return std::move(*result);
}
inline void must(const physics::Status& status) {
    if (!status.ok()) give_up(status.error().message);
}

// A body with one shape and the properties that tests vary.
struct BuiltBody {
    physics::Geometry geometry = physics::Box{};
    physics::Vec3 position;
    physics::Quat rotation;
    physics::Vec3 velocity;  // m/s
    physics::Vec3 spin;      // rad/s
    double friction = 0.5;
    double restitution = 0;
    double density = 1000;  // kg/m^3
    physics::BodyType type = physics::BodyType::dynamic;
    bool sleep_allowed = true;
};

inline physics::World make_world(const physics::WorldDef& def = {}) {
    return must(physics::World::create(def));
}

inline physics::BodyId add(physics::World& world, const BuiltBody& part) {
    return must(world.create_body({.type = part.type,
                                   .pose = {part.position, part.rotation},
                                   .linear_velocity = part.velocity,
                                   .angular_velocity = part.spin,
                                   .sleep_allowed = part.sleep_allowed},
                                  {.geometry = part.geometry,
                                   .material = {part.friction, part.restitution},
                                   .density = part.density}));
}

// The plane y = 0.
inline physics::BodyId add_floor(physics::World& world, double friction = 0.5,
                                 double restitution = 0) {
    return add(world, {.geometry = physics::Plane{},
                       .friction = friction,
                       .restitution = restitution,
                       .type = physics::BodyType::static_body});
}

// A body that never moves.
inline physics::BodyId add_static(physics::World& world, BuiltBody part) {
    part.type = physics::BodyType::static_body;
    return add(world, part);
}

inline void run(physics::World& world, double seconds, double hz = 60) {
    const int steps = static_cast<int>(seconds * hz + 0.5);
    for (int i = 0; i < steps; i++) must(world.step(1 / hz));
}

inline physics::BodyState state_of(const physics::World& world, physics::BodyId body) {
    return must(world.body(body));
}
inline physics::Vec3 position_of(const physics::World& world, physics::BodyId body) {
    return state_of(world, body).pose.position;
}
inline physics::Vec3 velocity_of(const physics::World& world, physics::BodyId body) {
    return state_of(world, body).linear_velocity;
}

// Gravity of 9.81 m/s^2 at the angle atan(slope) from straight down towards `azimuth` (rad, from x
// to z). The floor is then an incline in a direction that no axis shares.
inline physics::Vec3 leaning_gravity(double slope, double azimuth) {
    const double cosine = 1 / physics::square_root(1 + slope * slope);
    const physics::SinCos a = physics::sin_cos(azimuth);
    return physics::Vec3{slope * a.cos, -1, slope * a.sin} * (9.81 * cosine);
}

}  // namespace jostle::test
