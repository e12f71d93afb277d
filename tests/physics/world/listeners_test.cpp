// SPDX-License-Identifier: MIT
//
// Listeners and modules are added and removed. What they do: behaviour/listeners_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "jostle/physics/module.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::ElementsAre;
using testing::HasSubstr;

struct Named : Module {
    std::string name;
    explicit Named(std::string tag_name) : name(std::move(tag_name)) {}
    std::string_view tag() const override { return name; }
    void visit(StateVisitor&) override {}
};

TEST(ListenerCalls, listener_is_added_and_removed_once) {
    World world;
    StepListener listener;
    must(world.add_listener(listener));
    EXPECT_THAT(world.add_listener(listener).error().message, HasSubstr("already been added"));
    must(world.remove_listener(listener));
    EXPECT_THAT(world.remove_listener(listener).error().message, HasSubstr("is not registered"));
}

// Each number once, however many threads take part.
TEST(ListenerCalls, parallel_for_runs_each_index_once) {
    for (const int threads : {1, 2, 8}) {
        World world = make_world({.threads = threads});
        for (const int count : {0, 1, 63, 1000}) {
            std::vector<int> done(static_cast<std::size_t>(count));
            world.parallel_for(count, 16, [&](int first, int last) {
                for (int k = first; k < last; k++) done[static_cast<std::size_t>(k)]++;
            });
            EXPECT_EQ(std::count(done.begin(), done.end(), 1), count);
        }
    }
}

// Wants sub-steps in every second step.
struct EverySecond : StepListener {
    int steps = 0, substeps = 0;
    StepHooks hooks() const override { return {.substeps = steps % 2 == 0}; }
    void before_substep(SubstepContext&) override { substeps++; }
    void after_step(World&, double) override { steps++; }
};

TEST(ListenerCalls, hooks_are_queried_in_each_step) {
    World world = make_world({.substeps = 4});
    add(world, {.position = {0, 5, 0}});
    EverySecond listener;
    must(world.add_listener(listener));
    run(world, 6.0 / 60);
    EXPECT_EQ(listener.steps, 6);
    const int of_three_steps = listener.substeps;
    EXPECT_EQ(of_three_steps % 3, 0);
    run(world, 1.0 / 60);
    EXPECT_EQ(listener.substeps, of_three_steps / 3 * 4);
    run(world, 1.0 / 60);
    EXPECT_EQ(listener.substeps, of_three_steps / 3 * 4) << "the eighth wants none";
}

TEST(ListenerCalls, module_is_found_by_tag) {
    World world;
    must(world.add_module(std::make_unique<Named>("wind_farm")));
    must(world.add_module(std::make_unique<Named>("crowd")));
    EXPECT_THAT(world.modules(), ElementsAre("wind_farm", "crowd"));
    ASSERT_NE(world.module("crowd"), nullptr);
    EXPECT_EQ(world.module("crowds"), nullptr);
    EXPECT_THAT(world.add_module(std::make_unique<Named>("crowd")).error().message,
                HasSubstr("already has a module \"crowd\""));
    EXPECT_THAT(world.add_module(std::make_unique<Named>("Crowd!")).error().message,
                HasSubstr("\"Crowd!\"; it must be 1 to 32 characters of a-z, 0-9 and _"));
    EXPECT_THAT(world.add_module(nullptr).error().message, HasSubstr("null"));
    EXPECT_THAT(world.remove_listener(*world.module("crowd")).error().message,
                HasSubstr("remove_module"));
    must(world.remove_module("wind_farm"));
    EXPECT_THAT(world.modules(), ElementsAre("crowd"));
    EXPECT_THAT(world.remove_module("wind_farm").error().message, HasSubstr("no module"));
}

}  // namespace
}  // namespace jostle::test
