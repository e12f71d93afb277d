// SPDX-License-Identifier: MIT
#include "server/world/entity_registry.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace physics;

class EntityRegistryTest : public testing::Test {
protected:
    EntityId add(ClientId owner = 0) {
        body = *world.create_body({.pose = {.position = {0, 5, 0}}}, {.geometry = Sphere{0.5}});
        return entities.add(world, body, owner, 0xff0000, "ball");
    }
    void remove(EntityId id) {
        const BodyId gone = entities.find(id)->body;
        entities.remove(id);
        ASSERT_TRUE(world.destroy_body(gone).ok());
    }

    World world = std::move(*World::create());
    EntityRegistry entities;
    BodyId body;  // of the newest
};

TEST_F(EntityRegistryTest, finds_entities_by_id_and_body) {
    const EntityId ball = add(7);
    EXPECT_EQ(ball, 1u);
    const EntityDescription& told = *entities.find(ball)->description;
    EXPECT_EQ(told.id, ball);
    EXPECT_EQ(told.owner, 7u);
    EXPECT_EQ(told.name, "ball");
    EXPECT_EQ(told.shapes.size(), 1u);
    EXPECT_NEAR(told.mass, world.body(body)->mass, 1e-9);
    EXPECT_EQ(entities.entity_of(body), ball);
    EXPECT_EQ(entities.by_body()[body.index], ball);
}

TEST_F(EntityRegistryTest, never_reuses_ids_when_body_indices_are_reused) {
    const EntityId first = add();
    const BodyId old = body;
    remove(first);
    const EntityId second = add();
    EXPECT_EQ(body.index, old.index) << "the world reuses it";
    EXPECT_EQ(second, first + 1);
    EXPECT_EQ(entities.find(first), nullptr);
    EXPECT_EQ(entities.entity_of(body), second);
}

TEST_F(EntityRegistryTest, removed_bodies_remain_resolvable_for_one_step) {
    const EntityId ball = add();
    const BodyId gone = body;
    remove(ball);
    EXPECT_EQ(entities.by_body()[gone.index], 0u);
    entities.on_step();
    EXPECT_EQ(entities.entity_of(gone), ball) << "this step's events may name it";
    entities.on_step();
    EXPECT_EQ(entities.entity_of(gone), 0u);
}

TEST_F(EntityRegistryTest, find_living_ignores_removed_bodies) {
    const EntityId ball = add();
    const BodyId old = body;
    EXPECT_EQ(entities.find_living(old), ball);
    remove(ball);
    entities.on_step();
    EXPECT_EQ(entities.find_living(old), 0u) << "events may name it still";
    const EntityId next = add();
    EXPECT_EQ(body.index, old.index);
    EXPECT_EQ(entities.find_living(old), 0u) << "the index is another's by now";
    EXPECT_EQ(entities.find_living(body), next);
    EXPECT_EQ(entities.find_living({}), 0u);
    EXPECT_EQ(entities.find_living({1000, 1}), 0u);
}

TEST_F(EntityRegistryTest, list_changes_only_when_entities_are_added_or_removed) {
    const EntityId one = add(), two = add();
    const auto list = entities.list();
    const auto shape_owners = entities.shape_owners();
    ASSERT_EQ(list->size(), 2u);
    EXPECT_EQ(list->front()->id, one);
    EXPECT_EQ(list->back()->id, two);
    EXPECT_EQ((*shape_owners)[list->back()->shapes.front().id.index].entity, two);
    EXPECT_EQ(entities.list(), list);
    EXPECT_EQ(entities.shape_owners(), shape_owners);
    remove(one);
    EXPECT_NE(entities.list(), list);
    EXPECT_EQ(entities.list()->size(), 1u);
    EXPECT_EQ(list->size(), 2u) << "those who hold the old one keep it";
}

}  // namespace
}  // namespace jostle::server
