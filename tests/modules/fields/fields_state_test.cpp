// SPDX-License-Identifier: MIT
//
// Fields are state: bit-identical results for any number of threads and after saving, loading and
// restoring. Untrusted bytes and settings are checked.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "jostle/physics/compound.h"
#include "tests/modules/fields/with_fields.h"
#include "tests/modules/module_determinism.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

World lively(int threads) {
    static_cast<void>(register_user_field("test_pump", [](const UserFieldInput& at) {
        return Vec3{0, at.parameters[0] * at.mass * sin_cos(at.time).sin, 0};
    }));
    World world = test::make_world({.threads = threads});
    test::add_static(world, {.geometry = Box{{20, 1, 20}}, .position = {0, -5, 0}});
    const Geometry kinds[] = {Box{{0.4, 0.3, 0.5}}, Sphere{0.4}, Capsule{0.2, 0.4},
                              Cylinder{0.3, 0.4}, Cone{0.4, 0.5}};
    test::Random random(11);
    for (int k = 0; k < 60; k++)
        test::add(world, {.geometry = kinds[k % 5],
                          .position = {1.1 * (k % 8), 0.7 * (k / 8) - 2, 0.9 * (k % 3)},
                          .rotation = random.rotation(),
                          .density = 300 + 20.0 * k});
    const BodyId star = test::add(world, {.geometry = Sphere{0.3},
                                          .position = {4, 8, 0},
                                          .velocity = {0.5, 0, 0},
                                          .type = BodyType::kinematic});
    add_field(world, {.law = Waves{.components = {{.amplitude = 0.3, .length = 6},
                                                  {.amplitude = 0.1, .length = 3, .heading = 1}},
                                   .flow = {0.2, 0, 0}},
                      .volume = CapsuleVolume{{-9, 0, 0}, {15, 0, 0}, 12}});
    add_field(world, {.law = Turbulence{.wind = {4, 0, 0}},
                      .volume = BoxVolume{.pose = {{0, 6, 0}, {}}, .half_extents = {30, 6, 30}}});
    add_field(world, {.law = Central{.body = star, .strength = 40, .per_mass = true}});
    add_field(world, {.law = UserField{.law = "test_pump", .parameters = {0.7}, .per_mass = false},
                      .volume = SphereVolume{{4, 0, 0}, 3}});
    test::must(fields_of(world).add_charge(
        {.time = 0.4, .explosion = {.center = {3, -1, 1}, .radius = 6, .strength = 200}}));
    return world;
}

TEST(FieldsState, result_is_bit_identical_for_any_thread_count) {
    test::expect_same_for_threads(lively, 0.8);
}

TEST(FieldsState, result_is_bit_identical_for_any_instruction_set) {
    test::expect_same_for_instruction_sets(lively, 0.8);
}

TEST(FieldsState, continues_bit_identically_after_load_and_restore) {
    World world = lively(1);
    test::run(world, 0.3);
    World loaded = test::must(load(save(world)));
    EXPECT_EQ(first_difference(world, loaded), std::nullopt);
    RestorePoint point;
    point.capture(world);
    test::run(world, 0.7);
    test::run(loaded, 0.7);
    EXPECT_EQ(first_difference(world, loaded), std::nullopt);
    const std::uint64_t hash = state_hash(world);
    test::run(world, 0.5);
    test::must(point.restore(world));
    test::run(world, 0.7);
    EXPECT_EQ(state_hash(world), hash);
    World other = test::make_world();
    test::add(other, {.geometry = Sphere{3}, .position = {0, 9, 0}});
    add_field(other, {.law = Waves{}});
    test::run(other, 0.3);
    test::must(point.restore(other));
    test::run(other, 0.7);
    EXPECT_EQ(state_hash(other), hash);
}

TEST(FieldsState, every_field_change_changes_the_state) {
    World a = lively(1), b = lively(1);
    Fields& fields = fields_of(b);
    VolumeField water = test::must(fields.field(fields.fields().front()));
    std::get<Waves>(water.law).components[1].phase += 1e-9;
    test::must(fields.set(b, fields.fields().front(), water));
    EXPECT_NE(state_hash(a), state_hash(b));
    const auto difference = first_difference(a, b);
    ASSERT_TRUE(difference.has_value());
    EXPECT_NE(difference->find("state.fields[0].law.components[1].phase"), std::string::npos)
        << *difference;
}

// Any changed byte loads to values in range or is rejected.
TEST(FieldsState, rejects_corrupted_bytes) {
    World world = lively(1);
    const std::vector<std::byte> good = save_module(fields_of(world));
    Fields copy;
    ASSERT_TRUE(load_module(copy, good).ok());
    EXPECT_EQ(save_module(copy), good);
    test::Random random(6);
    int refused = 0, taken = 0;
    for (int k = 0; k < 20000; k++) {
        std::vector<std::byte> corrupted = good;
        const int changes = 1 + static_cast<int>(random.below(3));
        for (int n = 0; n < changes; n++)
            corrupted[random.below(corrupted.size())] = static_cast<std::byte>(random.below(256));
        if (random.below(10) == 0) corrupted.resize(random.below(corrupted.size()));
        Fields victim;
        const Status status = load_module(victim, corrupted);
        status.ok() ? taken++ : refused++;
        if (!status.ok()) continue;
        World other = test::make_world();
        test::add(other, {.position = {4, 0.2, 0}, .density = 500});
        // Accepted values are in range: they are saved unchanged, and a step succeeds.
        ASSERT_EQ(save_module(victim), corrupted);
        if (taken % 20 != 0) continue;
        auto module = std::make_unique<Fields>();
        test::must(load_module(*module, corrupted));
        test::must(other.add_module(std::move(module)));
        test::must(other.step(1.0 / 60));
        test::must(other.step(1.0 / 60));
    }
    RecordProperty("refused", refused);
    RecordProperty("taken", taken);
    EXPECT_GT(refused, 5000);
    EXPECT_GT(taken, 100);
}

