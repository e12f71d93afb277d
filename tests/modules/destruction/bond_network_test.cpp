// SPDX-License-Identifier: MIT
#include "modules/destruction/src/bond_network.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::modules::destruction_detail {
namespace {

constexpr FractureBond face{.a = 0,
                            .b = 0,
                            .center = {},
                            .normal = {1, 0, 0},
                            .axis = {0, 1, 0},
                            .area = 0.04,
                            .moment_u = 1.2e-4,
                            .moment_v = 1.5e-4,
                            .reach_u = 0.1,
                            .reach_v = 0.1};
constexpr BondMaterial material{.young = 3e10, .poisson = 0.2};
constexpr double shear_modulus = material.young / (2 * (1 + material.poisson));

// `count` cubes of 1 m in a row along x. The first one is held by another cube if `held`.
std::vector<Beam> row(std::uint32_t count, bool held) {
    std::vector<Beam> beams;
    for (std::uint32_t k = held ? 0 : 1; k < count; k++)
        beams.push_back({.face = &face,
                         .a = k == 0 ? fixed_unknown : k - 1,
                         .b = k,
                         .arm_a = {0.5, 0, 0},
                         .arm_b = {-0.5, 0, 0},
                         .length = 1});
    return beams;
}

}  // namespace

TEST(StiffnessFactor, a_row_stretches_by_force_times_length_over_stiffness) {
    const std::uint32_t count = 50;
    const StiffnessFactor factor(row(count, true), count, material);
    std::vector<Vec6> x(count, Vec6{});
    x.back()[0] = 1000;  // N
    factor.solve(x);
    const double each = 1000 / (material.young * face.area);
    for (std::uint32_t k = 0; k < count; k++) {
        EXPECT_NEAR(x[k][0], (k + 1) * each, 1e-9 * count * each) << k;
        EXPECT_NEAR(x[k][1], 0, 1e-9 * each);
    }
    EXPECT_EQ(factor.work(), 3 * count - 2u) << "a chain has no fill-in";
}

// The cubes are rigid: a load at distance d from a face turns it by load d l / (E I).
TEST(StiffnessFactor, a_row_bends_like_a_cantilever) {
    const std::uint32_t count = 20;
    const StiffnessFactor factor(row(count, true), count, material);
    std::vector<Vec6> x(count, Vec6{});
    x.back()[1] = 1000;  // N along y, bends about z
    factor.solve(x);
    double expected = count * 1000 / (shear_modulus * face.area);
    for (std::uint32_t k = 0; k < count; k++) {
        const double arm = 0.5 + k;
        expected += 1000 * arm * arm / (material.young * face.moment_v);
    }
    EXPECT_NEAR(x.back()[1], expected, 1e-8 * expected);
}

TEST(StiffnessFactor, directions_without_support_stay_finite) {
    const std::uint32_t count = 3;
    const StiffnessFactor factor(row(count, false), count, material);
    std::vector<Vec6> x(count, Vec6{});
    x.front()[0] = -1000, x.back()[0] = 1000;
    factor.solve(x);
    const double each = 1000 / (material.young * face.area);
    EXPECT_NEAR(x[2][0] - x[0][0], 2 * each, 1e-6 * each);
    for (const Vec6& moved : x)
        for (const double value : moved) EXPECT_LT(std::abs(value), 10 * each);
}

// A cube hangs on a bond that is 1e8 times weaker in bending than the others.
TEST(StiffnessFactor, a_weak_bond_still_carries_its_load) {
    FractureBond weak = face;
    weak.area = 1e-4 * face.area;
    weak.moment_u = weak.moment_v = 1e-8 * face.moment_u;
    std::vector<Beam> beams = row(4, true);
    beams[1].face = &weak;
    const StiffnessFactor factor(beams, 4, material);
    std::vector<Vec6> x(4, Vec6{});
    x.back()[5] = 1;  // N m about z
    factor.solve(x);
    const double weak_turn = 1 / (material.young * weak.moment_v);
    EXPECT_NEAR(x[1][5] - x[0][5], weak_turn, 1e-3 * weak_turn);
}

}  // namespace jostle::modules::destruction_detail
