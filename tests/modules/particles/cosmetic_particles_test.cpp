// SPDX-License-Identifier: MIT
//
// Cosmetic particles: clients compute the same particles from a definition, whenever they connect.
#include "jostle/modules/cosmetic_particles.h"

#include <gtest/gtest.h>

#include "tests/modules/particles/with_particles.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

ParticleGroupDef smoke() {
    ParticleGroupDef def{.count_max = 2000, .gravity_scale = -0.05, .linear_drag = 2};
    def.cosmetic = true;
    def.color = 0x808080;
    def.emitter = {.shape = EmitterShape::disc,
                   .rate = 200,
                   .burst = 20,
                   .burst_period = 0.7,
                   .speed = 1,
                   .cone = 0.3,
                   .lifetime = 3,
                   .lifetime_spread = 0.5};
    def.flow = {.wind = {0.5, 0, 0}, .speed = 0.8, .scale = 1.5, .walls = {{}}};
    def.planes = {{}};
    return def;
}

std::vector<std::int32_t> published(const World& world, std::size_t kind) {
    ChannelWriter channels([](BodyId) { return 1u; });
    dynamic_cast<const Particles*>(world.module("particles"))->publish(world, channels);
    for (const ChannelWriter::Channel& channel : channels.channels())
        if (channel.kind == kind) return channel.values;
    return {};
}

TEST(CosmeticParticles, server_publishes_the_definition_and_simulates_nothing) {
    World world = test::make_world();
    ParticleGroup& group = add_group(world, smoke());
    test::run(world, 0.5);
    EXPECT_EQ(group.size(), 0u);
    EXPECT_TRUE(published(world, 0).empty()) << "no points";
    const std::vector<std::int32_t> first = published(world, 1);
    test::run(world, 0.5);
    EXPECT_EQ(published(world, 1), first) << "unchanged values cost no bytes";
    CosmeticParticles client;
    test::must(client.decode(first));
    ASSERT_EQ(client.groups().size(), 1u);
    EXPECT_EQ(client.groups()[0].def(), smoke());
}

TEST(CosmeticParticles, late_clients_see_the_same_particles) {
    const ParticleGroupDef def = smoke();
    const ParticleGroupDef* const defs[] = {&def};
    const std::vector<std::int32_t> values = encode_cosmetic({0, -9.81, 0}, defs);
    CosmeticParticles early, late, seeking;
    for (CosmeticParticles* client : {&early, &late, &seeking}) test::must(client->decode(values));
    for (int k = 0; k <= 900; k++) early.advance_to(k / 90.0);
    late.advance_to(10);
    seeking.advance_to(40);
    seeking.advance_to(10);  // back
    const ParticleGroup& a = early.groups()[0];
    ASSERT_GT(a.size(), 500u);
    for (const CosmeticParticles* client : {&late, &seeking}) {
        const ParticleGroup& b = client->groups()[0];
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); k++) {
            ASSERT_EQ(a.ids()[k], b.ids()[k]);
            ASSERT_EQ(a.positions()[k], b.positions()[k]);
        }
    }
}

// Any changed value is rejected with a reason or gives a valid definition.
TEST(CosmeticParticles, rejects_corrupted_values) {
    const ParticleGroupDef def = smoke();
    const ParticleGroupDef* const defs[] = {&def};
    const std::vector<std::int32_t> good = encode_cosmetic({0, -9.81, 0}, defs);
    test::Random random(3);
    int refused = 0;
    for (int k = 0; k < 5000; k++) {
        std::vector<std::int32_t> values = good;
        for (std::uint64_t n = 0; n <= random.below(2); n++)
            values[random.below(values.size())] = static_cast<std::int32_t>(random.bits());
        if (random.below(8) == 0) values.resize(random.below(values.size()));
        CosmeticParticles client;
        const Status status = client.decode(values);
        if (!status.ok()) {
            refused++;
            EXPECT_FALSE(status.error().message.empty());
            continue;
        }
        for (const ParticleGroup& group : client.groups()) EXPECT_TRUE(check(group.def()).ok());
        if (k % 10 == 0) client.advance_to(0.1);
    }
    EXPECT_GT(refused, 1000);
    CosmeticParticles client;
    EXPECT_EQ(client.decode(std::vector<std::int32_t>{9, 0}).error().message,
              "cosmetic particles: version is 9; must be 1");
}

}  // namespace
}  // namespace jostle::modules
