// SPDX-License-Identifier: MIT
//
// Lanes in the order of their bodies.
#include "physics/src/state/contact_constraints.h"

#include <gtest/gtest.h>

namespace jostle::physics {
namespace {

TEST(Lanes, are_sorted_by_body_with_all_their_data) {
    ContactStore contacts;
    GraphColour colour;
    constexpr int lanes = 100;
    contacts.contacts.resize(lanes);
    for (int slot = 0; slot < lanes; slot++) {
        if (slot % 8 == 0) add_block(colour);
        const auto block = static_cast<std::size_t>(slot / 8);
        colour.blocks[block].a[slot % 8] = 1 + slot * 37 % lanes;
        colour.blocks[block].b[slot % 8] = 2 + slot * 37 % lanes;
        colour.blocks[block].mu[slot % 8] = static_cast<float>(slot);
        colour.metas[block].contact[slot % 8] = static_cast<std::uint32_t>(slot);
        contacts.contacts[static_cast<std::size_t>(slot)].slot = slot;
        colour.contacts++;
    }
    EXPECT_FALSE(is_sorted(colour));
    sort_contacts(contacts, colour, 0);
    EXPECT_TRUE(is_sorted(colour));
    ASSERT_EQ(colour.contacts, lanes);
    ASSERT_EQ(colour.blocks.size(), 13u);
    for (int slot = 0; slot < lanes; slot++) {
        const auto block = static_cast<std::size_t>(slot / 8);
        EXPECT_EQ(colour.blocks[block].a[slot % 8], 1 + slot);
        const std::uint32_t contact = colour.metas[block].contact[slot % 8];
        EXPECT_EQ(contacts.contacts[contact].slot, slot);
        EXPECT_EQ(colour.blocks[block].mu[slot % 8], static_cast<float>(contact)) << "its own row";
    }
}

}  // namespace
}  // namespace jostle::physics
