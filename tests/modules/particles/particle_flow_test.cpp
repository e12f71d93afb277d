// SPDX-License-Identifier: MIT
//
// The medium of particles: no divergence, tangential at walls, and tracers that stay even.
#include "jostle/modules/particle_flow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/modules/curl_noise.h"
#include "tests/modules/particles/with_particles.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

// Weights of central differences of order 16: exact for polynomials of degree 16. With n = 8,
// weight k = 2 (-1)^(k+1) (n!)^2 / (k (n-k)! (n+k)!), for (u(k) - u(-k)) / 2.
Mat3 differences(const ParticleFlow& flow, Vec3 p, double time, double step, bool planar = false) {
    constexpr double weights[] = {8.0 / 9,     -14.0 / 45,  56.0 / 495,  -7.0 / 198,
                                  56.0 / 6435, -2.0 / 1287, 8.0 / 45045, -1.0 / 102960};
    Mat3 gradient = diagonal({0, 0, 0});
    Vec3* columns[] = {&gradient.x, &gradient.y, &gradient.z};
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < 8; k++) {
            Vec3 offset;
            offset[axis] = (k + 1) * step;
            *columns[axis] += (flow_at(flow, p + offset, time, planar) -
                               flow_at(flow, p - offset, time, planar)) *
                              (weights[k] / step);
        }
    return gradient;
}

double trace(const Mat3& m) {
    return m.x.x + m.y.y + m.z.z;
}
double size_of(const Mat3& m) {
    return square_root(length_squared(m.x) + length_squared(m.y) + length_squared(m.z));
}

TEST(ParticleFlow, analytic_gradient_has_no_divergence_and_equals_differences) {
    const CurlNoise noise{.seed = 5, .octaves = 3};
    const ParticleFlow flow{.speed = 1, .rate = 1, .octaves = 3, .seed = 5};
    test::Random random(2);
    double worst_trace = 0, worst_gradient = 0;
    for (int k = 0; k < 500; k++) {
        Vec3 p;  // in the middle of a cell of the third octave
        for (int axis = 0; axis < 3; axis++)
            p[axis] = 0.25 * (std::floor(random.in(-400, 400)) + random.in(0.4, 0.6));
        const double time = random.in(0, 9);
        const Mat3 gradient = curl_noise_gradient(noise, p, time);
        worst_trace = maximum(worst_trace, absolute(trace(gradient)) / size_of(gradient));
        const Mat3 other = differences(flow, p, time, 0.01);
        worst_gradient = maximum(worst_gradient, size_of(gradient - other) / size_of(gradient));
    }
    RecordProperty("divergence", std::to_string(worst_trace * 1e15) + "e-15");
    RecordProperty("gradient_error", std::to_string(worst_gradient * 1e12) + "e-12");
    EXPECT_LT(worst_trace, 1e-13);
    EXPECT_LT(worst_gradient, 1e-11);
}

ParticleFlow between_walls() {
    return {.speed = 2,
            .scale = 1,
            .rate = 1,
            .octaves = 2,
            .seed = 3,
            .ramp = 0.8,
            .walls = {{.point = {0, 0, 0}, .normal = {0, 2, 0}},
                      {.point = {0.3, 0, 0}, .normal = {-1, 0.2, 0.1}},
                      {.point = {-1, 1, 0.5}, .radius = 0.4},
                      {.point = {0, 0, 0}, .radius = 9, .inside = true}}};
}

TEST(ParticleFlow, has_no_divergence_near_walls) {
    const ParticleFlow flow = between_walls();
    test::Random random(4);
    double worst = 0;
    int tested = 0;
    for (int k = 0; k < 20000 && tested < 400; k++) {
        Vec3 p;  // near walls, in the middle of a cell of the second octave
        for (int axis = 0; axis < 3; axis++)
            p[axis] = 0.5 * (std::floor(random.in(-4, 4)) + random.in(0.45, 0.55));
        const double wall = dot(normalized(Vec3{-1, 0.2, 0.1}), p - Vec3{0.3, 0, 0});
        const double ball = length(p - Vec3{-1, 1, 0.5}) - 0.4;
        const auto smooth = [](double d) { return d > 0.1 && absolute(d - 0.8) > 0.1; };
        if (!smooth(p.y) || !smooth(wall) || !smooth(ball)) continue;
        tested++;
        const Mat3 gradient = differences(flow, p, 1.3, 0.008);
        worst = maximum(worst, absolute(trace(gradient)) / maximum(size_of(gradient), 0.1));
    }
    RecordProperty("divergence", std::to_string(worst * 1e12) + "e-12");
    EXPECT_GT(tested, 200);
    EXPECT_LT(worst, 1e-10);
}

