// SPDX-License-Identifier: MIT
//
// What a world and a joint that say how joints are solved get for it (joint_solver.h), in numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/ball_net.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct CapsuleChain {
    std::vector<BodyId> links;
    std::vector<JointId> joints;
};

// Capsules of 0.2 m in a row along x from `from` on, a pivot of the world at its beginning.
CapsuleChain hang_chain(World& world, Vec3 from, int count, const JointKind& kind,
                        double end_density) {
    CapsuleChain chain;
    for (int k = 0; k < count; k++) {
        chain.links.push_back(add(world, {.geometry = Capsule{0.03, 0.05},
                                          .position = from + Vec3{0.2 * k + 0.1, 0, 0},
                                          .rotation = from_axis_angle({0, 0, 1}, -pi / 2),
                                          .density = k + 1 == count ? end_density : 1000,
                                          .sleep_allowed = false}));
        JointDef def{.body_b = chain.links.back(),
                     .frame_a = {.position = from},
                     .frame_b = {{0, -0.1, 0}, from_axis_angle({0, 0, 1}, pi / 2)},
                     .kind = kind};
        if (k > 0) {
            def.body_a = chain.links[chain.links.size() - 2];
            def.frame_a = {{0, 0.1, 0}, from_axis_angle({0, 0, 1}, pi / 2)};
        }
        chain.joints.push_back(must(world.create_joint(def)));
    }
    return chain;
}

// The worst in some seconds: of the gaps, m, and of the energy's change, J.
struct Worst {
    double gap = 0, energy = 0;
    StepProfile profile = {};
};
Worst run_worst(World& world, double seconds) {
    const auto energy = [&] {
        const WorldSummary sum = world.summary();
        return sum.kinetic_energy + sum.potential_energy;
    };
    Worst worst;
    const double before = energy();
    for (double t = 0; t < seconds; t += 1.0 / 60) {
        must(world.step(1.0 / 60));
        worst.gap = std::max(worst.gap, world.summary().max_joint_error);
        worst.energy = std::max(worst.energy, std::abs(energy() - before));
    }
    worst.profile = world.profile();
    return worst;
}

// Eight links on cone-twists so wide that nobody feels them, and a hundred links' mass at their
// end, swing for two seconds from level. Measured: 4e-7 m and 0.11 J, 2e-4 m and 9 J, 0.011 m and
// 54 J.
TEST(JointSolvers, direct_conserves_the_energy_of_a_cone_twist_chain) {
    const auto swing = [](JointSolver solver) {
        World world = make_world({.joint_solver = solver});
        hang_chain(world, {0, 5, 0}, 8, ConeTwistJoint{.swing = 3, .twist = {}}, 1e5);
        return run_worst(world, 2);
    };
    const Worst direct = swing(JointSolver::direct), automatic = swing(JointSolver::automatic),
                iterative = swing(JointSolver::iterative);
    EXPECT_EQ(direct.profile.joints_direct, 8);
    EXPECT_LT(direct.gap, 2e-6);
    EXPECT_LT(direct.energy, 0.15);
    EXPECT_EQ(automatic.profile.joints_direct, 0);
    EXPECT_EQ(automatic.profile.joints_batched, 8);
    EXPECT_LT(automatic.gap, 1e-3);
    EXPECT_GT(automatic.energy, 20 * direct.energy);
    EXPECT_EQ(iterative.profile.joints_direct + iterative.profile.joints_batched, 0);
    EXPECT_GT(iterative.gap, 20 * automatic.gap);
}

// One joint of a chain in a world that says nothing decides for all of it, and for no other chain.
TEST(JointSolvers, preference_of_one_joint_applies_to_its_group) {
    World world = make_world();
    const JointKind cone = ConeTwistJoint{.swing = 3, .twist = {}};
    const CapsuleChain exact = hang_chain(world, {0, 5, 0}, 8, cone, 1e5);
    const CapsuleChain other = hang_chain(world, {0, 5, 5}, 8, cone, 1e5);
    const CapsuleChain soft = hang_chain(world, {0, 5, 10}, 8, BallJoint{}, 1e5);
    must(world.set_joint_solver(exact.joints[3], JointSolver::direct));
    must(world.set_joint_solver(soft.joints[5], JointSolver::iterative));
    const auto gap = [&](const CapsuleChain& chain) {
        double most = 0;
        for (const JointId joint : chain.joints)
            most = std::max(most, must(world.joint(joint)).separation);
        return most;
    };
    double of_exact = 0, of_other = 0, of_soft = 0;
    for (int step = 0; step < 120; step++) {
        must(world.step(1.0 / 60));
        ASSERT_EQ(world.profile().joints_direct, 8);
        ASSERT_EQ(world.profile().joints_batched, 8);
        of_exact = std::max(of_exact, gap(exact));
        of_other = std::max(of_other, gap(other));
        of_soft = std::max(of_soft, gap(soft));
    }
    EXPECT_LT(of_exact, 2e-6);
    EXPECT_GT(of_other, 20 * of_exact);
    EXPECT_GT(of_soft, 20 * of_other);
}

