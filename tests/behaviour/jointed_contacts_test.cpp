// SPDX-License-Identifier: MIT
//
// Bodies that joints tie together, on things that bear or stop them: their ends stay together
// whatever the masses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Joins what stands as it is, at a point of the world.
JointId join_at(World& world, BodyId a, BodyId b, Vec3 point, const JointKind& kind = BallJoint{}) {
    const auto frame = [&](BodyId body) {
        const Transform pose = state_of(world, body).pose;
        return Transform{apply_inverse(pose, point), conjugate(pose.rotation)};
    };
    return must(world.create_joint(
        {.body_a = a, .body_b = b, .frame_a = frame(a), .frame_b = frame(b), .kind = kind}));
}

// Runs, and says how far two ends were apart at worst, m.
double worst_gap(World& world, const std::vector<JointId>& joints, double seconds) {
    double worst = 0;
    for (int step = 0; step < static_cast<int>(seconds * 60); step++) {
        must(world.step(1.0 / 60));
        for (const JointId joint : joints)
            worst = std::max(worst, must(world.joint(joint)).separation);
    }
    return worst;
}

struct Chain {
    std::vector<BodyId> links;
    std::vector<JointId> joints;
};

// Links of 0.2 m from `start` along `way`, the first joined to `post`.
Chain hang_chain(World& world, BodyId post, Vec3 start, Vec3 way, int links) {
    Chain chain;
    // Capsules lie along y; `way` is in the plane of x and y.
    const Quat turn = from_rotation_vector({0, 0, std::atan2(way.y, way.x) - pi / 2});
    BodyId last = post;
    for (int k = 0; k < links; k++) {
        const BodyId link = add(world, {.geometry = Capsule{0.04, 0.06},
                                        .position = start + way * (0.2 * k + 0.1),
                                        .rotation = turn,
                                        .sleep_allowed = false});
        chain.joints.push_back(join_at(world, last, link, start + way * (0.2 * k)));
        chain.links.push_back(last = link);
    }
    return chain;
}

// A ball of a thousand links' mass swings into a wall of bricks: the chain of fifty that bears it
// opens by less than a hundredth of a link.
TEST(JointedContacts, wrecking_ball_does_not_stretch_its_chain) {
    World world = make_world();
    add_floor(world);
    const BodyId post = add(
        world,
        {.geometry = Box{{0.1, 0.1, 0.1}}, .position = {0, 12, 0}, .type = BodyType::static_body});
    const Vec3 way = normalized(Vec3{-1, -1, 0});
    Chain chain = hang_chain(world, post, {0, 12, 0}, way, 50);
    const double mass = 1000 * state_of(world, chain.links[0]).mass;
    const Vec3 end = Vec3{0, 12, 0} + way * 10;
    const BodyId ball = add(world, {.geometry = Sphere{0.5},
                                    .position = end + way * 0.5,
                                    .density = mass / (4.0 / 3 * pi * 0.125)});
    chain.joints.push_back(join_at(world, chain.links.back(), ball, end));
    for (int row = 0; row < 8; row++)
        for (int column = 0; column < 8; column++)
            add(world, {.geometry = Box{{0.25, 0.25, 0.25}},
                        .position = {0.5, 0.25 + 0.5 * row, 0.5 * column - 1.75},
                        .density = 300});
    EXPECT_LT(worst_gap(world, chain.joints, 6), 0.002);
    EXPECT_GT(position_of(world, ball).x, -9) << "it swung";
}

// A chain between a post and the floor, a heavy last link: it falls, lies, and is whole throughout.
TEST(JointedContacts, chain_comes_to_rest_on_the_floor_connected) {
    World world = make_world();
    add_floor(world);
    const BodyId post = add(world, {.geometry = Box{{0.1, 0.1, 0.1}},
                                    .position = {-0.2, 3, 0},
                                    .type = BodyType::static_body});
    Chain chain = hang_chain(world, post, {-0.1, 3, 0}, {1, 0, 0}, 50);
    EXPECT_LT(worst_gap(world, chain.joints, 6), 0.002);
    EXPECT_GT(world.profile().joints_batched, 0);
    EXPECT_LT(worst_gap(world, chain.joints, 1), 2e-4) << "at rest";
}

// Planks between two walls, hinged, and a ball of a hundred planks' mass on them.
TEST(JointedContacts, bridge_carries_a_heavy_ball) {
    World world = make_world();
    const BodyId left = add(
        world,
        {.geometry = Box{{0.5, 0.1, 1}}, .position = {-0.5, 5, 0}, .type = BodyType::static_body});
    const BodyId right = add(
        world,
        {.geometry = Box{{0.5, 0.1, 1}}, .position = {10.5, 5, 0}, .type = BodyType::static_body});
    std::vector<JointId> joints;
    BodyId last = left;
    for (int k = 0; k < 20; k++) {
        const BodyId plank = add(
            world,
            {.geometry = Box{{0.24, 0.05, 1}}, .position = {0.25 + 0.5 * k, 5, 0}, .density = 500});
        joints.push_back(join_at(world, last, plank, {0.5 * k, 5, 0}, HingeJoint{}));
        last = plank;
    }
    joints.push_back(join_at(world, last, right, {10, 5, 0}, HingeJoint{}));
    const double mass = 100 * state_of(world, last).mass;
    add(world, {.geometry = Sphere{0.5},
                .position = {5, 5.6, 0},
                .density = mass / (4.0 / 3 * pi * 0.125)});
    worst_gap(world, joints, 5);
    EXPECT_LT(worst_gap(world, joints, 1), 1e-3);
}

}  // namespace
}  // namespace jostle::test
