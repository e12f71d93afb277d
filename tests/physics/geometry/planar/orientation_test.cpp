// SPDX-License-Identifier: MIT
//
// On which side a point is, against integers of 128 bits, where rounding does not know.
#include <gtest/gtest.h>

#include <array>

#include "jostle/physics/planar.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

__extension__ typedef __int128 Wide;

// Whole coordinates of up to 53 bits.
Wide exact(Vec2 a, Vec2 b, Vec2 c) {
    const auto from = [](double x, double y) { return Wide(x) - Wide(y); };
    return from(a.x, c.x) * from(b.y, c.y) - from(a.y, c.y) * from(b.x, c.x);
}

int sign(Wide x) {
    return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

Vec2 random_whole(Random& random, double size) {
    const double x = std::floor(random.in(-size, size));
    return {x, std::floor(random.in(-size, size))};
}

// c lies within a few units of the line through a and b. `scale` is a power of two.
void compare_near_lines(double size, double scale, int rounds) {
    Random random(7);
    int exact_zeros = 0, rounded_wrong = 0;
    for (int k = 0; k < rounds; k++) {
        const Vec2 a = random_whole(random, size), b = random_whole(random, size);
        const double t = random.in(-1, 1);
        Vec2 c = a + (b - a) * (random.below(4) == 0 ? 0.5 : t);
        c = {std::floor(c.x), std::floor(c.y)};
        const Wide area = exact(a, b, c);
        const Vec2 p = a * scale, q = b * scale, r = c * scale;
        ASSERT_EQ(orientation(p, q, r), sign(area));
        ASSERT_EQ(orientation(q, r, p), sign(area));
        ASSERT_EQ(orientation(q, p, r), -sign(area));
        const double value = doubled_area(p, q, r) / scale / scale;
        ASSERT_LE(absolute(value - static_cast<double>(area)),
                  1e-15 * absolute(static_cast<double>(area)));
        exact_zeros += area == 0 ? 1 : 0;
        const double rounded = cross(p - r, q - r);
        rounded_wrong += (rounded > 0 ? 1 : (rounded < 0 ? -1 : 0)) != sign(area) ? 1 : 0;
    }
    // The cases are hard: some are zero, and a rounded determinant errs in some.
    EXPECT_GT(exact_zeros, 0);
    if (size > 0x1p50) {
        EXPECT_GT(rounded_wrong, 0);
    }
}

TEST(Orientation, matches_integer_arithmetic_near_a_line) {
    for (const double size : {10.0, 0x1p20, 0x1p52}) compare_near_lines(size, 1, 20000);
}

TEST(Orientation, is_exact_for_tiny_and_huge_coordinates) {
    for (const double scale : {0x1p-420, 0x1p-60, 0x1p200, 0x1p370})
        compare_near_lines(0x1p52, scale, 5000);
}

// The grid of 256 x 256 neighbouring doubles about (0.5, 0.5) against a line that passes through
// it (Kettner et al., "Classroom examples of robustness problems in geometric computations", 2008).
// With rounded determinants the picture is full of spots.
TEST(Orientation, is_consistent_for_adjacent_doubles_near_a_diagonal) {
    constexpr double unit = 0x1p-53;
    int wrong = 0;
    for (int i = 0; i < 256; i++)
        for (int j = 0; j < 256; j++) {
            const Vec2 p{0.5 + i * unit, 0.5 + j * unit};
            ASSERT_EQ(orientation(p, {12, 12}, {24, 24}), j == i ? 0 : (j > i ? 1 : -1))
                << i << " " << j;
            const double rounded = cross(Vec2{12, 12} - p, Vec2{24, 24} - p);
            wrong += (rounded > 0) != (j > i) ? 1 : 0;
        }
    EXPECT_GT(wrong, 100) << "the cases are not hard";
}

TEST(Orientation, is_zero_for_equal_points) {
    const Vec2 a{0.1, 0.2}, b{0.3, 1e-20};
    for (const auto& [p, q, r] : {std::array{a, a, a}, std::array{a, a, b}, std::array{a, b, a}}) {
        EXPECT_EQ(orientation(p, q, r), 0);
        EXPECT_EQ(doubled_area(p, q, r), 0);
    }
    EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
    EXPECT_EQ(doubled_area({0, 0}, {3, 0}, {0, 2}), 6);
}

}  // namespace
}  // namespace jostle::test
