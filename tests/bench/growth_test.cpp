// SPDX-License-Identifier: MIT
#include "bench/speed/growth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace jostle::bench;

void expect_measured(const char* scene) {
    const GrowthRow row =
        measure_growth_in_child(*find_growth_scene(scene), *find_engine_kind("jostle"), 1, 40);
    ASSERT_FALSE(row.failed) << *row.failed;
    EXPECT_EQ(row.scene, scene);
    EXPECT_EQ(row.bodies, 40);
    EXPECT_EQ(row.clock, "cpu");
    EXPECT_GT(row.ms_mean, 0);
    EXPECT_GT(row.bytes_per_body, 100);
    EXPECT_EQ(to_json(growth_row_from(to_json(row))), to_json(row));
}

TEST(Growth, small_pile_and_chain_report_time_and_bytes_per_body) {
    expect_measured("pile");
    expect_measured("chain");
    EXPECT_EQ(find_growth_scene("cloth"), nullptr);
}

TEST(Growth, chain_has_one_link_per_body_and_a_fixed_one) {
    const auto chain = find_growth_scene("chain")->make(40);
    EXPECT_EQ(chain.bodies.size(), 41u);
    EXPECT_EQ(chain.joints.size(), 40u);
}

GrowthRow timed(const char* engine, int threads, int bodies, double ms_mean) {
    return {.engine = engine, .threads = threads, .bodies = bodies, .ms_mean = ms_mean};
}

// 2 us * bodies^1.5 for one engine; a fit through the points (1, 1), (10, 10), (100, 1000) for the
// other, whose slope is log10(1000) / 2 by symmetry.
TEST(Growth, exponent_is_the_slope_of_the_logarithms) {
    std::vector<GrowthRow> rows;
    for (const int bodies : {10, 100, 1000, 10000})
        rows.push_back(timed("jostle", 1, bodies, 2e-3 * bodies * std::sqrt(bodies)));
    rows.push_back(timed("ode", 1, 1, 1));
    rows.push_back(timed("ode", 1, 10, 10));
    rows.push_back(timed("ode", 1, 100, 1000));
    const std::vector<GrowthFit> fits = fit_growth(rows);
    ASSERT_EQ(fits.size(), 2u);
    EXPECT_EQ(fits[0].engine, "jostle");
    EXPECT_NEAR(*fits[0].exponent, 1.5, 1e-12);
    EXPECT_NEAR(*fits[1].exponent, 1.5, 1e-12);
    EXPECT_EQ(to_json(fits[0]).dump(), R"({"engine":"jostle","threads":1,"exponent":1.5})");
}

TEST(Growth, exponent_requires_two_sizes_and_skips_failed_rows) {
    GrowthRow failed = timed("jostle", 2, 1000, 0);
    failed.failed = "ended by signal 9";
    const std::vector<GrowthFit> fits = fit_growth(std::vector<GrowthRow>{
        timed("jostle", 1, 10, 1), timed("jostle", 1, 10, 2), timed("jostle", 2, 10, 1), failed});
    ASSERT_EQ(fits.size(), 2u);
    EXPECT_EQ(fits[0].exponent, std::nullopt);
    EXPECT_EQ(fits[1].threads, 2);
    EXPECT_EQ(fits[1].exponent, std::nullopt);
    EXPECT_TRUE(to_json(fits[1]).at("exponent").is_null());
}

}  // namespace
