// SPDX-License-Identifier: MIT
#include "jostle/datagram/reassembly.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace jostle::datagram {
namespace {

// A message of so many bytes that differ, cut into its contents.
struct Cut {
    Cut(std::size_t bytes, std::uint32_t number) : whole(bytes, ' ') {
        for (std::size_t i = 0; i < bytes; i++) whole[i] = static_cast<char>(i * 31 + number);
        const std::string_view view = whole;
        contents = encode_message(std::span(&view, 1), number);
    }
    Fragment part(std::size_t k) const { return std::get<Fragment>(*decode_content(contents[k])); }

    std::string whole;
    std::vector<std::string> contents;
};

}  // namespace

TEST(Reassembly, a_message_of_20_kB_comes_whole_in_any_order) {
    std::mt19937_64 random(3);
    Reassembly reassembly;
    for (std::uint32_t number = 1; number <= 20; number++) {
        const Cut cut(20'000, number);
        std::vector<std::size_t> order(cut.contents.size());
        for (std::size_t k = 0; k < order.size(); k++) order[k] = k;
        for (std::size_t k = order.size() - 1; k > 0; k--)
            std::swap(order[k], order[random() % (k + 1)]);
        for (std::size_t k = 0; k < order.size(); k++) {
            const auto whole = reassembly.add(cut.part(order[k]));
            ASSERT_EQ(whole.has_value(), k + 1 == order.size());
            if (whole) {
                EXPECT_EQ(*whole, cut.whole);
            }
        }
    }
    EXPECT_EQ(reassembly.bytes_held(), 0u);
}

TEST(Reassembly, a_lost_part_costs_its_message_alone) {
    Reassembly reassembly;
    const Cut first(3000, 1), second(3000, 2);
    EXPECT_FALSE(reassembly.add(first.part(0)));
    EXPECT_FALSE(reassembly.add(second.part(2)));
    EXPECT_FALSE(reassembly.add(first.part(2)));
    EXPECT_FALSE(reassembly.add(second.part(0)));
    EXPECT_EQ(reassembly.add(second.part(1)), second.whole);
    EXPECT_FALSE(reassembly.add(first.part(1))) << "older than what was finished: of no use";
    EXPECT_EQ(reassembly.bytes_held(), 0u);
}

TEST(Reassembly, the_same_part_twice_is_one) {
    Reassembly reassembly;
    const Cut cut(2000, 1);
    EXPECT_FALSE(reassembly.add(cut.part(0)));
    EXPECT_FALSE(reassembly.add(cut.part(0)));
    EXPECT_EQ(reassembly.add(cut.part(1)), cut.whole);
}

TEST(Reassembly, holds_300_kB_at_most_and_the_newest_four) {
    Reassembly reassembly;
    for (std::uint32_t number = 1; number <= 100; number++) {
        const Cut cut(fragments_max * fragment_bytes, number);
        for (std::size_t k = 1; k < fragments_max; k++) EXPECT_FALSE(reassembly.add(cut.part(k)));
        EXPECT_LE(reassembly.bytes_held(), 4 * 63 * fragment_bytes);
    }
    EXPECT_FALSE(reassembly.add(Cut(fragments_max * fragment_bytes, 96).part(0)))
        << "it was given up";
    EXPECT_TRUE(reassembly.add(Cut(fragments_max * fragment_bytes, 97).part(0)));
}

TEST(Reassembly, a_part_that_does_not_fit_its_siblings_is_dropped) {
    Reassembly reassembly;
    const Cut two(2000, 1), three(3000, 1);
    EXPECT_FALSE(reassembly.add(two.part(0)));
    EXPECT_FALSE(reassembly.add(three.part(1)));
    EXPECT_EQ(reassembly.add(two.part(1)), two.whole);
}

}  // namespace jostle::datagram
