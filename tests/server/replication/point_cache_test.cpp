// SPDX-License-Identifier: MIT
#include "server/replication/point_cache.h"

#include <gtest/gtest.h>

#include "jostle/snapshot/point_history.h"

namespace jostle::server {
namespace {

class PointCacheTest : public testing::Test {
protected:
    // Loose points of consecutive ids at (10 id + tick, 0, 0).
    FramePtr frame(std::uint32_t tick, std::uint32_t first_id, std::uint32_t points) {
        auto state = std::make_shared<PointObjectState>();
        state->object = object;
        state->number = ++number;
        state->tick = tick;
        for (std::uint32_t k = 0; k < points; k++) {
            state->ids.push_back(first_id + k);
            for (const std::uint32_t x : {10 * (first_id + k) + tick, 0u, 0u})
                state->values.push_back(static_cast<std::int32_t>(x));
        }
        auto made = std::make_shared<Frame>();
        made->tick = tick;
        made->points = std::make_shared<const PointObjects>(1, std::move(state));
        return made;
    }
    PointCache::Encoding encode(const FramePtr& frame, std::size_t levels,
                                const SentStates& known) {
        const auto objects = cache.objects(frame);
        return cache.encoding(*objects->front(), levels, known);
    }
    void receive(const PointCache::Encoding& encoding) {
        const Status added =
            client.add(last.number, last.tick, last.back, last.packed.bytes, last.packed.crc);
        ASSERT_TRUE(added.ok()) << added.error().message;
        static_cast<void>(encoding);
    }

    const std::shared_ptr<const PointObjectDescription> object = [] {
        auto made = std::make_shared<PointObjectDescription>();
        made->id = 9;
        made->step_um = 1000;
        return made;
    }();
    std::uint32_t number = 0;
    int encoded = 0;
    EncodedPoints last;
    PointCache cache{[this](const EncodedPoints& points) {
                         encoded++;
                         last = points;
                         return std::string("state");
                     },
                     [](const PointObjectDescription&) { return std::string("object"); }};
    snapshot::PointHistory client = snapshot::PointHistory::create({}).value();
};

TEST_F(PointCacheTest, clients_with_the_same_baselines_share_an_encoding) {
    const FramePtr first = frame(1, 1, 20);
    EXPECT_EQ(encode(first, 4, {}).field, encode(first, 4, {}).field);
    EXPECT_EQ(encoded, 1);
    const FramePtr second = frame(2, 3, 20);
    const auto changed = encode(second, 4, {{1, 4}});
    EXPECT_EQ(changed.field, encode(second, 4, {{1, 4}}).field);
    EXPECT_EQ(changed.baselines, 1u);
    EXPECT_EQ(encode(second, 4, {}).baselines, 0u);
    EXPECT_EQ(encoded, 3);
}

TEST_F(PointCacheTest, loose_points_survive_thinning_and_refinement) {
    const FramePtr first = frame(1, 1, 64);
    receive(encode(first, 1, {}));
    EXPECT_EQ(client.states().back().points.state.values.size(), 3u * 8);
    receive(encode(first, 4, {{1, 1}}));
    EXPECT_EQ(client.states().back().points.state.values, cache.objects(first)->front()->values);
    SentStates sent{{1, 4}};
    for (std::uint32_t tick = 2; tick < 40; tick++) {
        // Two points end and three appear per tick; the levels change.
        const std::size_t levels = 1 + tick % 4;
        const FramePtr now = frame(tick, 2 * tick, 60 + tick);
        receive(encode(now, levels, sent));
        const auto& decoded = client.states().back().points.state.values;
        const auto& ids = cache.objects(now)->front()->ids;
        const std::uint32_t one_in = 1u << (4 - levels);
        EXPECT_EQ(decoded.size() / 3, static_cast<std::size_t>(std::ranges::count_if(
                                          ids, [&](auto id) { return id % one_in == 0; })));
        sent.insert(sent.begin(), {number, levels});
        if (sent.size() > 3) sent.pop_back();
    }
}

TEST_F(PointCacheTest, baselines_that_are_no_longer_stored_are_not_used) {
    const FramePtr first = frame(1, 1, 20);
    encode(first, 4, {});
    FramePtr now;
    for (std::uint32_t tick = 2; tick < 2 + PointCache::states_retained; tick++)
        cache.objects(now = frame(tick, 1, 20));
    EXPECT_EQ(encode(now, 4, {{1, 4}}).baselines, 0u);
    EXPECT_EQ(last.back, 0u);
    EXPECT_EQ(encode(now, 4, {{20, 4}, {1, 4}}).baselines, 1u);
    EXPECT_EQ(last.back, number - 20 + 1);
}

TEST_F(PointCacheTest, large_objects_have_fewer_baselines) {
    FramePtr now;
    for (std::uint32_t tick = 1; tick <= 10; tick++) cache.objects(now = frame(tick, 1, 60000));
    EXPECT_EQ(encode(now, 1, {{7, 1}}).baselines, 1u);
    EXPECT_EQ(encode(now, 1, {{6, 1}}).baselines, 0u);
}

}  // namespace
}  // namespace jostle::server
