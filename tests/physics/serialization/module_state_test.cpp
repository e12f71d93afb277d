// SPDX-License-Identifier: MIT
//
// A module's state goes where the world's goes: saved, loaded, hashed, compared, restored.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jostle/physics/module.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::HasSubstr;

enum class Mood { calm, angry };

// Pushes a body every step, a little more each time.
struct Pusher : Module {
    BodyId body;
    double push = 1;
    Mood mood = Mood::calm;
    std::vector<Vec3> trail;
    std::string name = "first";
    bool was_restored = false;

    std::string_view tag() const override { return "pusher"; }
    void visit(StateVisitor& v) override {
        v.field("body", body);
        v.field("push", push);
        v.field("mood", mood, Mood::angry);
        v.all("trail", trail, [&](Vec3& p) { v.field("p", p); });
        v.field("name", name);
        if (v.loading() && trail.size() > 5000) v.fail("trail", "is longer than 5000");
    }
    void restored(const World& world) override { was_restored = world.contains(body); }
    void before_step(World& world, double) override {
        must(world.apply_impulse(body, {push, 0, 0}, {}));
        push *= 1.01;
        trail.push_back(position_of(world, body));
        mood = push > 1.2 ? Mood::angry : Mood::calm;
    }
};

World pushed_world() {
    World world;
    auto pusher = std::make_unique<Pusher>();
    pusher->body = add(world, {.geometry = Sphere{}});
    must(world.add_module(std::move(pusher)));
    return world;
}
Pusher& pusher_of(World& world) {
    return dynamic_cast<Pusher&>(*world.module("pusher"));
}

const bool registered = register_module("pusher", [] { return std::make_unique<Pusher>(); }).ok();

TEST(ModuleState, loaded_world_continues_bit_identically) {
    ASSERT_TRUE(registered);
    World world = pushed_world();
    run(world, 0.5);
    World loaded = must(load(save(world)));
    EXPECT_EQ(first_difference(world, loaded), std::nullopt);
    EXPECT_TRUE(pusher_of(loaded).was_restored);
    run(world, 0.5);
    run(loaded, 0.5);
    EXPECT_EQ(state_hash(world), state_hash(loaded));
    EXPECT_EQ(pusher_of(loaded).trail.size(), 60u);
    EXPECT_EQ(pusher_of(loaded).mood, Mood::angry);
}

TEST(ModuleState, is_part_of_the_hash_and_of_first_difference) {
    World a = pushed_world(), b = pushed_world();
    ASSERT_EQ(state_hash(a), state_hash(b));
    pusher_of(b).push = 2;
    EXPECT_NE(state_hash(a), state_hash(b));
    EXPECT_EQ(first_difference(a, b), "modules.pusher.state.push: 1 against 2");
    const std::uint64_t with = state_hash(a);
    must(a.remove_module("pusher"));
    EXPECT_NE(state_hash(a), with);
}

TEST(ModuleState, is_restored_by_a_restore_point) {
    World world = pushed_world();
    run(world, 0.2);
    RestorePoint point;
    point.capture(world);
    const std::uint64_t then = state_hash(world);
    run(world, 0.2);
    must(point.restore(world));
    EXPECT_EQ(state_hash(world), then);
    // Into a world without it, and with it removed meanwhile.
    World other;
    must(point.restore(other));
    EXPECT_EQ(state_hash(other), then);
    must(world.remove_module("pusher"));
    must(point.restore(world));
    run(world, 0.3);
    run(other, 0.3);
    EXPECT_EQ(state_hash(world), state_hash(other));
    // And out of one that has it.
    RestorePoint empty;
    empty.capture(World{});
    must(empty.restore(world));
    EXPECT_TRUE(world.modules().empty());
}

TEST(ModuleState, restore_point_saves_the_same_bytes_as_its_world) {
    World world = pushed_world();
    run(world, 0.2);
    RestorePoint point;
    EXPECT_EQ(point.save().error().code, ErrorCode::failed_precondition)
        << "nothing was captured yet";
    point.capture(world);
    const std::vector<std::byte> then = save(world);
    run(world, 0.2);
    const RestorePoint::Saved saved = must(point.save());
    EXPECT_TRUE(saved.bytes == then);
    EXPECT_EQ(saved.hash, state_hash(must(load(then))));
    EXPECT_NE(saved.hash, state_hash(world));
}

// Arrays of numbers, each visited with one call.
struct Cloud : Module {
    std::vector<Vec3> points{{1, 2, 3}, {4, 5, 6}};
    std::vector<double> ages{7, 8};
    std::vector<std::uint32_t> ids{9, 10};

