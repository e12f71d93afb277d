// SPDX-License-Identifier: MIT
//
// A flat array's assignment is a vector's, below and above the size from which it writes past the
// caches.
#include "physics/src/foundation/flat_array.h"

#include <gtest/gtest.h>

#include <numeric>

namespace jostle::test {
namespace {
using physics::FlatArray;

struct Record {
    std::uint32_t words[5];  // 20 bytes: the end is not on a line's border

    bool operator==(const Record&) const = default;
};

FlatArray<Record> numbered(std::uint32_t count, std::uint32_t first) {
    FlatArray<Record> records(count);
    for (Record& record : records)
        for (std::uint32_t& word : record.words) word = first++;
    return records;
}

TEST(FlatArray, copies_at_any_size) {
    FlatArray<Record> to = numbered(60000, 7);
    for (const std::uint32_t count : {0u, 1u, 3u, 6553u, 6554u, 20000u, 59999u, 60000u, 61000u}) {
        const FlatArray<Record> from = numbered(count, count);
        to = from;
        ASSERT_EQ(to, from) << count << " records";
    }
}

TEST(FlatArray, keeps_its_memory_if_large_enough) {
    FlatArray<Record> to = numbered(20000, 1);
    const Record* memory = to.data();
    const FlatArray<Record> few = numbered(10, 2);
    to = few;
    const FlatArray<Record> larger = numbered(19000, 3);
    to = larger;
    EXPECT_EQ(to.data(), memory);
    EXPECT_EQ(to, larger);
}

TEST(FlatArray, supports_self_assignment) {
    FlatArray<Record> records = numbered(30000, 5);
    const FlatArray<Record>& same = records;
    records = same;
    EXPECT_EQ(records, numbered(30000, 5));
}

// Lengths around the 64 bytes that go at once; what lies behind stays as it was.
TEST(CopyPastCaches, writes_the_requested_number_of_bytes) {
    alignas(64) unsigned char from[400], to[400];
    std::iota(from, from + 400, static_cast<unsigned char>(1));
    for (const std::size_t bytes : {0u, 1u, 63u, 64u, 65u, 128u, 333u}) {
        std::memset(to, 0xee, sizeof to);
        physics::copy_past_caches(to, from + 3, bytes);
        ASSERT_EQ(std::memcmp(to, from + 3, bytes), 0) << bytes;
        ASSERT_EQ(to[bytes], 0xee) << bytes;
    }
}

}  // namespace
}  // namespace jostle::test
