// SPDX-License-Identifier: MIT
//
// Curl noise is divergence-free, has the mean 0 and the root mean square 1.
#include "jostle/modules/curl_noise.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

using namespace physics;

// Divergence of a flow that is a polynomial of degree 6 along each axis within a cell. These
// differences are exact up to degree 8.
double divergence(const CurlNoise& noise, Vec3 p, double time, double step) {
    constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    double sum = 0;
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < 4; k++) {
            Vec3 offset;
            offset[axis] = (k + 1) * step;
            sum += weights[k] * (curl_noise(noise, p + offset, time)[axis] -
                                 curl_noise(noise, p - offset, time)[axis]);
        }
    return sum / step;
}

TEST(CurlNoise, is_divergence_free) {
    double worst = 0;
    test::Random random(3);
    for (int k = 0; k < 2000; k++) {
        // Cells of the third octave have a width of a quarter; all points stay within one.
        Vec3 p;
        for (int axis = 0; axis < 3; axis++)
            p[axis] = 0.25 * (std::floor(random.in(-400, 400)) + random.in(0.3, 0.7));
        const double d = divergence({.seed = 9, .octaves = 3}, p, random.in(0, 9), 0.015);
        worst = maximum(worst, absolute(d));
    }
    RecordProperty("worst_divergence", std::to_string(worst * 1e12) + "e-12");
    EXPECT_LT(worst, 1e-11);
}

// Averages over a period with Gauss quadrature of 4 points, which is exact for the integrand.
TEST(CurlNoise, has_zero_mean_and_unit_rms) {
    constexpr double nodes[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                0.8611363115940526};
    constexpr double weights[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                  0.3478548451374538};
    const CurlNoise noise{.seed = 4, .octaves = 2, .period = 4};
    const int cells = 8;  // of the second octave
    Vec3 mean;
    double square = 0;
    for (int cell = 0; cell < cells * cells * cells; cell++)
        for (int k = 0; k < 64; k++) {
            const int at[3] = {cell % cells, cell / cells % cells, cell / cells / cells};
            const int node[3] = {k % 4, k / 4 % 4, k / 16};
            Vec3 p;
            double weight = 1;
            for (int axis = 0; axis < 3; axis++) {
                p[axis] = (at[axis] + 0.5 + 0.5 * nodes[node[axis]]) * 0.5;
                weight *= weights[node[axis]] / 2 / cells;
            }
            const Vec3 u = curl_noise(noise, p, 2.3);
            mean += u * weight;
            square += length_squared(u) * weight;
        }
    RecordProperty("mean", std::to_string(length(mean) * 1e15) + "e-15");
    EXPECT_LT(length(mean), 1e-13);
    EXPECT_NEAR(square, 1, 0.15) << "a small period is one sample of the distribution";
}

TEST(CurlNoise, has_unit_rms_in_space_and_time) {
    test::Random random(8);
    const CurlNoise noise{.octaves = 4};
    Vec3 mean;
    double square = 0;
    constexpr int count = 200000;
    for (int k = 0; k < count; k++) {
        const Vec3 u = curl_noise(noise, random.vector(1e4), random.in(0, 3e3));
        mean += u * (1.0 / count);
        square += length_squared(u) / count;
    }
    RecordProperty("rms_error", std::to_string(square_root(square) - 1));
    EXPECT_LT(length(mean), 0.01) << "four standard deviations of the mean of all samples";
    EXPECT_NEAR(square_root(square), 1, 0.005);
}

TEST(CurlNoise, is_continuous_across_cells_and_in_time) {
    const CurlNoise noise{.octaves = 3};
    for (int k = -8; k < 8; k++) {
        const Vec3 p{0.25 * k, 0.25 * k + 0.1, -0.3};
        const Vec3 offset{1e-9, 0, 0};
        EXPECT_LT(length(curl_noise(noise, p + offset, k) - curl_noise(noise, p - offset, k)),
                  1e-7);
        EXPECT_LT(length(curl_noise(noise, p, k + 1e-9) - curl_noise(noise, p, k - 1e-9)), 1e-7);
    }
}

// The same on every machine: it uses only + - * / and integers.
TEST(CurlNoise, is_reproducible) {
    const Vec3 u = curl_noise({.seed = 7, .octaves = 3}, {12.3, -4.5, 678.9}, 1.7);
    EXPECT_TRUE(
        test::near(u, {-0.27608078238192635, -0.25645522800115755, 0.13118721934056746}, 1e-13));
    EXPECT_NE(curl_noise({.seed = 8, .octaves = 3}, {12.3, -4.5, 678.9}, 1.7), u);
}

}  // namespace
}  // namespace jostle::modules
