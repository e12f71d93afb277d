// SPDX-License-Identifier: MIT
//
// Emitters: how many particles, when, where, how fast; limits.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "modules/particles/src/emit.h"
#include "tests/modules/particles/with_particles.h"

namespace jostle::modules {
namespace {

ParticleGroup emitting(const Emitter& emitter, std::uint32_t count_max = 100000) {
    return test::must(ParticleGroup::create(
        {.count_max = count_max, .collide_bodies = false, .emitter = emitter}));
}

TEST(Emitter, rate_and_burst_emit_exact_numbers) {
    ParticleGroup rate = emitting({.rate = 333, .lifetime = 100});
    advance(rate, 600, 1.0 / 60);
    EXPECT_EQ(rate.size(), 3330u);
    ParticleGroup limited = emitting({.rate = 1000, .start = 0.5, .duration = 0.25, .lifetime = 9});
    advance(limited, 60, 1.0 / 60);
    EXPECT_EQ(limited.size(), 250u);
    ParticleGroup bursts = emitting({.burst = 7, .burst_period = 0.4, .start = 0.1, .lifetime = 9});
    advance(bursts, 60, 1.0 / 60);
    EXPECT_EQ(bursts.size(), 21u) << "at 0.1, 0.5 and 0.9 s";
    ParticleGroup once = emitting({.burst = 50, .start = 0.3, .lifetime = 9});
    advance(once, 60, 1.0 / 60);
    EXPECT_EQ(once.size(), 50u);
}

// The step does not matter: particles start between steps.
TEST(Emitter, particles_do_not_depend_on_the_step) {
    const Emitter fountain{
        .rate = 100, .speed = 5, .speed_spread = 0.3, .cone = 0.4, .lifetime = 9};
    ParticleGroup coarse = emitting(fountain), fine = emitting(fountain);
    advance(coarse, 20, 0.05, {0, -9.81, 0});
    advance(fine, 100, 0.01, {0, -9.81, 0});
    ASSERT_EQ(coarse.size(), fine.size());
    for (std::size_t k = 0; k < fine.size(); k++) {
        EXPECT_EQ(coarse.ids()[k], fine.ids()[k]);
        EXPECT_LT(length(coarse.positions()[k] - fine.positions()[k]), 1e-12);
        EXPECT_NEAR(coarse.ages()[k], fine.ages()[k], 1e-12);
    }
}

TEST(Emitter, particles_end_after_their_lifetime) {
    ParticleGroup group = emitting({.rate = 1000, .lifetime = 0.5, .lifetime_spread = 0.4});
    advance(group, 120, 1.0 / 60);
    EXPECT_NEAR(static_cast<double>(group.size()), 500, 15) << "rate times mean lifetime";
    for (const double age : group.ages()) EXPECT_LT(age, 0.7);
    EXPECT_EQ(std::set<std::uint32_t>(group.ids().begin(), group.ids().end()).size(), group.size());
}

TEST(Emitter, count_max_is_a_bound) {
    ParticleGroup group = emitting({.rate = 1e6, .burst = 100000, .lifetime = 1e6}, 777);
    advance(group, 10, 0.25);
    EXPECT_EQ(group.size(), 777u);
}

// Moments of the shapes: disc, box, ball; the cone is even in solid angle.
TEST(Emitter, shapes_and_cones_are_even) {
    const auto mean_square = [](Emitter emitter, auto&& value) {
        double sum = 0;
        for (std::uint64_t k = 0; k < 40000; k++) {
            const auto made = particles_detail::particle_at_rate(emitter, k, false);
            sum += value(made) / 40000;
        }
        return sum;
    };
    const Vec3 axis = normalized(Vec3{1, 2, -1});
    Emitter e{.position = {1, 2, 3}, .direction = axis * 5, .radius = 2, .rate = 1};
    const auto from = [&](const particles_detail::EmittedParticle& p) {
        return p.position - e.position;
    };
    const auto square = [&](const auto& p) { return length_squared(from(p)); };
    e.shape = EmitterShape::disc;
    EXPECT_NEAR(mean_square(e, square), 4.0 / 2, 0.03);
    EXPECT_LT(mean_square(e, [&](const auto& p) { return absolute(dot(from(p), axis)); }), 1e-12);
    e.shape = EmitterShape::sphere;
    EXPECT_NEAR(mean_square(e, square), 4 * 3.0 / 5, 0.03);
    e.shape = EmitterShape::box;
    e.half_extents = {1, 2, 3};
    EXPECT_NEAR(mean_square(e, square), (1 + 4 + 9) / 3.0, 0.06);
    e.cone = pi / 3;
    const double cosine =
        mean_square(e, [&](const auto& p) { return dot(normalized(p.velocity), axis); });
    EXPECT_NEAR(cosine, (1 + 0.5) / 2, 0.003) << "the cosine is even from 1/2 to 1";
}

TEST(Emitter, seeds_and_numbers_select_particles) {
    const Emitter one{.rate = 1, .cone = 1, .seed = 1}, two{.rate = 1, .cone = 1, .seed = 2};
    const auto velocity = [](const Emitter& e, std::uint64_t k) {
        return particles_detail::particle_at_rate(e, k, false).velocity;
    };
    EXPECT_EQ(velocity(one, 5), velocity(one, 5));
    EXPECT_NE(velocity(one, 5), velocity(two, 5));
    EXPECT_NE(velocity(one, 5), velocity(one, 6));
}

// Extreme times and rates end quickly and stay within the bound.
TEST(Emitter, extreme_settings_are_bounded) {
    for (const double rate : {1e-300, 1e-3, 1e6})
        for (const double time : {0.0, 1e6, 1e12, 1e300}) {
            ParticleGroup group = emitting({.rate = rate, .burst = 3, .burst_period = 1e-3}, 100);
            group.advance({}, time, time + 0.25);
            EXPECT_LE(group.size(), 100u);
        }
}

TEST(Emitter, invalid_definitions_are_named) {
    const auto error = [](const ParticleGroupDef& def) {
        const Status status = check(def);
        return status.ok() ? "" : status.error().message;
    };
    EXPECT_EQ(error({}), "");
    EXPECT_EQ(error({.count_max = 0}), "count_max is 0; it must be from 1 to 100000");
    EXPECT_EQ(error({.emitter = {.cone = 4}}),
              "emitter.cone is 4; it must be from 0 to 3.141592654");
    EXPECT_EQ(error({.emitter = {.burst_period = 1e-9}}),
              "emitter.burst_period is 1e-09; it must be 0 or at least 0.001");
    EXPECT_EQ(error({.planes = {{}, {.normal = {}}}}),
              "planes[1].normal has the length 0; it must be at least 1e-06");
    EXPECT_EQ(error({.flow = {.walls = std::vector<FlowWall>(9)}}),
              "flow.walls has 9 elements; it must have at most 8");
    EXPECT_EQ(error({.collide_particles = true}),
              "radius is 0; particles that hit each other need a radius");
    EXPECT_EQ(error({.count_max = 3000, .attraction = 1}),
              "count_max is 3000; it must be at most 2048 for particles that attract each other");
    EXPECT_EQ(error({.mass = std::nan("")}).substr(0, 4), "mass");
    EXPECT_EQ(error({.cosmetic = true, .emitter = {.rate = 1000, .lifetime = 2}}),
              "count_max is 1000; cosmetic particles need at least 2001 for the rate, bursts and "
              "lifetime of the emitter");
}

}  // namespace
}  // namespace jostle::modules
