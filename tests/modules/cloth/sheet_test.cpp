// SPDX-License-Identifier: MIT
//
// A sheet without a world against closed forms.
#include "modules/cloth/src/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace jostle::modules::cloth_detail {
namespace {

using namespace physics;

constexpr double g = 9.81;

// Holds vertices where they are.
void pin(Sheet& sheet, const std::function<bool(std::size_t)>& held) {
    for (std::size_t k = 0; k < sheet.size(); k++)
        if (held(k)) sheet.set_inverse_mass(k, 0);
}

void advance(Sheet& sheet, double seconds, double damping, Vec3 gravity = {0, -g, 0},
             int least = 8) {
    const int steps = static_cast<int>(std::lround(seconds * 60));
    for (int n = 0; n < steps; n++) {
        const int parts = sheet.stable_parts(1.0 / 60, least);
        const double h = 1.0 / 60 / parts;
        for (int k = 0; k < parts; k++) {
            sheet.predict(h, gravity);
            for (std::size_t v = 0; v < sheet.size(); v++)
                if (sheet.inverse_mass(v) == 0) sheet.set_moved(v, {});
            sheet.solve_bends(h);
            sheet.solve_threads(h);
            sheet.finish(h, gravity, damping);
        }
    }
}

double lowest(const Sheet& sheet) {
    double y = 1e9;
    for (std::size_t k = 0; k < sheet.size(); k++) y = std::min(y, sheet.position(k).y);
    return y;
}

TEST(Sheet, of_100_rows_hangs_without_surplus_stretch) {
    const ClothDef def{
        .grid = {.rows = 100, .columns = 20, .across = {0.2, 0, 0}, .down = {0, -1, 0}}};
    Sheet sheet(def);
    pin(sheet, [](std::size_t k) { return k < 20; });
    double most = 0;
    for (int n = 0; n < 20; n++) {
        advance(sheet, 0.1, 0.5);
        most = std::max(most, -lowest(sheet) - 1);
    }
    const double closed = def.mass_per_area * g / (2 * def.stretch_stiffness);  // 0.0196 %
    EXPECT_NEAR(-lowest(sheet) - 1, closed, 2e-6);
    EXPECT_LT(most, closed + 1e-5);
}

// rho g L^2 / 2E for any number of rows, so the error is that of single precision.
TEST(Sheet, strip_under_its_weight_stretches_as_the_closed_form) {
    for (const std::uint32_t rows : {6u, 11u, 21u, 41u, 81u}) {
        const ClothDef def{
            .grid = {.rows = rows, .columns = 3, .across = {0.1, 0, 0}, .down = {0, -1, 0}},
            .stretch_stiffness = 50};
        Sheet sheet(def);
        pin(sheet, [](std::size_t k) { return k < 3; });
        advance(sheet, 6, 3);
        const double closed = def.mass_per_area * g / (2 * def.stretch_stiffness);
        EXPECT_NEAR((-lowest(sheet) - 1) / closed, 1, 1e-4) << rows;
    }
}

// Swung from the horizontal, a sheet that is hardly extensible stays so in motion.
TEST(Sheet, of_100_rows_swings_down_without_surplus_stretch) {
    const ClothDef def{
        .grid = {.rows = 100, .columns = 10, .across = {0.1, 0, 0}, .down = {0, 0, 1}}};
    Sheet sheet(def);
    pin(sheet, [](std::size_t k) { return k < 10; });
    double most = 0;
    for (int n = 0; n < 120; n++) {
        advance(sheet, 1.0 / 60, 0.1);
        for (std::size_t c = 0; c < 10; c++) {
            double line = 0;
            for (std::size_t r = 1; r < 100; r++)
                line += length(sheet.position(10 * r + c) - sheet.position(10 * (r - 1) + c));
            most = std::max(most, line - 1);
        }
    }
    EXPECT_LT(most, 0.01);
}

// A sheet of length s between rails at a distance d hangs as the catenary.
TEST(Sheet, between_rails_hangs_as_the_catenary) {
    const double d = 1, s = 1.2;
    const ClothDef def{
        .grid = {.rows = 61, .columns = 7, .across = {0.12, 0, 0}, .down = {0, 0, d}, .height = s},
        .stretch_stiffness = 20000,
        .bending_stiffness = 0};
    Sheet sheet(def);
    pin(sheet, [](std::size_t k) { return k < 7 || k >= 60 * 7; });
    advance(sheet, 8, 2);
    // s = 2 a sinh(d / 2a), sag = a (cosh(d / 2a) - 1)
    double low = 0.01, high = 10;
    for (int n = 0; n < 100; n++) {
        const double a = 0.5 * (low + high);
        (2 * a * std::sinh(d / (2 * a)) > s ? low : high) = a;
    }
    const double sag = low * (std::cosh(d / (2 * low)) - 1);
    EXPECT_NEAR(-lowest(sheet) / sag, 1, 0.01);
    double worst = 0;
    for (int r = 0; r < 61; r++) {
        const Vec3 p = sheet.position(7 * r + 3);
        const double z = p.z - d / 2;
        worst = std::max(worst, std::abs(p.y - (low * (std::cosh(z / low) - 1) - sag)));
    }
    EXPECT_LT(worst, 0.01 * sag);
}

TEST(Sheet, keeps_its_momentum_in_free_motion) {
    const ClothDef def{.grid = {.rows = 20, .columns = 20}, .damping = 0};
    Sheet sheet(def);
    Vec3 before;
    for (std::size_t k = 0; k < sheet.size(); k++) {
        const auto x = static_cast<double>(k % 20), y = static_cast<double>(k / 20);
        sheet.set_velocity(k, {1 + 0.3 * std::sin(x), 0.5 * std::cos(0.7 * y), std::sin(x + y)});
        before += sheet.velocity(k) / sheet.free_inverse_mass(k);
    }
    advance(sheet, 2, 0, {});
    Vec3 after;
    for (std::size_t k = 0; k < sheet.size(); k++)
        after += sheet.velocity(k) / sheet.free_inverse_mass(k);
    EXPECT_LT(length(after - before), 1e-6 * length(before));
}

// Waves across a sheet under tension T (N/m): f = sqrt(T / rho) / 2L. Without damping, they lose
// energy only as fast as the sub-steps are long.
TEST(Sheet, under_tension_vibrates_at_the_frequency_of_a_membrane) {
    const double strain = 0.01, amplitude = 0.005;
    const ClothDef def{.grid = {.rows = 41,
                                .columns = 5,
                                .across = {0.1, 0, 0},
                                .down = {0, 0, 1 + strain},
                                .height = 1},
                       .stretch_stiffness = 400,
                       .shear_stiffness = 0,
                       .bending_stiffness = 0};
    Sheet sheet(def);
    pin(sheet, [](std::size_t k) { return k < 5 || k >= 200; });
    for (std::size_t k = 0; k < sheet.size(); k++) {
        const Vec3 p = sheet.position(k);
        sheet.set_position(k, {p.x, amplitude * std::sin(pi * p.z / (1 + strain)), p.z});
    }
    const double h = 1.0 / 480;
    int crossings = 0;
    double first = 0, last = 0, before = amplitude, peak = 0;
    for (int n = 1; n <= 480 * 4; n++) {
        sheet.predict(h, {});
        for (std::size_t v = 0; v < sheet.size(); v++)
            if (sheet.inverse_mass(v) == 0) sheet.set_moved(v, {});
        sheet.solve_bends(h);
        sheet.solve_threads(h);
        sheet.finish(h, {}, 0);
        const double y = sheet.position(102).y;
        if (n > 480 * 3) peak = std::max(peak, y);
        if (before > 0 && y <= 0) {
            last = (n - y / (y - before)) * h;
            if (crossings++ == 0) first = last;
        }
        before = y;
    }
    const double frequency = (crossings - 1) / (last - first);
    const double closed =
        std::sqrt(400 * strain / (0.2 * (1 + strain))) / (2 * (1 + strain)) * std::sqrt(1 + strain);
    EXPECT_NEAR(frequency / closed, 1, 0.01);
    // Of the sub-steps: the rate w^2 h / 4 (sheet_kernel_body.h).
    const double rate = 4 * pi * pi * closed * closed * h / 4;
    EXPECT_NEAR(peak / (amplitude * std::exp(-rate * 3.2)), 1, 0.03);
}

// A strip held level at one end bends as an Euler-Bernoulli cantilever under its weight, w = rho g
// L^4 / 8 B. One pass per sub-step bends more than that.
TEST(Sheet, held_at_one_end_bends_as_a_cantilever) {
    const double stiffness = 1e-5, span = 0.2;
    const ClothDef def{
        .grid = {.rows = 13, .columns = 5, .across = {0.08, 0, 0}, .down = {0, 0, span * 12 / 11}},
        .bending_stiffness = stiffness};
    Sheet sheet(def);
    pin(sheet, [](std::size_t k) { return k < 10; });
    advance(sheet, 30, 1, {0, -1e-3, 0});
    // The first hinge takes half a row of the clamp.
    const double closed = 0.2 * 1e-3 * std::pow(span * 11.5 / 11, 4) / (8 * stiffness);
    EXPECT_NEAR(-lowest(sheet) / closed, 1.1, 0.15);
}

TEST(Sheet, of_a_mesh_covers_each_edge_with_one_chain) {
    // A tube of 12 x 8 quads.
    ClothDef def;
    for (std::uint32_t r = 0; r <= 8; r++)
        for (std::uint32_t c = 0; c < 12; c++)
            def.vertices.push_back(
                {0.2 * std::cos(c * pi / 6), -0.1 * r, 0.2 * std::sin(c * pi / 6)});
    for (std::uint32_t r = 0; r < 8; r++)
        for (std::uint32_t c = 0; c < 12; c++) {
            const std::uint32_t a = 12 * r + c, b = 12 * r + (c + 1) % 12;
            def.triangles.insert(def.triangles.end(), {a, b, a + 12, b, b + 12, a + 12});
        }
    Sheet sheet(def);
    std::size_t links = 0;
    for (const auto& chain : sheet.topology().chains) {
        links += chain.size() - 1;
        std::vector<std::uint32_t> sorted = chain;
        std::ranges::sort(sorted);
        EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
    }
    EXPECT_EQ(links, sheet.topology().edges.size());
    EXPECT_EQ(links, 12u * 9 + 12 * 8 + 12 * 8);
    pin(sheet, [](std::size_t k) { return k < 12; });
    advance(sheet, 3, 1);
    EXPECT_NEAR(lowest(sheet), -0.8, 0.005);
}

}  // namespace
}  // namespace jostle::modules::cloth_detail
