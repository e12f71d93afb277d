// SPDX-License-Identifier: MIT
//
// The stores agree with each other after every step of a world that is poked in every way the API
// allows; every hundredth step goes through save and load and must come out the same.
#include "physics/src/state/validate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/physics.h"
#include "physics/src/state/world_access.h"
#include "tests/support/random.h"

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

TEST(Validate, stores_are_consistent_after_every_step_with_random_changes) {
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

// A tilted box that lies on a floor, beside another.
World two_boxes() {
    World world;
    const auto add = [&](BodyType type, Vec3 at, const Geometry& geometry) {
        return world.create_body({.type = type, .pose = {at, {}}}, {.geometry = geometry}).value();
    };
    add(BodyType::static_body, {}, Plane{});
    add(BodyType::dynamic, {0, 0.5, 0}, Box{{0.3, 0.5, 0.7}});
    add(BodyType::dynamic, {3, 0.5, 0}, Box{{0.3, 0.5, 0.7}});
    for (int k = 0; k < 3; k++) world.step(1.0 / 60).expect();
    return world;
}

TEST(Validate, reports_states_that_only_forged_bytes_contain) {
    const struct {
        void (*forge)(WorldState&);
        const char* words;
    } forgeries[] = {
        {[](WorldState& w) { w.def.gravity.y = -1e300; }, "gravity"},
        {[](WorldState& w) { w.bodies.cold[1].inertia.x.x = 1e300; }, "inertia"},
        {[](WorldState& w) { w.bodies.cold[1].inertia.x.x = -1; }, "inertia"},
        {[](WorldState& w) { w.bodies.cold[1].inertia.y.y *= 5; }, "inertia"},
        {[](WorldState& w) { w.bodies.cold[1].isotropic = true; }, "not isotropic"},
        {[](WorldState& w) { w.bodies.cold[1].radius *= 0.1; }, "too large for its size"},
        {[](WorldState& w) { w.bodies.cold[1].inner_radius = -1; }, "radius"},
        {[](WorldState& w) { w.bodies.cold[1].radius = 1e30; }, "radius"},
        {[](WorldState& w) { w.bodies.cold[1].local_center.x = 1e30; }, "centre"},
        {[](WorldState& w) { w.bodies.cold[1].mass = 1e300; }, "mass"},
        {[](WorldState& w) { w.bodies.cold[0].mass = 1; }, "not dynamic"},
        {[](WorldState& w) { w.bodies.awake[0].sleep_time = -1; }, "negative time at rest"},
        {[](WorldState& w) { w.bodies.awake[0].center.y = 1e300; }, "too far from the origin"},
        {[](WorldState& w) { w.bodies.motion[1].travel = -1; }, "bound out of range"},
        {[](WorldState& w) { w.bodies.motion[1].travel = 1e300; }, "bound out of range"},
        {[](WorldState& w) { w.bodies.awake[0].v.x = 1e300; },
         "velocity, force or displacement out of range"},
        {[](WorldState& w) { w.contacts.contacts[0].limit = 1e300; }, "limit out of range"},
        {[](WorldState& w) { w.shapes.shapes[1].geometry = Sphere{-1}; }, "radius is -1"},
        {[](WorldState& w) { w.shapes.shapes[1].pose.rotation.w = 3; }, "rotation"},
        {[](WorldState& w) { w.shapes.shapes[1].material.friction = -1; }, "friction"},
        {[](WorldState& w) { w.shapes.shapes[1].fat.low.x = 1e6; }, "fat box"},
        // Twice, and its neighbour not at all.
        {[](WorldState& w) {
             for (const std::uint32_t s : {1u, 2u}) w.shapes.shapes[s].moved = true;
             w.shapes.moved = {1, 1};
         },
         "or is listed twice"},
        // An island whose only body has gone to another one, without being on its list.
        {[](WorldState& w) {
             const std::uint32_t left = w.bodies.cold[2].island;
             w.bodies.cold[2].island = w.bodies.cold[1].island;
             w.islands.ids.alive_flags()[left] = 0;
             w.islands.islands[left] = {};
         },
         "not on an island's list"},
        {[](WorldState& w) { w.overload_level.level = 1; },
         "overload_level is above 0 without a budget"},
        {[](WorldState& w) {
             w.def.step_budget = 100;
             w.overload_level.level = max_overload_level + 1;
         },
         "overload_level is out of range"},
        {[](WorldState& w) { w.def.step_budget = -1; }, "step_budget is out of range"},
    };
    ASSERT_FALSE(find_fault(state_of(two_boxes())));
    for (std::size_t k = 0; k < std::size(forgeries); k++) {
        World world = two_boxes();
        forgeries[k].forge(state_of(world));
        const auto fault = find_fault(state_of(world));
        ASSERT_TRUE(fault) << k << ": nothing is said of " << forgeries[k].words;
        EXPECT_NE(fault->find(forgeries[k].words), std::string::npos) << k << ": " << *fault;
    }
}

}  // namespace jostle::physics
