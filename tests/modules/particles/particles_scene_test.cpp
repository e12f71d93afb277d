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

TEST(ParticlesScene, publishes_each_group_as_a_point_object) {
    World world = test::make_world({.gravity = {}});
    add_group(world, {.count_max = 6000, .radius = 0.04, .color = 0x123456},
              std::vector<ParticleStart>(3, {.position = {1, -2, 0.5}}));
    add_group(world, {.count_max = 6000}, std::vector<ParticleStart>(6000));
    std::vector<std::size_t> counts;
    ChannelWriter channels([](BodyId) { return 1u; }, {},
                           [&](std::uint32_t kind, std::uint32_t entity, const PointObject& o) {
                               counts.push_back(o.positions.size());
                               EXPECT_EQ(kind, 0u);
                               EXPECT_EQ(entity, 0u);
                               EXPECT_EQ(o.key, counts.size());
                               EXPECT_EQ(o.ids.size(), o.positions.size());
                               EXPECT_EQ(o.form, PointForm::loose);
                               if (counts.size() > 1) return;
                               EXPECT_EQ(o.positions[2].y, -2);
                               EXPECT_EQ(o.radius, 0.04);
                               EXPECT_EQ(o.step, 0.01);
                               EXPECT_EQ(o.color, 0x123456u);
                           });
    const Particles& module = particles_of(world);
    EXPECT_EQ(module.channels().size(), 2u);
    module.publish(world, channels);
    EXPECT_EQ(counts, (std::vector<std::size_t>{3, 6000}));
    EXPECT_TRUE(channels.channels().empty());
}

}  // namespace
}  // namespace jostle::modules
