// SPDX-License-Identifier: MIT
//
// What hangs together by joints, and what happens when one goes.
#include "physics/src/state/joint_graph.h"

#include <gtest/gtest.h>

#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Boxes in a row in empty space, 3 m apart.
struct TiedRow {
    World world = make_world({.gravity = {}});
    WorldState& state = state_of(world);
    std::vector<BodyId> boxes;

    explicit TiedRow(int count) {
        for (int k = 0; k < count; k++) boxes.push_back(add(world, {.position = {3.0 * k, 0, 0}}));
    }
    JointId tie(BodyId a, BodyId b, bool collide = false) {
        return must(world.create_joint({.body_a = a,
                                        .body_b = b,
                                        .frame_a = {.position = {1.5, 0, 0}},
                                        .frame_b = {.position = {-1.5, 0, 0}},
                                        .collide_connected = collide}));
    }
    std::vector<std::uint32_t> jointed(std::uint32_t body) {
        const auto found = jointed_with(state.bodies, state.joints, state.scratch, body).bodies;
        return {found.begin(), found.end()};
    }
    std::uint32_t island(std::size_t box) const {
        return state.bodies.cold[boxes[box].index].island;
    }
    std::string fault() const { return find_fault(state).value_or(""); }
};
using Bodies = std::vector<std::uint32_t>;

TEST(JointGraph, chain_is_found_from_any_link_in_order) {
    TiedRow row(5);
    row.tie(row.boxes[3], row.boxes[2]);
    row.tie(row.boxes[1], row.boxes[2]);
    for (const std::uint32_t k : {1u, 2u, 3u}) EXPECT_EQ(row.jointed(k), (Bodies{1, 2, 3}));
    EXPECT_EQ(row.jointed(0), Bodies{0});
    EXPECT_EQ(row.island(1), row.island(3));
    EXPECT_NE(row.island(0), row.island(1));
    EXPECT_EQ(row.fault(), "");
}

// Two pendulums on one wall do not hang together; two carts behind one engine are led by it.
TEST(JointGraph, static_bodies_separate_groups_and_kinematic_bodies_are_reported) {
    TiedRow row(2);
    const BodyId wall = add_static(row.world, {.position = {0, 5, 0}});
    row.tie(wall, row.boxes[0]);
    row.tie(wall, row.boxes[1]);
    EXPECT_EQ(row.jointed(0), Bodies{0});
    EXPECT_FALSE(
        jointed_with(row.state.bodies, row.state.joints, row.state.scratch, 0).to_kinematic);
    const BodyId engine = add(row.world, {.position = {-3, 0, 0}, .type = BodyType::kinematic});
    row.tie(row.boxes[0], row.boxes[1]);
    row.tie(engine, row.boxes[0]);
    EXPECT_EQ(row.jointed(1), (Bodies{0, 1}));
    EXPECT_TRUE(
        jointed_with(row.state.bodies, row.state.joints, row.state.scratch, 1).to_kinematic);
    EXPECT_EQ(row.fault(), "");
}

TEST(JointGraph, each_group_is_visited_once) {
    TiedRow row(6);
    row.tie(row.boxes[0], row.boxes[4]);
    row.tie(row.boxes[2], row.boxes[3]);
    std::vector<Bodies> groups;
    for_each_jointed(row.state.bodies, row.state.joints, row.state.scratch, row.state.bodies.awake,
                     [&](const JointedBodies& jointed) {
                         groups.push_back({jointed.bodies.begin(), jointed.bodies.end()});
                     });
    EXPECT_EQ(groups, (std::vector<Bodies>{{0, 4}, {1}, {2, 3}, {5}}));
}

TEST(JointGraph, jointed_bodies_collide_only_if_enabled) {
    TiedRow row(3);
    row.tie(row.boxes[0], row.boxes[1]);
    row.tie(row.boxes[1], row.boxes[2], true);
    EXPECT_TRUE(joined_without_contact(row.state.bodies, row.state.joints, 0, 1));
    EXPECT_TRUE(joined_without_contact(row.state.bodies, row.state.joints, 1, 0));
    EXPECT_FALSE(joined_without_contact(row.state.bodies, row.state.joints, 1, 2));
    EXPECT_FALSE(joined_without_contact(row.state.bodies, row.state.joints, 0, 2))
        << "not tied to each other";
}

TEST(JointGraph, destroyed_joint_is_unlisted_and_re_enables_collision) {
    TiedRow row(3);
    const JointId first = row.tie(row.boxes[0], row.boxes[1]);
    row.tie(row.boxes[1], row.boxes[2]);
    const JointId third = row.tie(row.boxes[0], row.boxes[1]);
    must(row.world.step(1.0 / 60));
    ASSERT_TRUE(row.state.shapes.moved.empty());
    destroy_joint(row.state, row.state.joints, first.index);
    EXPECT_TRUE(joined_without_contact(row.state.bodies, row.state.joints, 0, 1))
        << "by the other one";
    destroy_joint(row.state, row.state.joints, third.index);
    EXPECT_FALSE(joined_without_contact(row.state.bodies, row.state.joints, 0, 1));
    EXPECT_EQ(row.state.bodies.cold[0].first_joint, none);
    EXPECT_EQ(row.state.shapes.moved, (Bodies{0, 1})) << "their pairs are asked for again, once";
    EXPECT_TRUE(row.state.islands.islands[row.island(0)].may_be_split);
    EXPECT_EQ(row.jointed(2), (Bodies{1, 2}));
    EXPECT_EQ(row.fault(), "");
}

TEST(JointGraph, joints_can_be_destroyed_during_iteration) {
    TiedRow row(4);
    for (const std::size_t k : {1u, 2u, 3u}) row.tie(row.boxes[0], row.boxes[k]);
    Bodies met;
    for_each_joint(row.state.joints, row.state.bodies.cold[0], [&](std::uint32_t joint) {
        met.push_back(joint);
        destroy_joint(row.state, row.state.joints, joint);
    });
    EXPECT_EQ(met, (Bodies{2, 1, 0})) << "the latest first";
    EXPECT_EQ(row.state.joints.ids.alive_count(), 0u);
    EXPECT_EQ(row.fault(), "");
}

}  // namespace
}  // namespace jostle::test
