// SPDX-License-Identifier: MIT
//
// A world with characters, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>

#include "jostle/modules/character.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {

inline constexpr double hz = 60;

struct Stage {
    explicit Stage(const physics::WorldDef& def = {}) : world(test::make_world(def)) {
        auto made = std::make_unique<Characters>();
        crowd = made.get();
        test::must(world.add_module(std::move(made)));
    }
    CharacterId add(const CharacterDef& def) { return test::must(crowd->add(world, def)); }
    void steer(CharacterId id, const CharacterControls& controls) {
        test::must(crowd->set_controls(id, controls));
    }
    void walk(CharacterId id, physics::Vec3 velocity) { steer(id, {.walk = velocity}); }
    CharacterState of(CharacterId id) const { return test::must(crowd->state(world, id)); }
    void run(double seconds, double rate = hz) { test::run(world, seconds, rate); }

    physics::World world;
    Characters* crowd;
};

inline void record(const char* name, double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    testing::Test::RecordProperty(name, text);
}

// A wide slab. Its top is a plane through the origin that rises towards +x by the angle, rad.
inline physics::BodyId add_slope(physics::World& world, double angle) {
    const physics::Quat tilt = physics::from_axis_angle({0, 0, 1}, angle);
    return test::add_static(world, {.geometry = physics::Box{{200, 1, 200}},
                                    .position = physics::rotate(tilt, {0, -1, 0}),
                                    .rotation = tilt});
}
// Position of the feet of a capsule whose skin touches that slope.
inline physics::Vec3 feet_on_slope(double angle, double radius, double x) {
    const physics::SinCos a = physics::sin_cos(angle);
    return {x, x * a.sin / a.cos + radius * (1 / a.cos - 1), 0};
}
inline double radians(double degrees) {
    return degrees * physics::pi / 180;
}

}  // namespace jostle::modules
