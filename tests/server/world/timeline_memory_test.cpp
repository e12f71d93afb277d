// SPDX-License-Identifier: MIT
//
// The memory of a timeline, compared with what the allocator counts.
#include <gtest/gtest.h>
#include <malloc.h>

#include "jostle/scenes/catalog.h"
#include "server/world/timeline.h"
#include "tests/support/step_time.h"

// The allocators of sanitizers have no mallinfo2().
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define JOSTLE_COUNTS_MEMORY 1
#else
#define JOSTLE_COUNTS_MEMORY 0
#endif

namespace jostle::server {
namespace {

using test::dt;

std::size_t allocated_bytes() {
#if JOSTLE_COUNTS_MEMORY
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return 0;
#endif
}

// `count` boxes in stacks of ten.
scenes::SceneDescription stacks_of_ten(int count) {
    scenes::SceneDescription scene{.name = "stacks"};
    const auto add = [&](const physics::Geometry& geometry, physics::Vec3 position,
                         physics::BodyType type) {
        scenes::SceneBody body{.name = "box"};
        body.body.pose.position = position;
        body.body.type = type;
        body.shapes.push_back({.geometry = geometry});
        scene.bodies.push_back(std::move(body));
    };
    add(physics::Plane{}, {}, physics::BodyType::static_body);
    for (int k = 0; k < count; k++)
        add(physics::Box{{0.5, 0.5, 0.5}}, {2.0 * (k / 10 % 20), 0.5 + k % 10, 2.0 * (k / 200)},
            physics::BodyType::dynamic);
    return scene;
}

struct Measured {
    std::size_t estimate = 0, real = 0, states = 0;
};

// The memory of the states of 60 s. Each second has the same state.
Measured measure_timeline(const scenes::SceneDescription& scene, std::uint32_t seconds = 60) {
    HostedWorld world = std::move(*HostedWorld::create(scene, {}, 1));
    std::uint32_t tick = 0;
    while (tick < 90) EXPECT_TRUE(world.step(dt, ++tick).ok());
    static_cast<void>(world.host_state(tick));
    const std::size_t before = allocated_bytes();
    Timeline timeline(60, true);
    for (std::uint32_t k = 0; k < 60 * seconds; k++)
        timeline.on_tick(++tick, true, world, seconds, 0);
    const Measured measured{timeline.bytes(), allocated_bytes() - before, timeline.ticks()->size()};
    testing::Test::RecordProperty("bytes_per_state",
                                  std::to_string(measured.real / measured.states));
    return measured;
}

class TimelineMemory : public testing::TestWithParam<const char*> {};

TEST_P(TimelineMemory, is_within_the_estimate) {
    if (!JOSTLE_COUNTS_MEMORY) GTEST_SKIP() << "the allocator does not count";
    const std::string name = GetParam();
    const Measured measured =
        measure_timeline(name == "stacks" ? stacks_of_ten(2000) : *scenes::find_scene(name), 60);
    const double ratio =
        static_cast<double>(measured.estimate) / static_cast<double>(measured.real);
    std::printf("%s: %zu states, %.1f KiB each, estimate %.2f times as much\n", name.c_str(),
                measured.states,
                static_cast<double>(measured.real) / 1024 / static_cast<double>(measured.states),
                ratio);
    EXPECT_GE(ratio, 1);
    EXPECT_LE(ratio, 2);
    EXPECT_LE(measured.estimate, Timeline::bytes_max);
}

INSTANTIATE_TEST_SUITE_P(Scenes, TimelineMemory,
                         testing::Values("stacks", "stack", "pile", "curtain", "fountain",
                                         "bench_ragdolls_40"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace jostle::server