TEST(ParticleFlow, is_tangential_at_walls) {
    const ParticleFlow flow = between_walls();
    test::Random random(6);
    double worst = 0, fastest = 0;
    for (int k = 0; k < 2000; k++) {
        const Vec3 on_floor{random.in(-6, 0), 0, random.in(-6, 6)};
        const Vec3 u = flow_at(flow, on_floor, 0.1 * k);
        worst = maximum(worst, absolute(u.y));
        fastest = maximum(fastest, length(u));
        const Vec3 n = random.direction();
        const Vec3 v = flow_at(flow, Vec3{-1, 1, 0.5} + n * 0.4, 0.1 * k);
        worst = maximum(worst, absolute(dot(v, n)));
    }
    RecordProperty("normal_velocity", std::to_string(worst * 1e15) + "e-15");
    EXPECT_LT(worst, 1e-12);
    EXPECT_GT(fastest, 1) << "it slides along walls";
    EXPECT_EQ(flow_at(flow, {-1, -0.1, 0}, 1), (Vec3{})) << "behind the floor";
}

TEST(ParticleFlow, planar_flow_stays_in_the_plane_without_divergence) {
    ParticleFlow flow{
        .speed = 1, .octaves = 2, .ramp = 1, .walls = {{.point = {0, 0, 0}, .normal = {0, 1, 0}}}};
    test::Random random(8);
    double worst = 0, mean_square = 0;
    for (int k = 0; k < 500; k++) {
        const Vec3 p{0.5 * (std::floor(random.in(-40, 40)) + random.in(0.45, 0.55)),
                     0.25 + 0.5 * static_cast<double>(random.below(8)), 0};
        const Mat3 gradient = differences(flow, p, 0.7, 0.008, true);
        EXPECT_EQ(flow_at(flow, p, 0.7, true).z, 0);
        worst = maximum(worst, absolute(gradient.x.x + gradient.y.y) / size_of(gradient));
        EXPECT_LT(absolute(flow_at(flow, {p.x, 0, 0}, 0.7, true).y), 1e-12);
    }
    EXPECT_LT(worst, 1e-10);
    flow.walls = {};
    constexpr int count = 50000;
    for (int k = 0; k < count; k++)
        mean_square +=
            length_squared(flow_at(flow, random.vector(1e4), random.in(0, 1e3), true)) / count;
    EXPECT_NEAR(square_root(mean_square), 1, 0.02);
}

// Pearson's test: the sum over cells of (found - expected)^2 / expected has the mean `degrees` and
// the variance 2 degrees if the tracers are even.
double chi_square(std::span<const Vec3> points, int cells, Vec3 low, Vec3 size) {
    std::vector<int> found(static_cast<std::size_t>(cells * cells * cells));
    for (const Vec3& p : points) {
        const Vec3 at = p - low;
        const auto index = [&](double x, double length) {
            return std::clamp(static_cast<int>(x / length * cells), 0, cells - 1);
        };
        found[static_cast<std::size_t>((index(at.x, size.x) * cells + index(at.y, size.y)) * cells +
                                       index(at.z, size.z))]++;
    }
    const double expected = static_cast<double>(points.size()) / static_cast<double>(found.size());
    double sum = 0;
    for (const int n : found) sum += (n - expected) * (n - expected) / expected;
    return sum;
}

TEST(ParticleFlow, tracers_stay_even_in_a_box_of_walls) {
    const Vec3 low{0, 0, 0}, size{2, 2, 2};
    ParticleGroupDef def{.integrator = ParticleIntegrator::runge_kutta_4,
                         .count_max = 100000,
                         .follow_flow = true,
                         .collide_bodies = false};
    def.flow = {.speed = 1, .scale = 0.8, .rate = 0, .octaves = 1, .ramp = 0.5};
    for (int axis = 0; axis < 3; axis++)
        for (const double side : {0.0, 2.0}) {
            FlowWall wall{.point = {}, .normal = {}};
            wall.point[axis] = side;
            wall.normal[axis] = 1 - side;
            def.flow.walls.push_back(wall);
        }
    test::Random random(12);
    std::vector<ParticleStart> tracers(100000);
    for (ParticleStart& tracer : tracers)
        tracer.position = {random.in(0, 2), random.in(0, 2), random.in(0, 2)};
    ParticleGroup group = group_of(def, tracers);
    advance(group, 40, 0.1);
    double moved = 0;
    for (std::size_t k = 0; k < tracers.size(); k++) {
        const Vec3 p = group.positions()[k];
        moved += length(p - tracers[k].position) / 1e5;
        ASSERT_TRUE(p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= 2 && p.y <= 2 && p.z <= 2) << k;
    }
    EXPECT_GT(moved, 0.3) << "the tracers mix";
    constexpr int cells = 10, degrees = cells * cells * cells - 1;
    const double chi = chi_square(group.positions(), cells, low, size);
    RecordProperty("chi_square_per_degree", std::to_string(chi / degrees));
    EXPECT_LT(chi, degrees + 4 * std::sqrt(2.0 * degrees));
    EXPECT_GT(chi, degrees - 4 * std::sqrt(2.0 * degrees));
}

}  // namespace
}  // namespace jostle::modules
