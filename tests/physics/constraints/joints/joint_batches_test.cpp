// SPDX-License-Identifier: MIT
//
// Which joints are solved at once beside contacts, and that one solve is enough.
#include "physics/src/constraints/joints/joint_batches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "physics/src/constraints/joints/write_joint.h"
#include "physics/src/constraints/kernels.h"

namespace jostle::test {
namespace {
using namespace physics;

// Joints between bodies by hot index, negative or 0 where joints cannot push.
JointLevels levels_of(const std::vector<std::pair<int, int>>& ends, std::size_t bodies) {
    JointLevels levels;
    for (std::size_t k = 0; k < ends.size(); k++) {
        LeveledJoint joint;
        joint.joint = static_cast<std::uint32_t>(k);
        joint.a = ends[k].first;
        joint.b = ends[k].second;
        levels.joints.push_back(joint);
    }
    assign_levels(levels, bodies);
    return levels;
}

JointBatches batches_of(JointLevels& levels, std::size_t bodies,
                        const JointSolverOptions& asks = {}) {
    JointBatches batches;
    const std::vector<std::uint8_t> all(levels.joints.size(), 1);
    find_batches(batches, levels, all, bodies, asks);
    return batches;
}

// Nine chains of three links and two pairs: the chains fill one batch and begin another, and a pair
// has nothing that one row of its own could not do.
TEST(JointBatches, put_groups_with_equal_patterns_in_one_batch) {
    std::vector<std::pair<int, int>> ends;
    int body = 1;
    for (int chain = 0; chain < 9; chain++, body += 3) {
        ends.push_back({body, body + 1});
        ends.push_back({body + 1, body + 2});
    }
    for (int pair = 0; pair < 2; pair++, body += 2) ends.push_back({body, body + 1});
    JointLevels levels = levels_of(ends, static_cast<std::size_t>(body));
    JointBatches batches = batches_of(levels, static_cast<std::size_t>(body));
    ASSERT_EQ(batches.used, 2);
    EXPECT_EQ(batches.all[0].groups, 8);
    EXPECT_EQ(batches.all[1].groups, 1);
    EXPECT_EQ(batches.all[0].pattern, batches.all[1].pattern);
    EXPECT_EQ(batches.all[0].joints.size(), 2u);
    int in_batch = 0;
    for (const JointConstraintWideMeta& meta : levels.metas) in_batch += meta.in_batch;
    EXPECT_EQ(in_batch, 18);
}

// What stands still ties nobody: two pendulums of two links on one pivot are two groups.
TEST(JointBatches, stop_at_immovable_bodies) {
    JointLevels levels = levels_of({{-5, 1}, {1, 2}, {-5, 3}, {3, 4}}, 6);
    JointBatches batches = batches_of(levels, 6);
    ASSERT_EQ(batches.used, 1);
    EXPECT_EQ(batches.all[0].groups, 2);
}

// A cloth's matrix is dense: it is left to sweeps.
TEST(JointBatches, skip_nets) {
    std::vector<std::pair<int, int>> ends;
    constexpr int n = 30;
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++) {
            const int here = 1 + row * n + column;
            if (row > 0) ends.push_back({here - n, here});
            if (column > 0) ends.push_back({here - 1, here});
        }
    JointLevels levels = levels_of(ends, n * n + 1);
    EXPECT_EQ(batches_of(levels, n * n + 1).used, 0);
    JointLevels again = levels_of(ends, n * n + 1);
    EXPECT_EQ(batches_of(again, n * n + 1, {{}, JointSolver::direct, 1'000'000}).used, 1)
        << "unless they ask";
    JointLevels poor = levels_of(ends, n * n + 1);
    EXPECT_EQ(batches_of(poor, n * n + 1, {{}, JointSolver::direct, 2000}).used, 0)
        << "and may cost so much";
}

// Of a pair, a chain of three and another chain whose middle joint wishes for what it says.
TEST(JointBatches, follow_the_solver_preferences_of_the_joints) {
    const std::vector<std::pair<int, int>> ends{{1, 2}, {3, 4}, {4, 5}, {5, 6},
                                                {7, 8}, {8, 9}, {9, 10}};
    const auto found = [&](std::optional<JointSolver> middle, JointSolver of_world) {
        JointLevels levels = levels_of(ends, 11);
        std::vector<JointSolverPreferences> preferences(ends.size());
        preferences[5] = preference_bit(middle);
        return batches_of(levels, 11, {preferences, of_world, 1000}).found;
    };
    using Found = std::vector<std::uint8_t>;
    EXPECT_EQ(found({}, JointSolver::automatic), (Found{0, 1, 1, 1, 1, 1, 1}));
    EXPECT_EQ(found({}, JointSolver::iterative), (Found{0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(found({}, JointSolver::direct), (Found{1, 1, 1, 1, 1, 1, 1}));
    EXPECT_EQ(found(JointSolver::iterative, JointSolver::automatic), (Found{0, 1, 1, 1, 0, 0, 0}));
    EXPECT_EQ(found(JointSolver::automatic, JointSolver::iterative), (Found{0, 0, 0, 0, 1, 1, 1}));
}

// Forty links of 1 kg under a pivot, a load of 1000 kg at their end, all with random velocities:
// after two solves no two ends part faster than 1e-5 of how fast they did, and the momentum that
// the links lost is what the pivot took.
TEST(JointBatches, solve_a_long_chain_with_a_heavy_end_in_two_solves) {
    constexpr int links = 40;
    std::vector<std::pair<int, int>> ends;
    for (int k = 0; k < links; k++) ends.push_back({k, k + 1});
    JointLevels levels = levels_of(ends, links + 1);
    for (const LeveledJoint& joint : levels.joints) {
        JointConstraintWide& block = levels.blocks[static_cast<std::size_t>(joint.block)];
        block.a[joint.lane] = joint.a;
        block.b[joint.lane] = joint.b;
        if (joint.a != 0) block.arm_a[1][joint.lane] = -0.1f;
        block.arm_b[1][joint.lane] = 0.1f;
    }
    SolverBodies hot;
    hot.resize(links + 1);
    unsigned seed = 1;
    const auto random = [&] {
        seed = seed * 1664525u + 1013904223u;
        return static_cast<float>(static_cast<double>(seed >> 8) / (1 << 23) - 1);
    };
    for (int k = 1; k <= links; k++) {
        SolverBody& body = hot[static_cast<std::size_t>(k)];
        for (int axis = 0; axis < 3; axis++) body.v[axis] = random(), body.w[axis] = 5 * random();
        body.inverse_mass = k == links ? 0.001f : 1;
        for (int axis = 0; axis < 3; axis++) body.inertia[axis] = 300 * body.inverse_mass;
        body.free_x = body.free_y = body.free_z = 1;
    }
    const auto parting = [&] {
        double most = 0;
        for (int k = 0; k < links; k++) {
            const SolverBody &a = hot[static_cast<std::size_t>(k)],
                             &b = hot[static_cast<std::size_t>(k) + 1];
            const double arm = k == 0 ? 0 : -0.1;
            const Vec3 at_a = to_vec3(a.v) + cross(to_vec3(a.w), {0, arm, 0});
            const Vec3 at_b = to_vec3(b.v) + cross(to_vec3(b.w), {0, 0.1, 0});
            most = std::max(most, length(at_b - at_a));
        }
        return most;
    };
    const double before = parting();
    JointBatches batches = batches_of(levels, links + 1);
    ASSERT_EQ(batches.used, 1);
    load_batch(batches.all[0], levels);
    const BatchView view = view_of(batches.all[0], levels);
    const JointStep step = joint_step(1.0 / 480);
    kernels().factor_batch(view, hot.data(), step);
    kernels().solve_batch(view, hot.data(), step);
    kernels().solve_batch_again(view, hot.data(), step);
    EXPECT_GT(before, 0.5);
    EXPECT_LT(parting(), 1e-5 * before);
    // Each joint kept what it gave: the second's impulse, in b's axes, is what slowed all below it.
    double kept = 0;
    for (const LeveledJoint& joint : levels.joints)
        if (joint.joint == 0)
            kept =
                double{levels.blocks[static_cast<std::size_t>(joint.block)].point[1][joint.lane]};
    double momentum = 0;
    seed = 1;
    for (int k = 1; k <= links; k++) {
        double start = 0;
        for (int axis = 0; axis < 3; axis++) {
            const double v = double{random()};
            random();
            if (axis == 1) start = v;
        }
        momentum +=
            (double{hot[static_cast<std::size_t>(k)].v[1]} - start) * (k == links ? 1000 : 1);
    }
    EXPECT_NEAR(kept, momentum, 1e-3 * std::abs(momentum));
}

// A chassis with twelve wheels of 20 kg, of which every joint couples it to all others. `locked`
// keeps it from being a hub.
struct Vehicle {
    static constexpr int wheels = 12;
    JointLevels levels;
    SolverBodies hot;
    JointBatches batches;

    Vehicle(float mass, bool locked) : levels(levels_of(ends(), wheels + 2)) {
        for (const LeveledJoint& joint : levels.joints) {
            JointConstraintWide& block = levels.blocks[static_cast<std::size_t>(joint.block)];
            block.a[joint.lane] = joint.a;
            block.b[joint.lane] = joint.b;
            block.arm_a[0][joint.lane] = 0.4f * static_cast<float>(joint.b - 7);
            block.arm_a[2][joint.lane] = joint.b % 2 == 0 ? 0.8f : -0.8f;
            block.arm_b[1][joint.lane] = 0.05f;
        }
        hot.resize(wheels + 2);
        unsigned seed = 1;
        for (int k = 1; k <= wheels + 1; k++) {
            SolverBody& body = hot[static_cast<std::size_t>(k)];
            for (float* const at : {body.v, body.w})
                for (int axis = 0; axis < 3; axis++) {
                    seed = seed * 1664525u + 1013904223u;
                    at[axis] = static_cast<float>(static_cast<double>(seed >> 8) / (1 << 23) - 1);
                }
            body.inverse_mass = k == 1 ? 1 / mass : 0.05f;
            for (int axis = 0; axis < 3; axis++)
                body.inertia[axis] = (k == 1 ? 1.0f : 20.0f) * body.inverse_mass;
            body.inertia[3] = 0.3f * body.inertia[0];
            body.free_x = body.free_y = body.free_z = 1;
        }
        const std::vector<std::uint8_t> all(levels.joints.size(), 1),
            is_locked(levels.joints.size(), locked ? 1 : 0);
        find_batches(batches, levels, all, wheels + 2, {.locked = is_locked});
        load_batch(batches.all[0], levels);
    }

    static std::vector<std::pair<int, int>> ends() {
        std::vector<std::pair<int, int>> list;
        for (int k = 0; k < wheels; k++) list.push_back({1, k + 2});
        return list;
    }
    void solve() {
        const BatchView view = view_of(batches.all[0], levels);
        const JointStep step = joint_step(1.0 / 480);
        kernels().factor_batch(view, hot.data(), step);
        kernels().solve_batch(view, hot.data(), step);
        kernels().solve_batch_again(view, hot.data(), step);
    }
    double parting() const {
        double most = 0;
        for (int k = 0; k < wheels; k++) {
            const SolverBody &a = hot[1], &b = hot[static_cast<std::size_t>(k) + 2];
            const Vec3 arm{0.4 * (k - 5), 0, k % 2 == 0 ? 0.8 : -0.8};
            const Vec3 at_a = to_vec3(a.v) + cross(to_vec3(a.w), arm);
            const Vec3 at_b = to_vec3(b.v) + cross(to_vec3(b.w), {0, 0.05, 0});
            most = std::max(most, length(at_b - at_a));
        }
        return most;
    }
    Vec3 momentum(double mass) const {
        Vec3 sum = to_vec3(hot[1].v) * mass;
        for (int k = 0; k < wheels; k++)
            sum += to_vec3(hot[static_cast<std::size_t>(k) + 2].v) * 20;
        return sum;
    }
};

TEST(JointBatches, solve_a_hub_as_the_joints_that_it_couples) {
    for (const float mass : {0.2f, 20.0f, 20000.0f}) {
        Vehicle hub(mass, false), coupled(mass, true);
        ASSERT_EQ(hub.batches.all[0].pattern->hubs.hubs.size(), 1u);
        ASSERT_EQ(coupled.batches.all[0].pattern->hubs.hubs.size(), 0u);
        EXPECT_LT(4 * hub.batches.all[0].pattern->work, coupled.batches.all[0].pattern->work);
        const double before = hub.parting();
        const Vec3 momentum = hub.momentum(double{mass});
        hub.solve();
        coupled.solve();
        EXPECT_GT(before, 1);
        EXPECT_LT(hub.parting(), 1e-5 * before) << mass;
        EXPECT_LT(length(hub.momentum(double{mass}) - momentum), 1e-4 * (double{mass} + 240))
            << mass;
        for (std::size_t k = 1; k <= Vehicle::wheels + 1; k++)
            for (int axis = 0; axis < 3; axis++) {
                EXPECT_NEAR(hub.hot[k].v[axis], coupled.hot[k].v[axis], 2e-5) << mass << " " << k;
                EXPECT_NEAR(hub.hot[k].w[axis], coupled.hot[k].w[axis], 1e-4) << mass << " " << k;
            }
    }
}

// A joint to a body that stands still has no block of its own without the hub.
TEST(JointBatches, no_hub_hangs_on_a_body_that_stands_still) {
    std::vector<std::pair<int, int>> ends = Vehicle::ends();
    ends.push_back({0, 1});
    JointLevels levels = levels_of(ends, Vehicle::wheels + 2);
    JointBatches batches = batches_of(levels, Vehicle::wheels + 2);
    ASSERT_EQ(batches.used, 1);
    EXPECT_TRUE(batches.all[0].pattern->hubs.hubs.empty());
}

}  // namespace
}  // namespace jostle::test
