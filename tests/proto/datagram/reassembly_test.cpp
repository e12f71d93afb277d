// SPDX-License-Identifier: MIT
#include "jostle/datagram/reassembly.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace jostle::datagram {
namespace {

// A message of `size` differing bytes and its packet contents.
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

TEST(Reassembly, reassembles_a_20_kb_message_in_any_order) {
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

TEST(Reassembly, lost_fragment_drops_only_its_message) {
    Reassembly reassembly;
    const Cut first(3000, 1), second(3000, 2);
    EXPECT_FALSE(reassembly.add(first.part(0)));
    EXPECT_FALSE(reassembly.add(second.part(2)));
    EXPECT_FALSE(reassembly.add(first.part(2)));
    EXPECT_FALSE(reassembly.add(second.part(0)));
    EXPECT_EQ(reassembly.add(second.part(1)), second.whole);
    EXPECT_FALSE(reassembly.add(first.part(1))) << "older than a completed message";
    EXPECT_EQ(reassembly.bytes_held(), 0u);
}

TEST(Reassembly, ignores_duplicate_fragments) {
    Reassembly reassembly;
    const Cut cut(2000, 1);
    EXPECT_FALSE(reassembly.add(cut.part(0)));
    EXPECT_FALSE(reassembly.add(cut.part(0)));
    EXPECT_EQ(reassembly.add(cut.part(1)), cut.whole);
}

TEST(Reassembly, holds_at_most_300_kb_and_the_newest_four_messages) {
    Reassembly reassembly;
    for (std::uint32_t number = 1; number <= 100; number++) {
        const Cut cut(fragments_max * fragment_bytes, number);
        for (std::size_t k = 1; k < fragments_max; k++) EXPECT_FALSE(reassembly.add(cut.part(k)));
        EXPECT_LE(reassembly.bytes_held(), 4 * 63 * fragment_bytes);
    }
    EXPECT_FALSE(reassembly.add(Cut(fragments_max * fragment_bytes, 96).part(0)))
        << "the incomplete message was dropped";
    EXPECT_TRUE(reassembly.add(Cut(fragments_max * fragment_bytes, 97).part(0)));
}

TEST(Reassembly, drops_inconsistent_fragments) {
    Reassembly reassembly;
    const Cut two(2000, 1), three(3000, 1);
    EXPECT_FALSE(reassembly.add(two.part(0)));
    EXPECT_FALSE(reassembly.add(three.part(1)));
    EXPECT_EQ(reassembly.add(two.part(1)), two.whole);
}

}  // namespace jostle::datagram
