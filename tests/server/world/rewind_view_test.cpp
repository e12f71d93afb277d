// SPDX-License-Identifier: MIT
//
// Rays into the past of a real world against what they answered then, and what they cost.
#include "server/world/rewind_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <memory>

#include "jostle/scenes/scene.h"
#include "server/world/hosted_world.h"
#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::server {
namespace {

using namespace physics;
using test::dt;

// So many boxes and balls that fly about without weight, over a floor.
scenes::SceneDescription swarm(int bodies) {
    test::Random random(5);
    scenes::SceneDescription scene{.name = "swarm"};
    scene.world.gravity = {};
    const double size = std::cbrt(bodies) * 2;
    for (int i = 0; i < bodies; i++) {
        scenes::SceneBody body;
        body.body.pose = {random.vector(size), random.rotation()};
        body.body.linear_velocity = random.vector(8);
        body.body.angular_velocity = random.vector(4);
        if (i % 2 == 0)
            body.shapes.push_back({.geometry = Box{{0.4, 0.3, 0.2}}});
        else
            body.shapes.push_back({.geometry = Sphere{0.4}});
        scene.bodies.push_back(std::move(body));
    }
    scenes::SceneBody floor;
    floor.body.pose.position = {0, -size - 2, 0};
    floor.body.type = BodyType::static_body;
    floor.shapes.push_back({.geometry = Plane{}});
    scene.bodies.push_back(std::move(floor));
    return scene;
}

// A world that is stepped here, and whose frames go into its ring.
struct SteppedWorld {
    explicit SteppedWorld(int bodies)
        : world(*HostedWorld::create(swarm(bodies),
                                     {.scene = {.bodies_max = 20000,
                                                .work_per_second_max = 1e12,
                                                .first_step_seconds_max = 100}},
                                     1)) {
        show();
    }
    void step() {
        test::must(world.step(dt, tick + 1));
        show();
    }
    void show() {
        auto frame = std::make_shared<Frame>();
        frame->tick = ++tick;
        frame->due = Clock::time_point() + std::chrono::microseconds(tick * 16'667);
        world.copy_into(*frame);
        world.frame_history().put(frame, true);
        newest = frame;
    }
    RewindView view(double at) const {
        const auto whole = static_cast<std::uint32_t>(at);
        return RewindView(*world.frame_history().at({whole, at - whole}));
    }

    HostedWorld world;
    std::uint32_t tick = 0;
    FramePtr newest;
};

Ray random_ray(test::Random& random, double size) {
    return {random.vector(size), random.vector(1.5 * size)};
}

TEST(RewindView, rewound_ray_returns_the_past_result) {
    SteppedWorld stepped(300);
    const double size = 14;
    std::map<std::uint32_t, std::vector<std::pair<Ray, std::optional<RayHit>>>> told;
    test::Random random(9);
    for (int i = 0; i < 20; i++) {
        stepped.step();
        for (int k = 0; k < 60; k++) {
            const Ray ray = random_ray(random, size);
            told[stepped.tick].push_back(
                {ray, test::must(stepped.world.world().queries().cast_ray(ray))});
        }
    }
    int hits = 0;
    for (const auto& [tick, answers] : told) {
        const RewindView view = stepped.view(tick);
        EXPECT_EQ(view.tick(), tick);
        EXPECT_FALSE(view.clamped());
        for (const auto& [ray, then] : answers) {
            const Queries past = test::must(stepped.world.world().queries().with_shapes_at(
                view.shapes(*stepped.newest->entity_list, along_segment(ray.origin, ray.motion))));
            const auto hit = test::must(past.cast_ray(ray));
            ASSERT_EQ(hit.has_value(), then.has_value());
            if (!hit) continue;
            hits++;
            EXPECT_EQ(hit->shape, then->shape);
            EXPECT_NEAR(hit->fraction, then->fraction, 1e-9);
            EXPECT_TRUE(test::near(hit->normal, then->normal, 1e-6));
        }
    }
    EXPECT_GT(hits, 150);
}

TEST(RewindView, interpolates_poses_between_ticks) {
    SteppedWorld stepped(10);
    for (int i = 0; i < 5; i++) stepped.step();
    const Transform a = *stepped.view(3).pose_of(1), b = *stepped.view(4).pose_of(1),
                    between = *stepped.view(3.25).pose_of(1);
    EXPECT_GT(length(b.position - a.position), 0.01);
    EXPECT_TRUE(test::near(between.position, a.position + (b.position - a.position) * 0.25, 1e-12));
    EXPECT_NEAR(norm_squared(between.rotation), 1, 1e-12);
    EXPECT_FALSE(stepped.view(3).pose_of(999));
}

TEST(RewindView, ignores_entities_created_later_or_removed) {
    SteppedWorld stepped(10);
    stepped.step();  // tick 2
    SpawnCommand ball;
    ball.shape.geometry = Sphere{0.5};
    ball.pose.position = {100, 0, 0};
    const InputResult spawned =
        stepped.world.apply({.client = 1, .sequence = 1, .action = ball, .reply = {}}, 3);
    ASSERT_TRUE(spawned.status.ok());
    stepped.step();  // tick 3: it is there
    const auto near_ball = [&](double at) {
        return stepped.view(at)
            .shapes(*stepped.newest->entity_list, along_segment({90, 0, 0}, {20, 0, 0}))
            .size();
    };
    constexpr std::size_t floor_alone = 1;  // has no end
    EXPECT_EQ(near_ball(2), floor_alone) << "newer than that tick";
    EXPECT_EQ(near_ball(3), floor_alone + 1);
    EXPECT_EQ(near_ball(2.5), floor_alone + 1) << "pictures show it where it appears";
    ASSERT_TRUE(
        stepped.world
            .apply(
                {.client = 1, .sequence = 2, .action = DeleteCommand{spawned.entity}, .reply = {}},
                4)
            .status.ok());
    stepped.step();
    EXPECT_EQ(near_ball(3), floor_alone) << "gone by now";
}

TEST(RewindView, does_not_interpolate_teleports) {
    const Transform here{{0, 0, 0}, {}}, there{{5, 0, 0}, {}}, near_by{{1, 0, 0}, {}};
    EXPECT_EQ(interpolate(here, there, 0.9, 1.0 / 60), here) << "5 m in a tick are 300 m/s";
    EXPECT_NEAR(interpolate(here, near_by, 0.9, 1.0 / 60).position.x, 0.9, 1e-12);
}

bool equal(const std::vector<ShapePlacement>& a, const std::vector<ShapePlacement>& b) {
    return std::ranges::equal(a, b, [](const ShapePlacement& x, const ShapePlacement& y) {
        return x.shape == y.shape && x.pose == y.pose;
    });
}

// Long and short rays, along the axes and not, from inside and outside, between and at ticks.
TEST(RewindView, grid_finds_the_same_shapes_as_a_pass_over_all_entities) {
    SteppedWorld stepped(2000);
    for (int i = 0; i < 5; i++) stepped.step();
    test::Random random(4);
    std::size_t found = 0;
    for (int i = 0; i < 600; i++) {
        const RewindView view = stepped.view(2 + i % 5 * 0.5);
        Ray ray = random_ray(random, i % 3 == 0 ? 100 : 25);
        if (i % 4 == 0) ray.motion = {0, -60, 0};
        if (i % 7 == 0) ray.motion = {i % 2 ? 80.0 : -80.0, 0, 0};
        if (i % 11 == 0) ray.origin.x += 9e3;
        const auto& now = *stepped.newest->entity_list;
        const auto slow = view.shapes(now, along_segment(ray.origin, ray.motion));
        ASSERT_TRUE(equal(view.shapes_along_segment(now, ray.origin, ray.motion), slow)) << i;
        found += slow.size() - 1;  // the floor has no end
    }
    EXPECT_GT(found, 150u);
}

// 19,600 boxes on a floor, as a pass over all of them takes 0.4 ms.
TEST(RewindView, a_ray_does_not_visit_all_entities) {
    std::vector<EntityPose> poses;
    for (EntityId id = 1; id <= 19'600; id++)
        poses.push_back(
            {id, false, {{(id % 140) * 1.5, 0.5, static_cast<int>(id / 140) * 1.5}, {}}});
    const PoseGrid grid(poses, std::vector<double>(poses.size(), 0.9));
    std::vector<std::uint32_t> indices;
    grid.append_near_segment({100, 1, 100}, {30, 0, 10}, 0, indices);
    EXPECT_GT(indices.size(), 20u);
    EXPECT_LT(indices.size(), 600u);
    indices.clear();
    grid.append_near_segment({100, 50, 100}, {0, -60, 0}, 0, indices);
    EXPECT_LT(indices.size(), 60u);
}

double cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// The figures of docs/records/performance.md; the bounds are far above them, for slow builds.
TEST(RewindView, ray_among_thousands_of_bodies_takes_a_fraction_of_a_tick) {
    for (const int bodies : {1000, 5000}) {
        SteppedWorld stepped(bodies);
        for (int i = 0; i < 3; i++) stepped.step();
        test::Random random(2);
        const RewindView view = stepped.view(2.5);
        const Queries live = stepped.world.world().queries();
        const double size = std::cbrt(bodies) * 2;
        constexpr int rays = 50;
        int hits = 0;
        double began = cpu_ms();
        for (int i = 0; i < rays; i++) {
            const Ray ray = random_ray(random, size);
            const Queries past = test::must(live.with_shapes_at(
                view.shapes(*stepped.newest->entity_list, along_segment(ray.origin, ray.motion))));
            hits += test::must(past.cast_ray(ray)) ? 1 : 0;
        }
        const double one_ms = (cpu_ms() - began) / rays;
        began = cpu_ms();
        const Queries all = test::must(live.with_shapes_at(
            view.shapes(*stepped.newest->entity_list, [](Vec3, double) { return true; })));
        const double all_ms = cpu_ms() - began;
        began = cpu_ms();
        for (int i = 0; i < 1000; i++)
            hits += test::must(all.cast_ray(random_ray(random, size))) ? 1 : 0;
        const double many_ms = cpu_ms() - began;
        std::printf("%d bodies: a ray %.3f ms; all shapes %.2f ms, then 1000 rays %.2f ms\n",
                    bodies, one_ms, all_ms, many_ms);
        EXPECT_GT(hits, 100);
        EXPECT_LT(one_ms, 10);
        EXPECT_LT(all_ms, 100);
    }
}

}  // namespace
}  // namespace jostle::server
