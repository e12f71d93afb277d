// SPDX-License-Identifier: MIT
//
// Euler's equations eight bodies at a time, against those of one body in double.
#include "physics/src/constraint_graph/gyroscopic_wide.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "physics/src/constraints/free_motion.h"
#include "physics/src/constraints/kernels.h"
#include "tests/support/near.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double substep = 1.0 / 480;  // s

struct Tumbling {
    PrincipalAxes axes;
    Quat start;
    Vec3 w;  // rad/s
};

// Spins up to 100 rad/s, so that some take several parts of a sub-step. Thin and flat bodies.
Tumbling random_body(Random& random) {
    const double x = random.in(0.1, 1), y = random.in(0.1, 1),
                 z = random.in(absolute(x - y), x + y);
    return {
        {from_rotation_vector({random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)}), {x, y, z}},
        from_rotation_vector({random.in(-3, 3), random.in(-3, 3), random.in(-3, 3)}),
        Vec3{random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)} * random.in(1, 100)};
}

struct Bodies {
    GyroscopicWide block{};
    SolverBodies hot;
    std::vector<Tumbling> all;

    explicit Bodies(bool by_substeps, int count = 7) {
        Random random(47);
        hot.resize(static_cast<std::size_t>(count) + 1);
        for (int k = 0; k < count; k++) {
            all.push_back(random_body(random));
            const Tumbling& body = all.back();
            const Quat frame = body.start * body.axes.frame;
            const double q[] = {frame.x, frame.y, frame.z, frame.w};
            block.hot[k] = k + 1;
            block.by_substeps[k] = by_substeps ? 1 : 0;
            for (int i = 0; i < 4; i++) block.principal[i][k] = static_cast<float>(q[i]);
            const Vec3 bend = bend_of(body.axes);
            SolverBody& at = hot[static_cast<std::size_t>(k) + 1];
            at = {};
            at.inverse_mass = 1;
            for (int i = 0; i < 3; i++) {
                block.bend[i][k] = static_cast<float>(bend[i]);
                block.inverse_moments[i][k] = static_cast<float>(1 / body.axes.moments[i]);
                at.w[i] = at.free[3 + i] = static_cast<float>(body.w[i]);
            }
        }
        for (float& w : block.turned[3]) w = 1;
    }
    GyroscopicRange range() { return {&block, 0, 1}; }
    Vec3 spin(std::size_t k) const { return to_vec3(hot[k + 1].w); }
};

// The spin of a free body after a sub-step, in the axes of its start, and its rotation by the mean
// spin.
EulerStep expected_step(const Tumbling& body) {
    BodyCold cold;
    cold.principal = body.axes;
    const Vec3 w =
        rotate(body.start, euler_step(cold, inverse_rotate(body.start, body.w), substep).w);
    return {from_rotation_vector((body.w + w) * (0.5 * substep)), w};
}

TEST(GyroscopicKernel, spin_without_joints_matches_double) {
    Bodies bodies(false);
    const SolverBody before = bodies.hot[0];
    kernels().spin_freely(bodies.range(), bodies.hot.data(), static_cast<float>(substep));
    for (std::size_t k = 0; k < bodies.all.size(); k++) {
        const Vec3 expected = expected_step(bodies.all[k]).w;
        EXPECT_TRUE(near(bodies.spin(k), expected, 1e-5 * length(expected))) << k;
        EXPECT_EQ(bodies.hot[k + 1].w[0], bodies.hot[k + 1].free[3]) << "not an impulse";
    }
    EXPECT_EQ(std::memcmp(&before, &bodies.hot[0], sizeof before), 0) << "an unused lane";
}

// Without joint impulses in between, both halves together turn a body as a free one. Its spin stays
// in the axes of the start of the step, or is that of the world.
TEST(GyroscopicKernel, halves_around_the_joints_turn_the_body_exactly) {
    for (const bool by_substeps : {false, true}) {
        Bodies bodies(by_substeps);
        kernels().begin_gyroscopic(bodies.range(), bodies.hot.data(), static_cast<float>(substep));
        kernels().end_gyroscopic(bodies.range(), bodies.hot.data(), static_cast<float>(substep));
        for (std::size_t k = 0; k < bodies.all.size(); k++) {
            const EulerStep expected = expected_step(bodies.all[k]);
            const Vec3 w = by_substeps ? rotate(expected.rotation, expected.w) : expected.w;
            EXPECT_TRUE(near(bodies.spin(k), w, 1e-5 * length(w))) << k;
            const SolverBody& body = bodies.hot[k + 1];
            // The rotation vector after the pass that adds h w.
            const Quat turn = from_rotation_vector(to_vec3(body.dr) + to_vec3(body.w) * substep);
            EXPECT_TRUE(near(rotate(turn, {1, 0, 0}), rotate(expected.rotation, {1, 0, 0}), 2e-6));
            EXPECT_TRUE(near(rotate(turn, {0, 1, 0}), rotate(expected.rotation, {0, 1, 0}), 2e-6));
            // The inertia of the new orientation, in world axes.
            const Vec3 i = bodies.all[k].axes.moments;
            const Mat3 axes =
                to_matrix(expected.rotation * bodies.all[k].start * bodies.all[k].axes.frame);
            const Mat3 inverse = axes * diagonal({1 / i.x, 1 / i.y, 1 / i.z}) * transpose(axes);
            if (by_substeps)
                EXPECT_NEAR(body.inertia[0], inverse.x.x, 1e-4 * (1 / i.x + 1 / i.y + 1 / i.z));
            else
                EXPECT_EQ(body.inertia[0], 0) << "constant in axes that turn with the body";
        }
    }
}

TEST(GyroscopicKernel, same_bits_on_every_instruction_set_and_in_every_lane) {
    const InstructionSet usual = instruction_set();
    Bodies first(true);
    for (const InstructionSet set : available_instruction_sets()) {
        ASSERT_TRUE(use_instruction_set(set).ok());
        Bodies bodies(true);
        kernels().begin_gyroscopic(bodies.range(), bodies.hot.data(), static_cast<float>(substep));
        kernels().end_gyroscopic(bodies.range(), bodies.hot.data(), static_cast<float>(substep));
        if (set == available_instruction_sets().front()) first = bodies;
        EXPECT_EQ(
            std::memcmp(first.hot.data(), bodies.hot.data(), first.hot.size() * sizeof(SolverBody)),
            0)
            << instruction_set_name(set);
        // Alone, the last body does the same as among the others.
        Bodies alone(true);
        for (int k = 0; k < 6; k++) alone.block.hot[k] = 0;
        kernels().begin_gyroscopic(alone.range(), alone.hot.data(), static_cast<float>(substep));
        kernels().end_gyroscopic(alone.range(), alone.hot.data(), static_cast<float>(substep));
        EXPECT_EQ(std::memcmp(&alone.hot[7], &bodies.hot[7], sizeof(SolverBody)), 0);
    }
    ASSERT_TRUE(use_instruction_set(usual).ok());
}

}  // namespace
}  // namespace jostle::test
