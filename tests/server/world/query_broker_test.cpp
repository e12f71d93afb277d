// SPDX-License-Identifier: MIT
//
// Askers on many threads, one world that leaves copies: who asks gets a fresh one, and nobody makes
// the world wait or work for nothing.
#include "server/world/query_broker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "jostle/scenes/catalog.h"
#include "server/world/world_host.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

QueryFramePtr copy_with(CopyLayers layers, std::uint32_t tick) {
    QueryFrame frame;
    frame.tick = tick;
    frame.layers = layers;
    return std::make_shared<const QueryFrame>(frame);
}

TEST(QueryBroker, copies_only_while_requested) {
    QueryBroker desk;
    const auto now = Clock::now();
    EXPECT_EQ(desk.begin_tick(1, now), 0u);
    std::thread asker([&] { EXPECT_NE(desk.acquire(copy_shapes | copy_bounds), nullptr); });
    while (desk.begin_tick(2, Clock::now()) == 0) std::this_thread::sleep_for(1ms);
    const auto asked = Clock::now();
    EXPECT_EQ(desk.begin_tick(3, asked), copy_shapes | copy_bounds) << "these parts and no others";
    desk.put(copy_with(copy_shapes | copy_bounds, 3));
    asker.join();
    EXPECT_EQ(desk.begin_tick(4, asked + 900ms), copy_shapes | copy_bounds);
    EXPECT_EQ(desk.begin_tick(5, asked + 1100ms), 0u);
}

TEST(QueryBroker, accepts_copies_up_to_three_ticks_old) {
    QueryBroker desk;
    desk.put(copy_with(copy_shapes, 10));
    ASSERT_NE(desk.acquire(copy_shapes), nullptr);
    desk.begin_tick(13, Clock::now());
    ASSERT_NE(desk.acquire(copy_shapes), nullptr);
    EXPECT_EQ(desk.acquire(copy_shapes)->tick, 10u);
    desk.begin_tick(14, Clock::now());
    const auto begin = Clock::now();
    EXPECT_EQ(desk.acquire(copy_shapes), nullptr);
    EXPECT_NEAR(to_ms(Clock::now() - begin), 250, 100) << "the longest that anyone waits";
}

TEST(QueryBroker, expensive_copies_are_made_in_fewer_ticks) {
    QueryBroker desk(1e-3);
    const auto now = Clock::now();
    desk.request(copy_shapes, now);
    int copies = 0;
    std::uint32_t tick = 1;
    for (; tick <= 100; tick++) {
        if (desk.begin_tick(tick, now) == 0) continue;
        desk.put(copy_with(copy_shapes, tick));
        desk.charge(5e-3);
        copies++;
    }
    EXPECT_NEAR(copies, 20, 1);
    EXPECT_NE(desk.acquire(copy_shapes), nullptr) << "the last copy is usable up to the next one";
    QueryBroker cheap(1e-3);
    cheap.request(copy_shapes, now);
    for (tick = 1; tick <= 100; tick++) {
        EXPECT_EQ(cheap.begin_tick(tick, now), copy_shapes);
        cheap.charge(0.9e-3);
    }
}

TEST(QueryBroker, rejects_copies_without_the_requested_layer) {
    QueryBroker desk;
    desk.put(copy_with(copy_contacts, 10));
    EXPECT_EQ(desk.acquire(copy_shapes), nullptr);
    EXPECT_NE(desk.acquire(copy_contacts), nullptr);
}

TEST(QueryBroker, closing_unblocks_waiters) {
    QueryBroker desk;
    std::atomic<bool> answered{false};
    const auto begin = Clock::now();
    std::thread asker([&] {
        EXPECT_EQ(desk.acquire(copy_shapes), nullptr);
        answered = true;
    });
    std::this_thread::sleep_for(20ms);
    EXPECT_FALSE(answered);
    desk.close();
    asker.join();
    EXPECT_LT(Clock::now() - begin, 200ms);
}

TEST(WorldHostQueries, supports_four_concurrent_readers) {
    const auto host = *WorldHost::start("w1", "stack", *scenes::find_scene("stack"), {});
    std::atomic<int> hits{0}, fresh{0};
    std::vector<std::thread> askers;
    for (int t = 0; t < 4; t++) {
        askers.emplace_back([&] {
            for (int i = 0; i < 50; i++) {
                const QueryFramePtr frame = host->query_frame(copy_shapes);
                ASSERT_NE(frame, nullptr);
                // The world may be in the next tick already.
                fresh += frame->tick + 4 >= host->frame()->tick;
                const auto hit = frame->queries->cast_ray({{0, 100, 0}, {0, -200, 0}});
                ASSERT_TRUE(hit.ok() && *hit);
                const ShapeOwner place = frame->owner_of((*hit)->shape);
                hits += frame->body_of(place.entity) == (*hit)->body;
            }
        });
    }
    for (std::thread& asker : askers) asker.join();
    EXPECT_EQ(hits, 200) << "each hit has its entity";
    EXPECT_GT(fresh, 190) << "a busy machine may stop a thread between the two looks";
    host->stop();
    EXPECT_EQ(host->query_frame(copy_shapes), nullptr);
}

}  // namespace
}  // namespace jostle::server
