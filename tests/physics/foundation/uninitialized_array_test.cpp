// SPDX-License-Identifier: MIT
//
// Memory that is there when it is written, and not before.
#include "physics/src/foundation/uninitialized_array.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace jostle::test {
namespace {
using namespace physics;

struct alignas(16) Point {
    double x, y;
    std::uint32_t index;
};

TEST(UninitializedArray, keeps_and_copies_written_values) {
    UninitializedArray<Point, 128> points;
    EXPECT_EQ(sizeof points, 128 * sizeof(Point)) << "nothing but its elements";
    for (std::uint32_t k = 0; k < 4; k++) points[k] = {0.5 * k, -1.0 * k, k};
    const UninitializedArray<Point, 128> copy = points;
    points[2].x = 99;
    EXPECT_EQ(copy[2].x, 1);
    EXPECT_EQ(copy[3].y, -3);
    EXPECT_EQ(copy.data() + 3, &copy[3]);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(points.data()) % 16, 0u);
}

// The second half of what is asked for is kept in hand, so 100 to 200 takes no new memory.
TEST(UninitializedVector, allocates_twice_the_requested_memory_and_keeps_it) {
    UninitializedVector<Point> points;
    points.reserve_discarding(100);
    const Point* memory = &points[0];
    for (std::uint32_t k = 0; k < 200; k++) points[k] = {1, 2, k};
    points.reserve_discarding(10);
    points.reserve_discarding(200);
    EXPECT_EQ(&points[0], memory);
    EXPECT_EQ(points[199].index, 199u);
    points.reserve_discarding(201);
    points[401] = {1, 2, 401};
    EXPECT_EQ(points[401].index, 401u);
}

}  // namespace
}  // namespace jostle::test