TEST(FieldsState, errors_name_the_invalid_field) {
    World world = test::make_world();
    Fields& fields = fields_of(world);
    add_field(world, {.law = Turbulence{.scale = 7.25}});
    std::vector<std::byte> bytes = save_module(fields);
    const double given = 7.25, corrupted = -1;
    std::byte pattern[8];
    std::memcpy(pattern, &given, 8);
    const auto at = std::search(bytes.begin(), bytes.end(), pattern, pattern + 8);
    ASSERT_NE(at, bytes.end());
    std::memcpy(&*at, &corrupted, 8);
    const Status status = load_module(fields, bytes);
    ASSERT_FALSE(status.ok());
    EXPECT_NE(status.error().message.find("turbulence.scale is -1"), std::string::npos)
        << status.error().message;
}

TEST(FieldsState, rejects_unregistered_force_laws) {
    static_cast<void>(
        register_user_field("test_known", [](const UserFieldInput&) { return Vec3{}; }));
    World world = test::make_world();
    add_field(world, {.law = UserField{.law = "test_known"}});
    std::vector<std::byte> bytes = save_module(fields_of(world));
    const std::string name = "test_known";
    const auto at = std::search(bytes.begin(), bytes.end(), name.begin(), name.end(),
                                [](std::byte b, char c) { return static_cast<char>(b) == c; });
    ASSERT_NE(at, bytes.end());
    *at = static_cast<std::byte>('x');
    const Status status = load_module(fields_of(world), bytes);
    ASSERT_FALSE(status.ok());
    EXPECT_NE(status.error().message.find("\"xest_known\", which is not registered"),
              std::string::npos)
        << status.error().message;
}

TEST(FieldsState, is_read_from_the_settings_of_a_scene) {
    World world = test::make_world();
    const BodyId star = test::add(world, {});
    auto module = std::make_unique<Fields>();
    test::must(module->configure(world, {.numbers = {{"turbulence_speed", 3},
                                                     {"waves_level", -1},
                                                     {"wave1_amplitude", 0.4},
                                                     {"wave3_amplitude", 0.1},
                                                     {"waves_half_x", 50},
                                                     {"central_strength", 7},
                                                     {"blast_time", 2},
                                                     {"blast_strength", 50}},
                                         .bodies = {{"center", star}}}));
    ASSERT_EQ(module->fields().size(), 3u);
    const VolumeField water = test::must(module->field(module->fields()[1]));
    EXPECT_EQ(std::get<Waves>(water.law).components.size(), 2u);
    EXPECT_EQ(std::get<BoxVolume>(water.volume).half_extents, (Vec3{50, 1e7, 1e7}));
    const VolumeField pull = test::must(module->field(module->fields()[2]));
    EXPECT_EQ(std::get<Central>(pull.law).body, star);
    ASSERT_EQ(module->charges().size(), 1u);
    EXPECT_EQ(module->charges()[0].explosion.strength, 50);
    Fields other;
    EXPECT_EQ(
        other.configure(world, {.numbers = {{"waves_levle", 1}}}).error().message.substr(0, 30),
        "unknown setting waves_levle; m");
    EXPECT_EQ(other.configure(world, {.numbers = {{"wave2_length", 0}}}).error().message,
              "wave2_length is 0; it must be from 0.1 to 10000");
}

TEST(FieldsState, publishes_water_wind_and_blasts) {
    World world = test::make_world();
    Fields& fields = fields_of(world);
    const auto published = [&] {
        ChannelWriter channels([](BodyId) { return 1u; });
        fields.publish(world, channels);
        return channels.channels();
    };
    EXPECT_TRUE(published().empty());
    add_field(world, {.law = Waves{.level = 2, .components = {{}, {}}}});
    add_field(world, {.law = Turbulence{}});
    add_field(world, {.law = Central{}});
    test::must(fields.add_charge({.time = 0, .explosion = {.center = {1, 2, 3}}}));
    test::must(world.step(1.0 / 60));
    const auto channels = published();
    ASSERT_EQ(channels.size(), 2u) << "waves, which clients advance themselves, and the rest";
    const auto& waters = channels[0].values;
    EXPECT_EQ(channels[0].kind, 0u);
    EXPECT_EQ(waters.size(), 3u + 2 * 5u) << "two waves";
    EXPECT_EQ(std::bit_cast<float>(waters[0]), 2) << "the level";
    const auto& rest = channels[1].values;
    ASSERT_EQ(rest.size(), 1u + (1 + 4) + (1 + 3) + 4u) << "a wind, a centre and a blast";
    EXPECT_EQ(rest[0], 2);
    EXPECT_EQ(std::bit_cast<float>(rest[12]), 3) << "z of the blast";
}

}  // namespace
}  // namespace jostle::modules
