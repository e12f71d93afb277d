// SPDX-License-Identifier: MIT
//
// A box of 2 kg on a floor that contacts do not move: four points 0.5 m below its centre.
#include "physics/src/constraints/contact_group/contact_group.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "physics/src/constraint_graph/wide_rows.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr std::int64_t unlimited = 1'000'000'000;
constexpr float group_substep = 1.0f / 480;

struct BoxOnFloor {
    BoxOnFloor() {
        body.inverse_mass = 0.5f;
        body.inertia[0] = body.inertia[1] = body.inertia[2] = 3;
        body.free_x = body.free_y = body.free_z = 1;
        put_lane(block->normal, lane, {0, -1, 0});
        put_lane(block->tangent, lane, {1, 0, 0});
        put_lane(block->arm_a, lane, {0, -0.5, 0});
        block->mu[lane] = 0.5f;
        for (int i = 0; i < 4; i++) {
            block->x[i][lane] = i < 2 ? -0.5f : 0.5f;
            block->y[i][lane] = i % 2 == 0 ? -0.5f : 0.5f;
        }
        settings.h = group_substep;
        settings.inverse_h = 1 / group_substep;
        settings.bias_rate = 20;
        settings.push_speed = 1;
        settings.slop = 5e-5f;
    }
    void set(std::int64_t max_work) {
        group.set({&body}, {{.lane_ref = {block.get(), &meta, nullptr, lane}, .a = 0, .load = 2}},
                  max_work);
    }
    void fall_with(float x, float y) {
        body.free[0] = body.v[0] = x;
        body.free[1] = body.v[1] = y;
    }
    float load() const {
        float sum = 0;
        for (int i = 0; i < 4; i++) sum += block->lambda[i][lane];
        return sum;
    }

    static constexpr int lane = 5;
    std::unique_ptr<ContactConstraintWide> block = std::make_unique<ContactConstraintWide>();
    ContactConstraintWideMeta meta{};
    SolverBody body{};
    ContactSettings settings{};
    ContactGroup group;
};

TEST(ContactGroup, stops_a_falling_box_and_remembers_its_impulses_as_means) {
    BoxOnFloor box;
    box.set(unlimited);
    box.fall_with(0, -0.02f);
    EXPECT_TRUE(box.group.solve(box.settings));
    EXPECT_NEAR(box.body.v[1], 0, 1e-8);
    EXPECT_NEAR(box.load(), 2 * 0.02f, 1e-7);
    for (int i = 0; i < 4; i++)
        EXPECT_EQ(box.block->mean_impulse[i][BoxOnFloor::lane],
                  box.block->lambda[i][BoxOnFloor::lane]);
    EXPECT_FALSE(box.group.missed());
    EXPECT_GT(box.group.work(), 0);
}

// Friction below the centre also tips the box; the points hold it.
TEST(ContactGroup, friction_slows_a_sliding_box_by_mu_times_its_load) {
    BoxOnFloor box;
    box.set(unlimited);
    box.fall_with(1, -0.02f);
    EXPECT_TRUE(box.group.relax(box.settings));
    EXPECT_NEAR(box.body.v[0], 1 - 0.5 * 0.02, 1e-6);
    EXPECT_NEAR(box.body.v[1], 0, 1e-7);
    EXPECT_NEAR(box.body.w[2], 0, 1e-6);
}

TEST(ContactGroup, overlap_is_pushed_out_only_before_bodies_move) {
    for (const bool relaxes : {false, true}) {
        BoxOnFloor box;
        for (auto& gap : box.block->gap) gap[BoxOnFloor::lane] = -1e-3f;
        box.set(unlimited);
        box.fall_with(0, -0.02f);
        EXPECT_TRUE(relaxes ? box.group.relax(box.settings) : box.group.solve(box.settings));
        EXPECT_NEAR(box.body.v[1], relaxes ? 0 : 20 * (1e-3 - 5e-5), 1e-7);
    }
}

TEST(ContactGroup, without_work_left_sweeps_start_from_the_last_impulses) {
    BoxOnFloor box;
    box.set(0);
    box.fall_with(0, -0.02f);
    for (auto& lambda : box.block->lambda) lambda[BoxOnFloor::lane] = 0.01f;
    EXPECT_FALSE(box.group.solve(box.settings));
    EXPECT_TRUE(box.group.missed());
    EXPECT_NEAR(box.body.v[1], 0, 1e-8) << "4 x 0.01 N s on 2 kg";
}

TEST(ContactGroup, without_a_solution_impulses_that_add_energy_are_dropped) {
    BoxOnFloor box;
    box.set(0);
    box.fall_with(0, -0.02f);
    for (auto& lambda : box.block->lambda) lambda[BoxOnFloor::lane] = 100;
    EXPECT_FALSE(box.group.solve(box.settings));
    EXPECT_EQ(box.load(), 0);
    EXPECT_FLOAT_EQ(box.body.v[1], -0.02f);
}

}  // namespace
}  // namespace jostle::test
