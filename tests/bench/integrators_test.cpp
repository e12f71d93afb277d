// SPDX-License-Identifier: MIT
//
// The textbook orders in every field, and the energy drift.
#include <gtest/gtest.h>

#include "bench/integrators/integrator_row.h"

namespace {

using namespace jostle::bench::integrators;

class Orders : public testing::TestWithParam<const char*> {};

// The field changes rapidly near the focus of the ellipse: Euler methods need shorter steps to show
// their order.
TEST_P(Orders, are_1_1_1_2_4_and_2_in_every_field) {
    const IntegratorKind& kind = *find_integrator(GetParam());
    for (const ParticleField& field : all_fields()) {
        const bool rough = kind.order == 1 && field.name == "kepler";
        const double rate = rough ? 51200 : kind.order < 4 ? 1600 : 400;
        const auto rows = integrator_rows(field, kind, {rate, 2 * rate});
        ASSERT_TRUE(rows[1].order) << field.name;
        EXPECT_NEAR(*rows[1].order, kind.order, 0.2) << field.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Orders,
                         testing::Values("explicit", "semi-implicit", "implicit", "verlet", "rk4",
                                         "jostle"),
                         [](const auto& test) {
                             std::string name = test.param;
                             for (char& c : name)
                                 if (c == '-') c = '_';
                             return name;
                         });

IntegratorRow of_oscillator(const char* method) {
    return integrator_rows(*find_field("oscillator"), *find_integrator(method), {240}).front();
}

// Two seconds suffice: symplectic methods conserve the energy, explicit Euler gains energy.
TEST(Energy, is_conserved_by_symplectic_methods) {
    EXPECT_GT(*of_oscillator("explicit").energy_drift, 0.3);
    EXPECT_GT(*of_oscillator("implicit").energy_drift, 0.2);
    EXPECT_LT(*of_oscillator("semi-implicit").energy_drift, 0.03);
    EXPECT_LT(*of_oscillator("verlet").energy_drift, 2e-4);
    EXPECT_LT(*of_oscillator("rk4").energy_drift, 1e-7);
    EXPECT_FALSE(
        integrator_rows(*find_field("drag"), *find_integrator("rk4"), {240}).front().energy_drift);
}

// A world computes position Verlet in each sub-step.
TEST(Jostle, free_body_matches_verlet_at_eight_times_the_rate) {
    for (const ParticleField& field : all_fields()) {
        const auto ours = integrator_rows(field, *find_integrator("jostle"), {120});
        const auto verlet = integrator_rows(field, *find_integrator("verlet"), {960});
        EXPECT_NEAR(ours[0].error, verlet[0].error, 0.01 * verlet[0].error) << field.name;
    }
}

}  // namespace
