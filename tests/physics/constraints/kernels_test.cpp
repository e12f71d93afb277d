// SPDX-License-Identifier: MIT
//
// The instruction sets of this machine, and that all of them move a body alike. Whole worlds:
// determinism/golden_hashes_test.cpp.
#include "physics/src/constraints/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Goes back to the usual set when the test ends.
struct UsualSet {
    const InstructionSet usual = instruction_set();
    ~UsualSet() { EXPECT_TRUE(use_instruction_set(usual).ok()); }
};

TEST(Kernels, fastest_available_instruction_set_is_selected) {
    const auto sets = available_instruction_sets();
    ASSERT_FALSE(sets.empty());
    EXPECT_EQ(instruction_set(), sets.back());
    std::set<std::string> names;
    for (const InstructionSet set : sets) names.insert(instruction_set_name(set));
    EXPECT_EQ(names.size(), sets.size());
}

TEST(Kernels, unavailable_instruction_set_error_lists_available_sets) {
    const UsualSet retained;
    const auto sets = available_instruction_sets();
    for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline,
                                     InstructionSet::avx2, InstructionSet::avx512}) {
        const bool there = std::find(sets.begin(), sets.end(), set) != sets.end();
        const Status status = use_instruction_set(set);
        EXPECT_EQ(status.ok(), there);
        if (there) {
            EXPECT_EQ(instruction_set(), set);
        } else {
            EXPECT_NE(status.error().message.find(instruction_set_name(sets.front())),
                      std::string::npos)
                << status.error().message;
        }
    }
}

// Row 0 of a body: velocity, inverse mass and spin. free = v keep + push; what contacts did in the
// sub-step before acts again; then it goes v h further.
TEST(Kernels, accelerate_and_advance_match_on_every_instruction_set) {
    const UsualSet retained;
    Random random(181);
    SolverBody start{};
    ExternalChange external{};
    for (int k = 0; k < 8; k++) {
        external.retained[k] = k < 6 ? 0.99f : 1.0f;
        external.push[k] = k < 6 ? static_cast<float>(random.in(-1, 1)) : 0.0f;
    }
    for (int k = 0; k < 3; k++) {
        start.v[k] = static_cast<float>(random.in(-5, 5));
        start.w[k] = static_cast<float>(random.in(-5, 5));
        start.dp[k] = static_cast<float>(random.in(-1, 1));
        start.free[k] = start.v[k] - 0.25f;  // contacts pushed it by 0.25 m/s
        start.free[3 + k] = start.w[k];
    }
    start.inverse_mass = 0.5f;
    start.inverse_spin = 2;
    constexpr float h = 1.0f / 480;
    for (const InstructionSet set : available_instruction_sets()) {
        SCOPED_TRACE(instruction_set_name(set));
        must(use_instruction_set(set));
        SolverBody body = start;
        const std::uint32_t index = 0;
        const BodyRange range{&body, &external, &index, 0, 1};
        kernels().accelerate(range);
        for (int k = 0; k < 3; k++) {
            EXPECT_NEAR(body.free[k], start.v[k] * 0.99f + external.push[k], 1e-6f);
            EXPECT_NEAR(body.v[k], body.free[k] + 0.25f, 1e-6f);
            EXPECT_NEAR(body.w[k], start.w[k] * 0.99f + external.push[3 + k], 1e-6f);
        }
        EXPECT_EQ(body.inverse_mass, 0.5f);
        EXPECT_EQ(body.inverse_spin, 2);
        kernels().advance(range, h);
        for (int k = 0; k < 3; k++) {
            EXPECT_NEAR(body.dp[k], start.dp[k] + body.v[k] * h, 1e-6f);
            EXPECT_NEAR(body.dr[k], start.dr[k] + body.w[k] * h, 1e-6f);
        }
        body = start;
        kernels().accelerate_first(range);
        for (int k = 0; k < 3; k++)
            EXPECT_EQ(body.v[k], body.free[k]) << "nothing to start warm from";
    }
}

// A ball of 2 kg that presses into the floor at 3 m/s, in every set: relaxed rigidly it stops.
TEST(Kernels, contact_stops_a_ball_on_every_instruction_set) {
    const UsualSet retained;
    for (const InstructionSet set : available_instruction_sets()) {
        SCOPED_TRACE(instruction_set_name(set));
        must(use_instruction_set(set));
        GraphColour colour;
        add_block(colour);
        ContactConstraintWide& block = colour.blocks[0];
        for (int lane = 0; lane < 8; lane++) block.a[lane] = block.b[lane] = -1;
        block.a[0] = 1;
        block.b[0] = 0;
        block.normal[1][0] = -1;  // from the ball down to the floor
        block.tangent[0][0] = 1;
        block.gap[0][0] = 0;
        block.g[0][0] = 0.5f;
        SolverBodies bodies;
        bodies.resize(2);
        bodies[1] = {};
        bodies[1].inverse_mass = 0.5f;
        bodies[1].inverse_spin = 5;
        bodies[1].free_x = bodies[1].free_y = bodies[1].free_z = 1;
        bodies[1].v[1] = -3;
        const ContactSettings settings = contact_settings(1.0 / 60, 8, SolverTier::low);
        const ContactRange range{.blocks = colour.blocks.data(),
                                 .metas = colour.metas.data(),
                                 .restitutions = colour.restitutions.data(),
                                 .rollings = colour.rollings.data(),
                                 .begin = 0,
                                 .end = 1,
                                 .pair = PairKind::static_,
                                 .single = true,
                                 .one_by_one = false};
        kernels().relax(range, bodies.data(), settings);
        EXPECT_NEAR(bodies[1].v[1], 0, 1e-5f);
        EXPECT_NEAR(block.lambda[0][0], 6, 1e-4f);  // N s
        EXPECT_EQ(bodies[1].v[0], 0);
        EXPECT_EQ(block.lambda[0][1], 0) << "an empty lane";
    }
}

}  // namespace
}  // namespace jostle::test
