// SPDX-License-Identifier: MIT
//
// Particles from the settings of a scene, and the channels for clients.
#include <gtest/gtest.h>

#include <bit>

#include "tests/modules/particles/with_particles.h"

namespace jostle::modules {
namespace {

TEST(ParticlesScene, reads_settings) {
    World world = test::make_world();
    Particles module;
    test::must(module.configure(world, {.numbers = {{"integrator", 4},
                                                    {"count_max", 50},
                                                    {"radius", 0.1},
                                                    {"collide_particles", 1},
                                                    {"color", 0x336699},
                                                    {"emitter_shape", 2},
                                                    {"emitter_rate", 10},
                                                    {"emitter_direction_x", 1},
                                                    {"flow_speed", 2},
                                                    {"flow_walls1_normal_y", 1},
                                                    {"attractors1_falloff", -1},
                                                    {"planes1_offset", -1},
                                                    {"planes2_normal_x", 1},
                                                    {"particles1_position_y", 3},
                                                    {"particles2_velocity_z", 1},
                                                    {"springs1_from", 1},
                                                    {"springs1_to", 1},
                                                    {"springs2_anchor_y", 5}}}));
    ASSERT_EQ(module.groups().size(), 1u);
    const ParticleGroup& group = *module.group(module.groups()[0]);
    const ParticleGroupDef& def = group.def();
    EXPECT_EQ(def.integrator, ParticleIntegrator::runge_kutta_4);
    EXPECT_EQ(def.emitter.shape, EmitterShape::box);
    EXPECT_EQ(def.emitter.direction, (Vec3{1, 0, 0})) << "not the default (0, 1, 0) plus x";
    EXPECT_EQ(def.flow.walls.size(), 1u);
    EXPECT_EQ(def.attractors[0].falloff, -1);
    ASSERT_EQ(def.planes.size(), 2u);
    EXPECT_EQ(def.planes[1].normal, (Vec3{1, 0, 0}));
    EXPECT_EQ(def.planes[0].normal, (Vec3{0, 1, 0}));
    ASSERT_EQ(group.size(), 2u);
    EXPECT_EQ(group.positions()[0].y, 3);
    ASSERT_EQ(group.springs().size(), 2u);
    EXPECT_EQ(group.springs()[0].b, 0u);
    EXPECT_EQ(group.springs()[1].b, spring_anchor);
}

TEST(ParticlesScene, errors_name_the_setting) {
    World world = test::make_world();
    Particles module;
    const auto error = [&](const char* name, double value) {
        return module.configure(world, {.numbers = {{name, value}}}).error().message;
    };
    EXPECT_EQ(error("radius", -1), "radius is -1; it must be from 0 to 100");
    EXPECT_EQ(error("emitter_rate", 1e9),
              "emitter_rate is 1000000000; it must be from 0 to 1000000");
    EXPECT_EQ(error("emiter_rate", 1).substr(0, 27), "unknown setting emiter_rate");
    EXPECT_EQ(error("collide_particles", 1),
              "radius is 0; particles that hit each other need a radius");
    EXPECT_EQ(error("springs1_from", 3).substr(0, 10), "springs[0]");
    EXPECT_TRUE(module.groups().empty()) << "a rejected group leaves nothing";
}

TEST(ParticlesScene, publishes_points_and_groups) {
    World world = test::make_world({.gravity = {}});
    add_group(world, {.count_max = 6000, .radius = 0.25, .color = 0x123456},
              std::vector<ParticleStart>(3, {.position = {1, -2, 0.5}}));
    add_group(world, {.count_max = 6000}, std::vector<ParticleStart>(6000));
    ChannelWriter channels([](BodyId) { return 1u; });
    const Particles& module = particles_of(world);
    EXPECT_EQ(module.channels().size(), 3u);
    module.publish(world, channels);
    ASSERT_EQ(channels.channels().size(), 2u);
    const auto& points = channels.channels()[0].values;
    ASSERT_EQ(points.size(), 1 + 3 * Particles::published_max);
    EXPECT_EQ(points[0], 1000) << "units per metre";
    EXPECT_EQ(points[2], -2000);
    const auto& groups = channels.channels()[1].values;
    ASSERT_EQ(groups.size(), 8u);
    EXPECT_EQ(groups[0], 1);
    EXPECT_EQ(groups[1], 3);
    EXPECT_EQ(std::bit_cast<float>(groups[2]), 0.25f);
    EXPECT_EQ(groups[3], 0x123456);
    EXPECT_EQ(groups[5], 4997);
}

}  // namespace
}  // namespace jostle::modules
