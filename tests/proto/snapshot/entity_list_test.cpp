// SPDX-License-Identifier: MIT
#include "jostle/snapshot/entity_list.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "tests/proto/snapshot/golden_entities.h"

namespace jostle::snapshot {
namespace {

constexpr std::size_t limit = 100'000;

TEST(EntityList, round_trips_and_equal_bodies_cost_less_than_a_bit_each) {
    for (const GoldenEntities& list : golden_entity_lists()) {
        const auto packed = encode_entity_list(list.entities, list.prototypes);
        const auto decoded = decode_entity_list(packed, list.prototypes, limit);
        ASSERT_TRUE(decoded.ok()) << decoded.error().message;
        EXPECT_EQ(*decoded, list.entities);
    }
    std::vector<ListedEntity> boxes, pile;
    for (std::uint32_t id = 1; id <= 20'000; id++) {
        boxes.push_back({id, 0});
        pile.push_back({id, id % 15});
    }
    EXPECT_LE(encode_entity_list(boxes, 1).size(), 20'000u / 8 + 8);
    EXPECT_LE(encode_entity_list(pile, 15).size(), 20'000u / 4 + 16);
}

TEST(EntityList, golden_file_is_unchanged) {
    std::ifstream in(GOLDEN_FOLDER "/entities.jent", std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    const auto made = golden_entity_file();
    ASSERT_EQ(bytes.size(), made.size()) << "run golden_frames proto/golden";
    EXPECT_EQ(bytes, std::string(reinterpret_cast<const char*>(made.data()), made.size()));
}

TEST(EntityList, malformed_bytes_are_refused) {
    const std::vector<ListedEntity> three{{1, 0}, {2, 4}, {9, 2}};
    const auto packed = encode_entity_list(three, 5);
    const auto message = [&](std::vector<std::byte> bytes, std::size_t prototypes,
                             std::size_t most) {
        const auto decoded = decode_entity_list(bytes, prototypes, most);
        return decoded.ok() ? std::string("accepted") : decoded.error().message;
    };
    EXPECT_EQ(message(packed, 5, limit), "accepted");
    EXPECT_NE(message(packed, 5, 2).find("number of entities exceeds"), std::string::npos);
    EXPECT_NE(message(packed, 0, limit).find("0 prototypes"), std::string::npos);
    EXPECT_NE(message({packed.begin(), packed.end() - 1}, 5, limit).find("truncated"),
              std::string::npos);
    auto longer = packed;
    longer.push_back(std::byte{0});
    EXPECT_NE(message(longer, 5, limit).find("at the end"), std::string::npos);
    std::mt19937 random(3);
    for (int k = 0; k < 20'000; k++) {
        auto flipped = packed;
        flipped[random() % flipped.size()] ^= std::byte{static_cast<unsigned char>(1 << k % 8)};
        const auto decoded = decode_entity_list(flipped, 5, limit);
        if (!decoded.ok()) continue;
        for (const ListedEntity& entity : *decoded) ASSERT_LT(entity.prototype, 5u);
    }
}

}  // namespace
}  // namespace jostle::snapshot
