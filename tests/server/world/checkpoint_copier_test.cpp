// SPDX-License-Identifier: MIT
#include "server/world/checkpoint_copier.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

TEST(CheckpointCopier, writer_thread_copies_while_the_world_waits) {
    std::atomic<bool> begun = false;
    std::atomic<int> world = 7;
    CheckpointCopier taker([&] {
        begun = true;
        std::this_thread::sleep_for(20ms);
        return CheckpointCopy{
            .tick = static_cast<std::uint32_t>(world), .bodies = {}, .host_state = {}};
    });
    std::uint32_t taken = 0;
    std::jthread other([&] { taken = taker.take()->tick; });
    while (!begun) std::this_thread::yield();
    taker.finish();
    world = 8;  // the next tick
    other.join();
    EXPECT_EQ(taken, 7u);
}

TEST(CheckpointCopier, world_thread_copies_before_continuing) {
    int world = 7, copies = 0;
    CheckpointCopier taker([&] {
        copies++;
        return CheckpointCopy{
            .tick = static_cast<std::uint32_t>(world), .bodies = {}, .host_state = {}};
    });
    taker.finish();
    world = 8;
    taker.finish();
    EXPECT_EQ(taker.take()->tick, 7u);
    EXPECT_FALSE(taker.take()) << "it is given away once";
    EXPECT_EQ(copies, 1);
}

TEST(CheckpointCopier, returns_nothing_when_out_of_memory) {
    CheckpointCopier taker([]() -> CheckpointCopy { throw std::bad_alloc(); });
    taker.finish();
    EXPECT_FALSE(taker.take());
}

}  // namespace
}  // namespace jostle::server
