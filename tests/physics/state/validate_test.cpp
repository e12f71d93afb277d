// SPDX-License-Identifier: MIT
//
// The stores agree with each other after every step of a world that is poked in every way the API
// allows; every hundredth step goes through save and load and must come out the same.
#include "state/validate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/physics.h"
#include "state/world_access.h"
#include "support/random.h"

namespace jostle::physics {
namespace {

// A busy little world and somebody who meddles with it.
class Meddler {
public:
    explicit Meddler(std::uint32_t seed, int threads)
        : random_(seed), world_(std::move(World::create({.threads = threads}).value())) {
        const auto fixed = [&](Vec3 at, Geometry geometry) {
            ASSERT_TRUE(world_
                            .create_body({.type = BodyType::static_body, .pose = {.position = at}},
                                         {.geometry = geometry})
                            .ok());
        };
        fixed({}, Plane{});
        fixed({3, 0.5, 0}, Box{{1, 0.5, 1}});
        platform_ =
            *world_.create_body({.type = BodyType::kinematic, .pose = {.position = {-3, 1, 0}}},
                                {.geometry = Box{{1, 0.1, 1}}});
    }

    World& world() { return world_; }

    void meddle() {
        const double what = in(0, 1);
        if (what < 0.15 && bodies_.size() < 120) add_body();
        if (what > 0.15 && what < 0.19 && bodies_.size() > 20) {
            const std::size_t i = pick();
            EXPECT_TRUE(world_.destroy_body(bodies_[i]).ok());
            bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(i));
        }
        if (what > 0.19 && what < 0.22 && !bodies_.empty()) {
            const BodyId body = bodies_[pick()];
            const Vec3 impulse{in(-50, 50), in(0, 200), in(-50, 50)};
            if (const auto state = world_.body(body); state->type == BodyType::dynamic) {
                EXPECT_TRUE(world_.apply_impulse(body, impulse, state->center).ok());
            }
        }
        if (what > 0.22 && what < 0.24 && !bodies_.empty()) {
            const Vec3 at{in(-4, 4), in(1, 4), in(-4, 4)};
            EXPECT_TRUE(world_.set_pose(bodies_[pick()], {at, {}}).ok());
        }
        if (what > 0.24 && what < 0.25) {
            const double speed = in(0, 1) < 0.5 ? 0 : in(-0.5, 0.5);
            EXPECT_TRUE(world_.set_velocity(platform_, {speed, 0, 0}, {}).ok());
        }
        if (what > 0.25 && what < 0.255)
            bodies_.push_back(*world_.create_body(
                {.type = BodyType::static_body, .pose = {.position = {in(-4, 4), 0.2, in(-4, 4)}}},
                {.geometry = Box{{0.2, 0.2, 0.2}}}));
    }

private:
    double in(double low, double high) { return random_.in(low, high); }
    std::size_t pick() {
        return static_cast<std::size_t>(in(0, static_cast<double>(bodies_.size())));
    }
    void add_body() {
        Geometry geometry = Sphere{in(0.1, 0.4)};
        if (in(0, 1) < 0.5) geometry = Box{{in(0.1, 0.5), in(0.1, 0.5), in(0.1, 0.5)}};
        if (in(0, 1) < 0.3) geometry = Capsule{in(0.1, 0.3), in(0.1, 0.4)};
        const Material material{.friction = in(0, 1), .restitution = in(0, 1) < 0.3 ? in(0, 1) : 0};
        const Vec3 at{in(-4, 4), in(0.5, 4), in(-4, 4)}, axis{in(-1, 1), in(-1, 1), 1};
        const BodyId body = *world_.create_body({.pose = {at, from_axis_angle(axis, in(0, 6))},
                                                 .linear_velocity = {in(-3, 3), in(-3, 3), 0}},
                                                {.geometry = geometry, .material = material});
        bodies_.push_back(body);
        if (in(0, 1) < 0.2) {
            const ShapeDef second{.geometry = Box{{0.2, 0.2, 0.2}},
                                  .pose = {.position = {0.4, 0, 0}}};
            EXPECT_TRUE(world_.create_shape(body, second).ok());
        }
    }

    test::Random random_;
    World world_;
    BodyId platform_;
    std::vector<BodyId> bodies_;
};

}  // namespace

TEST(Validate, stores_agree_after_every_step_of_a_world_that_is_meddled_with) {
    std::size_t slept = 0, woke = 0;
    for (std::uint32_t seed = 1; seed <= 4; seed++) {
        Meddler meddler(seed * 7919, 1 + static_cast<int>(seed) % 2);
        World& world = meddler.world();
        for (int step = 0; step < 600; step++) {
            meddler.meddle();
            ASSERT_TRUE(world.step(1.0 / 60).ok());
            slept += world.events().fell_asleep.size();
            woke += world.events().woke.size();
            const auto fault = find_fault(state_of(world));
            ASSERT_FALSE(fault) << "seed " << seed << " step " << step << ": " << *fault;
            if (step % 100 != 99) continue;
            Result<World> loaded = load(save(world));
            ASSERT_TRUE(loaded.ok()) << loaded.error().message;
            ASSERT_EQ(state_hash(*loaded), state_hash(world));
            world = std::move(*loaded);  // and go on with the copy
        }
    }
    // The test would prove little if nothing ever slept.
    EXPECT_GT(slept, 100u);
    EXPECT_GT(woke, 100u);
}

}  // namespace jostle::physics
