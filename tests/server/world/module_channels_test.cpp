// SPDX-License-Identifier: MIT
#include "server/world/module_channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/counter.h"

namespace jostle::server {
namespace {

using namespace physics;
using test::Counter;
using testing::HasSubstr;

class ModuleChannelsTest : public testing::Test {
protected:
    Counter& add(const std::string& tag, std::vector<ChannelKind> kinds = {{}}) {
        auto module = std::make_unique<Counter>(tag);
        Counter& added = *module;
        added.kinds = std::move(kinds);
        EXPECT_TRUE(world.add_module(std::move(module)).ok());
        return added;
    }
    Channels step() {
        if (tick == 0) channels = ModuleChannels::of(world).value();
        EXPECT_TRUE(world.step(1.0 / 60).ok());
        channels.publish(world, ++tick,
                         [](BodyId body) { return body.index == 7 ? 1234567u : 0u; });
        return *channels.channels();
    }

    World world = World::create().value();
    ModuleChannels channels;
    std::uint32_t tick = 0;
};

TEST_F(ModuleChannelsTest, publishes_nothing_without_modules) {
    EXPECT_TRUE(step().empty());
}

TEST_F(ModuleChannelsTest, lists_module_kinds_by_full_name) {
    add("second", {{"near", ChannelForm::points, 4}, {}}).observed_body = {7, 1};
    add("first");
    const Channels now = step();
    ASSERT_EQ(channels.kinds().size(), 4u);
    EXPECT_EQ(channels.kinds()[3].name, motion_kind);
    EXPECT_EQ(channels.kinds()[0].name, "second.near");
    EXPECT_EQ(channels.kinds()[0].form, ChannelForm::points);
    EXPECT_EQ(channels.kinds()[1].name, "second");
    EXPECT_EQ(channels.kinds()[2].name, "first");
    ASSERT_EQ(now.size(), 3u);
    EXPECT_EQ(now[1].kind, 1u);
    EXPECT_EQ(now[1].entity, 1234567u);
    EXPECT_EQ(*now[1].values, std::vector<std::int32_t>{1});
    EXPECT_EQ(now[2].entity, 0u) << "it watches nobody";
}

TEST_F(ModuleChannelsTest, reuses_unchanged_values) {
    add("slow").every = 2;
    add("quick");
    const auto first = step(), second = step(), third = step();
    EXPECT_NE(first[0].values, second[0].values);
    EXPECT_EQ(second[0].values, third[0].values) << "the same, not an equal one";
    EXPECT_NE(second[1].values, third[1].values);
}

TEST_F(ModuleChannelsTest, divisor_limits_the_publish_rate) {
    add("counter", {{"rare", ChannelForm::params, 4}, {}});
    std::vector<std::int32_t> rare, each;
    for (int k = 0; k < 9; k++) {
        const Channels now = step();
        ASSERT_EQ(now.size(), 2u);
        rare.push_back(now[0].values->front());
        each.push_back(now[1].values->front());
    }
    EXPECT_EQ(rare, (std::vector<std::int32_t>{1, 1, 1, 1, 5, 5, 5, 5, 9}));
    EXPECT_EQ(each, (std::vector<std::int32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST_F(ModuleChannelsTest, silent_module_has_no_channel) {
    add("counter").until = 2;
    EXPECT_EQ(step().size(), 1u);
    EXPECT_TRUE(step().empty());
}

TEST_F(ModuleChannelsTest, skips_oversized_channels_and_reports_them_once) {
    Counter& large = add("large");
    add("small");
    large.padding = channel_values_max - 1;
    EXPECT_EQ(step().size(), 2u) << "16384 values fit";
    EXPECT_TRUE(channels.newly_oversized().empty());
    large.padding++;
    for (int k = 0; k < 3; k++) {
        const Channels now = step();
        ASSERT_EQ(now.size(), 1u);
        EXPECT_EQ(now[0].kind, 1u);
        ASSERT_EQ(channels.newly_oversized().size(), k == 0 ? 1u : 0u);
        if (k == 0) {
            EXPECT_EQ(channels.newly_oversized()[0].kind, "large");
            EXPECT_EQ(channels.newly_oversized()[0].reason, "16385 values; at most 16384 are sent");
        }
    }
    large.padding = 0;
    EXPECT_EQ(step().size(), 2u) << "only oversized ticks are skipped";
}

TEST_F(ModuleChannelsTest, rejects_duplicate_kind_names) {
    const auto refused = [](std::vector<ChannelKind> kinds) {
        World owned = World::create().value();
        auto module = std::make_unique<Counter>("m");
        module->kinds = std::move(kinds);
        EXPECT_TRUE(owned.add_module(std::move(module)).ok());
        const auto made = ModuleChannels::of(owned);
        return made.ok() ? "" : made.error().message;
    };
    EXPECT_THAT(refused({{"a"}, {"a"}}),
                HasSubstr("module \"m\": channel \"m.a\" is declared twice"));
    EXPECT_THAT(refused({{"A"}}), HasSubstr("channel \"A\" has an invalid name"));
    EXPECT_THAT(refused({{"a", ChannelForm::seed, 0}}),
                HasSubstr("has the divisor 0; must be 1 to 255"));
    std::vector<ChannelKind> many;
    for (int k = 0; k < 65; k++) many.push_back({"k" + std::to_string(k)});
    EXPECT_THAT(refused(many), HasSubstr("declare 65 kinds of channels; a hosted world may have"));
}

}  // namespace
}  // namespace jostle::server
