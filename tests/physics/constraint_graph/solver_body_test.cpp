// SPDX-License-Identifier: MIT
//
// Hot records: nobody stands still at 0, and each task has bodies of its own for unused lanes.
#include "physics/src/constraint_graph/solver_body.h"

#include <gtest/gtest.h>

#include <set>

namespace jostle::test {
namespace {
using namespace physics;

TEST(SolverBodies, body_zero_is_at_rest_and_immovable) {
    SolverBodies bodies;
    bodies.resize(3);
    bodies[2].v[0] = 5;
    bodies.data()[0].v[1] = 1;  // what an unused lane may have left
    bodies.data()[-1].inverse_mass = 1;
    bodies.resize(4);
    EXPECT_EQ(bodies.size(), 4u);
    EXPECT_EQ(bodies[0].v[1], 0);
    EXPECT_EQ(bodies[0].inverse_mass, 0);
    EXPECT_EQ(bodies.data()[-1].inverse_mass, 0);
    EXPECT_EQ(bodies[2].v[0], 5) << "the others are made by who steps them";
}

TEST(SolverBodies, every_set_and_list_has_its_own_spare_body) {
    std::set<std::int32_t> indices;
    for (std::size_t set = 0; set < solved_set_count; set++)
        for (const bool single : {false, true})
            indices.insert(SolverBodies::spare_index(set, single));
    EXPECT_EQ(indices.size(), 2u * solved_set_count);
    EXPECT_EQ(*indices.rbegin(), -1);
    EXPECT_EQ(*indices.begin(), -static_cast<std::int32_t>(SolverBodies::spare));
}

}  // namespace
}  // namespace jostle::test