// Two worlds that are told the same in the middle of a swing go on alike, and so does one that was
// saved before it was told; impulses that joints keep are those of either solver.
TEST(JointSolvers, can_change_while_a_chain_swings) {
    World world = make_world();
    hang_chain(world, {0, 5, 0}, 8, BallJoint{}, 1e4);
    run(world, 0.3);
    EXPECT_EQ(world.profile().joints_direct, 8);
    World loaded = must(load(save(world)));
    for (World* each : {&world, &loaded}) {
        must(each->set_joint_solver(JointSolver::iterative));
        run(*each, 0.3);
        EXPECT_EQ(each->profile().joints_direct + each->profile().joints_batched, 0);
        must(each->set_joint_solver(JointSolver::direct));
        EXPECT_EQ(each->joint_solver(), JointSolver::direct);
        run(*each, 0.5);
        EXPECT_EQ(each->profile().joints_direct, 8);
        EXPECT_LT(each->summary().max_joint_error, 1e-5);
    }
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    World again = must(load(save(world)));
    EXPECT_EQ(again.joint_solver(), JointSolver::direct);
    run(world, 0.3);
    run(again, 0.3);
    EXPECT_EQ(state_hash(again), state_hash(world));
}

// A net of n by n balls that lies flat, 0.3 m from one to the next.
void hang_net(World& world, int n, double y, double end_density) {
    add_ball_net(world, n, {0, y, 0}, {0, 0, 0.3}, {0.3, 0, 0}, end_density);
}

// 16 by 16, a hundred balls' mass on each of the last row: too dense for a world that says nothing.
// In the air gaps were 1.6e-3 m and are 4e-5. On the floor they are 6e-5 swept and 4e-5 at once.
TEST(JointSolvers, direct_solves_dense_nets) {
    for (const bool on_floor : {false, true}) {
        const auto hang = [&](JointSolver solver) {
            World world = make_world({.joint_solver = solver});
            if (on_floor) add_floor(world);
            hang_net(world, 16, on_floor ? 0.1 : 5, 1e5);
            return run_worst(world, 0.5);
        };
        const Worst direct = hang(JointSolver::direct), automatic = hang(JointSolver::automatic);
        EXPECT_EQ(direct.profile.joints_direct, on_floor ? 0 : 465);
        EXPECT_EQ(direct.profile.joints_batched, on_floor ? 465 : 0);
        EXPECT_EQ(direct.profile.joints_direct_fallback, 0);
        EXPECT_EQ(automatic.profile.joints_direct + automatic.profile.joints_batched, 0);
        EXPECT_LT(direct.gap, 1e-4);
        EXPECT_GT(automatic.gap, on_floor ? direct.gap : 10 * direct.gap);
    }
}

// A flat net has many rows that say what others say, all but exactly as soon as it bends: none of
// them may pull as hard as it likes. For five seconds it falls, bends, swings and touches itself,
// and gains less than 30 J, of the 1 to 19 kJ that it has above the ground.
TEST(JointSolvers, nets_do_not_explode) {
    for (const int n : {3, 4, 6, 10}) {
        World world = make_world();
        hang_net(world, n, 5, 1000);
        const auto energy = [&] {
            const WorldSummary sum = world.summary();
            return sum.kinetic_energy + sum.potential_energy;
        };
        const double before = energy();
        for (int step = 0; step < 300; step++) {
            must(world.step(1.0 / 60));
            ASSERT_TRUE(world.events().quarantined.empty()) << n << " " << step;
            ASSERT_LT(energy() - before, 30) << n << " " << step;
            ASSERT_LT(world.summary().max_joint_error, 0.02) << n << " " << step;
        }
    }
}

// A hub with a thousand spokes takes work in proportion to the spokes.
TEST(JointSolvers, direct_solves_a_hub_in_linear_time) {
    World hub = make_world({.gravity = {}, .joint_solver = JointSolver::direct});
    const BodyId middle = add(hub, {.geometry = Sphere{1}});
    for (int k = 0; k < 1000; k++) {
        const Vec3 at = rotate(from_axis_angle({0, 0, 1}, 0.00628 * k), Vec3{20.0 + k % 7, 0, 0});
        const BodyId spoke = add(hub, {.geometry = Sphere{0.01}, .position = at});
        must(hub.create_joint({.body_a = middle, .body_b = spoke, .frame_a = {.position = at}}));
    }
    run(hub, 0.1);
    EXPECT_EQ(hub.profile().joints, 1000);
    EXPECT_EQ(hub.profile().joints_direct, 1000);
    EXPECT_EQ(hub.profile().joints_direct_fallback, 0);
}

// What nobody could solve in time is solved as before, and the profile says so: a net of 50 by 50.
TEST(JointSolvers, direct_has_a_work_limit) {
    World net = make_world({.joint_solver = JointSolver::direct});
    hang_net(net, 50, 5, 1000);
    must(net.step(1.0 / 60));
    EXPECT_EQ(net.profile().joints_direct_fallback, net.profile().joints);
    EXPECT_EQ(net.profile().joints, 50 * 49 + 49 * 49);
}

}  // namespace
}  // namespace jostle::test