    std::string_view tag() const override { return "cloud"; }
    void visit(StateVisitor& v) override {
        std::size_t count = v.count("count", points.size());
        if (v.loading()) {
            if (count > 5000) v.fail("count", "is more than 5000");
            if (v.failed()) count = 0;
            points.resize(count), ages.resize(count), ids.resize(count);
        }
        v.field("points", std::span(points));
        v.field("ages", std::span(ages));
        v.field("ids", std::span(ids));
    }
};

// The same numbers one by one.
struct SlowCloud : Cloud {
    void visit(StateVisitor& v) override {
        v.all("count", points, [&](Vec3& p) { v.field("p", p); });
        for (double& age : ages) v.field("age", age);
        for (std::uint32_t& id : ids) v.field("id", id);
    }
};

TEST(ModuleState, spans_are_saved_hashed_and_compared_number_by_number) {
    Cloud cloud;
    SlowCloud slow;
    const std::vector<std::byte> bytes = save_module(cloud);
    EXPECT_EQ(bytes.size(), 8 + 2 * (24 + 8 + 4u));
    EXPECT_EQ(bytes, save_module(slow)) << "the format does not depend on the call";
    World a, b;
    must(a.add_module(std::make_unique<Cloud>()));
    must(b.add_module(std::make_unique<Cloud>()));
    EXPECT_EQ(state_hash(a), state_hash(b));
    auto& changed = dynamic_cast<Cloud&>(*b.module("cloud"));
    changed.points[1].y = 5.5;
    EXPECT_NE(state_hash(a), state_hash(b));
    EXPECT_EQ(first_difference(a, b), "modules.cloud.state.points[1].y: 5 against 5.5");
    changed.points[1].y = 5;
    changed.ids[0] = 11;
    EXPECT_EQ(first_difference(a, b), "modules.cloud.state.ids[0]: 9 against 11");
}

TEST(ModuleState, loaded_spans_are_validated) {
    Cloud cloud, read;
    cloud.points.push_back({0.5, 0, 0}), cloud.ages.push_back(1), cloud.ids.push_back(3);
    const std::vector<std::byte> good = save_module(cloud);
    must(load_module(read, good));
    EXPECT_EQ(read.points, cloud.points);
    EXPECT_EQ(read.ages, cloud.ages);
    EXPECT_EQ(read.ids, cloud.ids);
    for (std::size_t cut = 0; cut < good.size(); cut++)
        EXPECT_FALSE(load_module(read, std::span(good).first(cut)).ok()) << cut;
    std::vector<std::byte> infinite = good;
    for (std::size_t k = 0; k < 8; k++) infinite[8 + 24 + 8 + k] = std::byte{0xff};
    EXPECT_THAT(load_module(read, infinite).error().message,
                HasSubstr("cloud.state.points[1].y is not finite"));
    std::vector<std::byte> larger = good;
    larger[0] = std::byte{200};
    EXPECT_THAT(load_module(read, larger).error().message, HasSubstr("count"));
}

struct Unknown : Module {
    std::string_view tag() const override { return "unheard_of"; }
    void visit(StateVisitor&) override {}
};

TEST(ModuleState, unknown_module_error_names_the_tag) {
    World world;
    must(world.add_module(std::make_unique<Unknown>()));
    const auto loaded = load(save(world));
    ASSERT_FALSE(loaded.ok());
    EXPECT_THAT(loaded.error().message, HasSubstr("module \"unheard_of\" is not registered"));
    EXPECT_THAT(loaded.error().message, HasSubstr("pusher"));
    RestorePoint point;
    point.capture(world);
    World other;
    EXPECT_THAT(point.restore(other).error().message, HasSubstr("unheard_of"));
}

TEST(ModuleState, untrusted_module_bytes_are_validated) {
    Pusher pusher;
    const std::vector<std::byte> good = save_module(pusher);
    Pusher read;
    read.push = 7;
    must(load_module(read, good));
    EXPECT_EQ(read.push, 1);
    for (std::size_t cut = 0; cut < good.size(); cut++)
        EXPECT_FALSE(load_module(read, std::span(good).first(cut)).ok()) << cut;
    std::vector<std::byte> longer = good;
    longer.push_back({});
    EXPECT_THAT(load_module(read, longer).error().message,
                HasSubstr("state of module \"pusher\": 1 bytes remain"));
    std::vector<std::byte> mood = good;
    mood[16] = std::byte{2};
    EXPECT_THAT(load_module(read, mood).error().message,
                HasSubstr("pusher.state.mood is not one of its values"));
}

}  // namespace
}  // namespace jostle::test
