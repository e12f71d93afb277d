// SPDX-License-Identifier: MIT
//
// Which lists of contacts are solved, in which order, and whom their empty lanes push.
#include "physics/src/constraints/contact_passes.h"

#include <gtest/gtest.h>

#include <memory>

namespace jostle::test {
namespace {
using namespace physics;

constexpr ColourSetKey low{SolverTier::low, 0}, low_next{SolverTier::low, 1};

// Contacts whose lanes name bodies 1 and 2.
void add_contacts(ConstraintGraph& graph, ColourSetKey key, int colour, int contacts) {
    for (int k = 0; k < contacts; k++) {
        const auto slot = add_contact(graph, key, colour, static_cast<std::uint32_t>(k));
        const ContactLaneRef place = lane_ref_at(graph, key, colour, slot);
        place.block->a[place.lane] = 1;
        place.block->b[place.lane] = 2;
    }
}

TEST(ContactPasses, runs_follow_the_solve_order_with_single_point_lists) {
    const auto graph = std::make_unique<ConstraintGraph>();
    const int dynamic_overflow = overflow_colours, on_wall = dynamic_colours + kinematic_colours;
    add_contacts(*graph, low, on_wall, 17);
    add_contacts(*graph, low, 3, 1);
    add_contacts(*graph, low, single_colours + 3, 9);
    add_contacts(*graph, low, single_colours + 5, 1);
    add_contacts(*graph, low, dynamic_overflow, 2);
    std::vector<ColourRun> runs;
    list_runs(*graph, index_of(low), index_of(low) + 1, runs);
    ASSERT_EQ(runs.size(), 4u);
    const int numbers[] = {dynamic_overflow, 3, 5, on_wall};
    const int blocks[] = {2, 1, 0, 3}, singles[] = {0, 2, 1, 0};
    for (std::size_t k = 0; k < 4; k++) {
        EXPECT_EQ(runs[k].number, numbers[k]);
        EXPECT_EQ(runs[k].blocks, blocks[k]);
        EXPECT_EQ(runs[k].singles, singles[k]);
        EXPECT_FALSE(runs[k].shared);
    }
    EXPECT_EQ(runs[0].single, nullptr);
}

// Each task has bodies of its own for them, one for each kind of list, so that no two threads write
// to one.
TEST(ContactPasses, empty_lanes_refer_to_the_spare_bodies_of_their_task) {
    const auto graph = std::make_unique<ConstraintGraph>();
    add_contacts(*graph, low, 0, 3);
    add_contacts(*graph, low_next, single_colours, 7);
    add_contacts(*graph, low_next, overflow_colours, 2);
    std::vector<ColourRun> runs;
    const std::size_t first = index_of(low);
    list_runs(*graph, first, first + 2, runs);
    ASSERT_EQ(runs.size(), 3u);
    const std::int32_t several = SolverBodies::spare_index(first, false),
                       single = SolverBodies::spare_index(first, true);
    const auto& of_three = runs[0].colour->blocks[0];
    EXPECT_EQ(of_three.a[2], 1);
    for (int lane = 3; lane < 8; lane++) EXPECT_EQ(of_three.a[lane], several);
    EXPECT_EQ(runs[1].colour->blocks[1].b[0], 2) << "one by one: one lane, and seven empty ones";
    EXPECT_EQ(runs[1].colour->blocks[1].b[1], several);
    EXPECT_EQ(runs[2].single->blocks[0].b[7], single);
}

TEST(ContactPasses, two_thousand_contacts_are_multithreaded_except_overflow) {
    const auto graph = std::make_unique<ConstraintGraph>();
    add_contacts(*graph, low, 0, 1999);
    add_contacts(*graph, low, overflow_colours, 1);
    std::vector<ColourRun> runs;
    list_runs(*graph, index_of(low), index_of(low) + 1, runs);
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_FALSE(runs[0].shared);
    EXPECT_TRUE(runs[1].shared);
}

// Nothing bounces unless a lane says so; then none of the passes need be called.
TEST(ContactPasses, restitution_starts_only_if_a_lane_bounces) {
    const auto graph = std::make_unique<ConstraintGraph>();
    add_contacts(*graph, low, single_colours, 1);
    const ContactLaneRef place = lane_ref_at(*graph, low, single_colours, 0);
    std::vector<ColourRun> runs;
    list_runs(*graph, index_of(low), index_of(low) + 1, runs);
    SolverBodies bodies;
    bodies.resize(3);
    for (std::size_t k = 1; k < 3; k++) {
        bodies[k] = {};
        bodies[k].inverse_mass = 1;
    }
    // Along x, b comes at a with 4 m/s.
    place.block->normal[0][0] = 1;
    place.block->gap[0][0] = 0;
    bodies[2].v[0] = -4;
    ThreadPool thread_pool(1);
    const ContactSettings set = contact_settings(1.0 / 60, 8, SolverTier::low);
    const ContactTask task{runs, bodies.data(), set, thread_pool};
    EXPECT_FALSE(begin_restitution(task));
    place.meta->set(LaneFlag::bounces, 0, true);
    EXPECT_TRUE(begin_restitution(task));
    const auto& scratch = runs[0].single->restitutions[0];
    EXPECT_NEAR(double{scratch.approach[0][0]}, -4, 1e-6);
}

}  // namespace
}  // namespace jostle::test
