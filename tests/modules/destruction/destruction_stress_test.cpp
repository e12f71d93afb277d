// SPDX-License-Identifier: MIT
//
// Loads of bonds, compared with beam theory.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/modules/destruction/walls.h"

namespace jostle::modules {
namespace {

using namespace physics;

constexpr double h = 0.4, width = 0.3, density = 2400, g = 9.81;

// A beam along x, held at its first column, whose face is at x = 0. It has the given number of
// columns of 0.2 m.
FracturedShape cantilever(int columns, int rows) {
    const double column = 0.2;
    FracturedShape shape =
        split_box({0.5 * column * (columns + 1), 0.5 * h, 0.5 * width}, columns + 1, rows, 1)
            .value();
    EXPECT_EQ(anchor(shape, {-1, 0, 0}, 0.5 * column * (columns + 1) - 1e-9),
              static_cast<std::size_t>(rows));
    return shape;
}

// The largest stress at the root, 3 rho g L^2 / h.
double stress(double length) {
    return 3 * density * g * length * length / h;
}

DestructibleDef beam(double tensile) {
    return {.density = density, .bonds = {.tensile = tensile, .shear = 1e9}};
}

void expect_breaks_at_its_length(int rows) {
    const int columns = 40;
    const double tensile = stress(0.2 * columns);
    Stage stage;
    const DestructibleId own = stage.add(cantilever(columns, rows), beam(tensile));
    const double load = *stage.destruction->max_load_ratio(stage.world, own);
    // The load is proportional to the square of the length.
    const double length_error = std::sqrt(1 / load) - 1;
    ::testing::Test::RecordProperty("length_error", std::to_string(length_error));
    EXPECT_LT(std::abs(length_error), 0.05);
    // 38 columns (5 % less) hold; 42 (5 % more) break at the root.
    for (const int length : {38, 42}) {
        Stage other;
        const FracturedShape shape = cantilever(length, rows);
        const DestructibleId id = other.add(shape, beam(tensile));
        other.step(10);
        const bool broke = *other.destruction->intact_bonds(id) < shape.bonds.size();
        EXPECT_EQ(broke, length == 42) << length;
        EXPECT_EQ(other.destruction->bodies(id)->size() > 1, length == 42);
    }
}

TEST(DestructionStress, one_row_cantilever_breaks_at_its_critical_length) {
    expect_breaks_at_its_length(1);
}
TEST(DestructionStress, two_row_cantilever_breaks_at_its_critical_length) {
    expect_breaks_at_its_length(2);
}
TEST(DestructionStress, four_row_cantilever_breaks_at_its_critical_length) {
    expect_breaks_at_its_length(4);
}

// A column hangs from its top: the stress at the top is rho g L for any number of chunks.
TEST(DestructionStress, hanging_column_carries_its_own_weight) {
    const Vec3 half{0.2, 2, 0.2};
    FracturedShape column = split_box(half, 1, 20, 1).value();
    anchor(column, {0, 1, 0}, 2 - 1e-9);
    Stage stage;
    const DestructibleId id =
        stage.add(column, {.density = density, .bonds = {.tensile = 1e6, .shear = 1e9}});
    EXPECT_NEAR(*stage.destruction->max_load_ratio(stage.world, id), density * g * 3.8 / 1e6, 1e-9);
}

// A rod rotates about its middle: the stress in the middle is rho w^2 l^2 / 2, where l is half of
// its length.
TEST(DestructionStress, overspeeding_rod_breaks_in_the_middle) {
    const double l = 2, tensile = 1e6;
    const double w = std::sqrt(2 * tensile / (density * l * l));
    for (const double share : {0.97, 1.03}) {
        Stage stage({.gravity = {}});
        const DestructibleId id = stage.add(split_box({l, 0.1, 0.1}, 40, 1, 1).value(),
                                            {.angular_velocity = {0, 0, share * w},
                                             .density = density,
                                             .bonds = {.tensile = tensile}});
        stage.step(3);
        EXPECT_EQ(stage.destruction->bodies(id)->size() > 1, share > 1) << share;
    }
}

// A beam with two held ends is evaluated again when a weight is placed in its middle.
TEST(DestructionStress, overloaded_shelf_breaks) {
    for (const double mass : {50.0, 1500.0}) {
        FracturedShape shelf = split_box({1.5, 0.05, 0.3}, 15, 1, 1).value();
        anchor(shelf, {-1, 0, 0}, 1.5 - 1e-9);
        anchor(shelf, {1, 0, 0}, 1.5 - 1e-9);
        Stage stage;
        const DestructibleId id = stage.add(
            shelf, {.pose = {.position = {0, 2, 0}}, .bonds = {.tensile = 3e6, .shear = 5e6}});
        stage.step(3);
        stage.world
            .create_body({.pose = {.position = {0, 2.151, 0}}, .mass = mass},
                         {.geometry = Box{{0.1, 0.1, 0.1}}})
            .value();
        stage.step(60);
        EXPECT_EQ(stage.destruction->bodies(id)->size() > 1, mass > 100) << mass;
    }
}

}  // namespace
}  // namespace jostle::modules
