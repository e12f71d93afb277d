// SPDX-License-Identifier: MIT
#include "server/world/sync_module_entities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "jostle/physics/module.h"
#include "jostle/scenes/catalog.h"
#include "server/world/hosted_world.h"
#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using namespace physics;

using test::dt;

// Does to the world, before and after a step, what a test asks.
class Maker final : public Module {
public:
    std::string_view tag() const override { return "maker"; }
    void visit(StateVisitor&) override {}
    Status configure(World& world, const ModuleSettings&) override {
        made.push_back(make(world));
        return {};
    }
    void before_step(World& world, double) override {
        if (before) before(world);
    }
    void after_step(World& world, double) override {
        if (after) after(world);
    }

    static BodyId make(World& world) {
        return world.create_body({.pose = {.position = {50, 50, 50}}}, {.geometry = Sphere{0.5}})
            .value();
    }

    std::vector<BodyId> made;
    std::function<void(World&)> before, after;
};

Maker* newest = nullptr;

class SyncModuleEntitiesTest : public testing::Test {
protected:
    static HostedWorld make_world() {
        static const Status known = register_module("maker", [] {
            auto maker = std::make_unique<Maker>();
            newest = maker.get();
            return maker;
        });
        known.expect();
        scenes::SceneDescription scene = *scenes::find_scene("stack");
        scene.modules = {{.tag = "maker"}};
        return HostedWorld::create(scene, {}, 1).value();
    }
    // Each entity of a frame is in its list, and the other way round.
    Frame step() {
        EXPECT_TRUE(world.step(dt).ok());
        Frame frame;
        world.copy_into(frame);
        EXPECT_EQ(frame.entities.size(), frame.entity_list->size());
        for (std::size_t i = 0; i < frame.entities.size(); i++)
            EXPECT_EQ(frame.entities[i].id, (*frame.entity_list)[i]->id);
        return frame;
    }
    InputResult apply(Action action) {
        return world.apply(
            {.client = 1, .sequence = ++sequence, .action = std::move(action), .reply = {}}, 7);
    }

    HostedWorld world = make_world();
    Maker& maker = *newest;
    const std::size_t of_scene = scenes::find_scene("stack")->bodies.size();
    std::uint32_t sequence = 0;
};

TEST_F(SyncModuleEntitiesTest, bodies_created_by_modules_become_scene_entities) {
    EXPECT_EQ(step().entities.size(), of_scene + 1) << "made when it was configured";
    maker.before = [&](World& w) { maker.made.push_back(Maker::make(w)); };
    const Frame frame = step();
    EXPECT_EQ(frame.entities.size(), of_scene + 2);
    EXPECT_EQ(frame.entity_list->back()->owner, 0u);
    maker.before = {};
    EXPECT_EQ(step().entity_list, frame.entity_list) << "nobody came or went: the same list";
}

TEST_F(SyncModuleEntitiesTest, bodies_removed_by_modules_lose_entity_and_grabs) {
    const EntityId ball = step().entities.back().id;
    EXPECT_TRUE(apply(GrabCommand{ball, {50, 50, 50}}).status.ok());
    maker.after = [&](World& w) { w.destroy_body(maker.made[0]).expect(); };
    const Frame frame = step();
    maker.after = {};
    EXPECT_EQ(frame.entities.size(), of_scene);
    EXPECT_FALSE(apply(DragCommand{}).status.ok());
    EXPECT_FALSE(
        apply(ImpulseCommand{.entity = ball, .impulse = {1, 0, 0}, .point = {}}).status.ok());
    EXPECT_TRUE(apply(ExplodeCommand{.center = {50, 50, 50}, .radius = 9, .speed = 1}).status.ok());
    step();
}

TEST_F(SyncModuleEntitiesTest, replaced_body_becomes_a_new_entity) {
    const EntityId old = step().entities.back().id;
    maker.before = [&](World& w) {
        w.destroy_body(maker.made[0]).expect();
        const BodyId next = Maker::make(w);
        EXPECT_EQ(next.index, maker.made[0].index) << "the world reuses it";
        maker.made[0] = next;
    };
    const Frame frame = step();
    EXPECT_EQ(frame.entities.size(), of_scene + 1);
    EXPECT_GT(frame.entities.back().id, old);
}

TEST_F(SyncModuleEntitiesTest, events_resolve_bodies_created_and_removed_within_one_step) {
    maker.before = [&](World& w) { maker.made.push_back(Maker::make(w)); };
    maker.after = [&](World& w) { w.destroy_body(maker.made.back()).expect(); };
    EXPECT_EQ(step().entities.size(), of_scene + 1);
    const auto events = world.events_of_step(7);  // the two touched
    ASSERT_TRUE(events);
    ASSERT_FALSE(events->contacts_began.empty());
    const auto& touch = events->contacts_began.back();
    EXPECT_EQ(std::min(touch.a, touch.b), 0u) << "nobody was told of it";
}

}  // namespace
}  // namespace jostle::server
