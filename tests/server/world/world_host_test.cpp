// SPDX-License-Identifier: MIT
//
// The one place where threads meet: many clients push while the world ticks and others read its
// frames.
#include "server/world/world_host.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <thread>

#include "jostle/scenes/catalog.h"
#include "server/world/command_mailbox.h"
#include "server/world/world_directory.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::wait_until;

TEST(WorldHost, ticks_at_the_configured_rate) {
    std::atomic<int> frames{0};
    WorldHostSettings settings;
    settings.on_frame = [&](bool) { frames++; };
    const auto host = *WorldHost::start("w1", "test", *scenes::find_scene("stack"), settings);
    const std::uint32_t first = host->frame()->tick;
    const auto begin = Clock::now();
    std::this_thread::sleep_for(1s);
    const FramePtr last = host->frame();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    // Ticks that were given up on a busy machine count as well: the schedule is what must hold.
    EXPECT_NEAR(last->tick - first + last->late_ticks, 60 * seconds, 3);
    host->stop();
    EXPECT_TRUE(host->lifecycle().stopped());
    EXPECT_GE(frames, static_cast<int>(last->tick - first));
    EXPECT_EQ(host->frame()->tick, host->frame()->tick) << "the last frame stays readable";
}

TEST(WorldHost, scheduled_inputs_wait_for_their_tick_and_report_margin) {
    WorldHostSettings settings;
    settings.own_ticks = false;
    const auto host = *WorldHost::start("w1", "test", *scenes::find_scene("stack"), settings);
    const auto queue = std::make_shared<ResultQueue>();
    const Clock::time_point start = Clock::time_point() + 5s;
    const auto period = std::chrono::duration_cast<Clock::duration>(1s / 60.0);
    const auto push = [&](std::uint32_t sequence, std::uint32_t tick, Clock::time_point received) {
        ASSERT_TRUE(host->mailbox().push({.client = 1,
                                          .sequence = sequence,
                                          .action = ReleaseCommand{},
                                          .reply = queue,
                                          .received = received,
                                          .tick = tick}));
    };
    push(1, 0, start - 4ms);         // the next tick, 2
    push(2, 4, start - 4ms);         // two later
    host->tick(start);               // 2
    push(3, 1, start + 1ms);         // one that is over
    host->tick(start + period);      // 3
    host->tick(start + 2 * period);  // 4
    const auto results = queue->take();
    ASSERT_EQ(results.size(), 3u);
    const std::uint32_t ticks[] = {2, 4, 4};
    const double margins_ms[] = {4, 4 + 2 * 1000 / 60.0, -1 - 1000 / 60.0};
    for (std::size_t k = 0; k < 3; k++) {
        EXPECT_EQ(results[k].sequence, k + 1);
        EXPECT_EQ(results[k].tick, ticks[k]) << "the third may not overtake the second";
        EXPECT_NEAR(static_cast<double>(*results[k].margin_us) / 1000, margins_ms[k], 0.01);
    }
}

TEST(WorldHost, a_pause_does_not_concern_names_attributes_and_messages) {
    WorldHostSettings settings;
    settings.own_ticks = false;
    settings.user_message_bytes_per_second = 100;
    const auto host = *WorldHost::start("w1", "test", *scenes::find_scene("stack"), settings);
    const auto queue = std::make_shared<ResultQueue>();
    std::uint32_t sequence = 0;
    Clock::time_point now = host->properties().epoch;
    const auto apply = [&](Action action) {
        host->mailbox().push(
            {.client = 3, .sequence = ++sequence, .action = std::move(action), .reply = queue});
        host->tick(now += 16ms);
        return queue->take().at(0).status;
    };
    host->mailbox().join(3, {.name = "cy"});
    host->pause("by a test");
    EXPECT_TRUE(apply(RenameCommand{"zoe"}).ok());
    EXPECT_EQ(host->frame()->players->find(3)->name, "zoe");
    EXPECT_EQ(host->frame()->players->find(3)->joined_tick, 2u);
    EXPECT_TRUE(apply(SetAttributesCommand{{AttributeTargetKind::player, 3}, {{"x", true}}}).ok());
    EXPECT_TRUE(apply(SendMessageCommand{"chat", "hello"}).ok());
    EXPECT_EQ(apply(ReleaseCommand{}).error().message, "the world is paused: by a test");
    EXPECT_EQ(host->frame()->messages->count, 1u);
    // The burst has space for 131072 bytes.
    for (int k = 0; k < 2; k++)
        EXPECT_TRUE(apply(SendMessageCommand{"chat", std::string(65'000, 'x')}).ok());
    const Status refused = apply(SendMessageCommand{"chat", std::string(65'000, 'x')});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::resource_exhausted);
    EXPECT_NE(refused.error().message.find("world.user_message_bytes_per_second"),
              std::string::npos);
    EXPECT_GT(refused.error().retry_after_ms, 600'000);
    host->mailbox().leave(3, false);
    host->tick(now += 16ms);
    EXPECT_TRUE(host->frame()->players->players.empty());
}

TEST(WorldHost, ticks_manually_without_a_thread) {
    int frames = 0;
    WorldHostSettings settings;
    settings.own_ticks = false;
    settings.on_frame = [&](bool) { frames++; };
    const auto host = *WorldHost::start("w1", "test", *scenes::find_scene("stack"), settings);
    EXPECT_EQ(host->frame()->tick, 1u);
    const auto queue = std::make_shared<ResultQueue>();
    ASSERT_TRUE(host->mailbox().push(
        {.client = 1, .sequence = 1, .action = ImpulseCommand{.entity = 9999}, .reply = queue}));
    const Clock::time_point due = Clock::time_point() + 5s;
    host->tick(due);
    host->tick(due + 1s);
    EXPECT_EQ(host->frame()->tick, 3u);
    EXPECT_EQ(host->frame()->due, due + 1s);
    EXPECT_EQ(frames, 2);
    EXPECT_EQ(queue->take().size(), 1u);
    const auto asked = Clock::now();
    const QueryFramePtr copy = host->query_frame(copy_shapes);
    ASSERT_NE(copy, nullptr);
    EXPECT_EQ(copy->tick, 3u);
    EXPECT_LT(Clock::now() - asked, QueryBroker::timeout) << "and nobody is waited for";
    host->stop();
    EXPECT_EQ(host->query_frame(copy_shapes), nullptr);
}

// A world at rest steps at its rate, but publishes a frame every quarter of a second.
TEST(WorldHost, a_world_without_clients_rests_until_a_command_arrives) {
    scenes::SceneDescription scene{.name = "floor", .hz = 100};
    scene.bodies.push_back({.body = {.type = physics::BodyType::static_body},
                            .shapes = {{.geometry = physics::Box{}}}});
    std::atomic<int> frames{0};
    WorldHostSettings settings;
    settings.on_frame = [&](bool) { frames++; };
    const auto host = *WorldHost::start("w1", "test", scene, settings);
    ASSERT_TRUE(wait_until([&] { return host->frame()->tick > 130; }));
    const int before = frames;
    const std::uint32_t first = host->frame()->tick;
    ASSERT_TRUE(wait_until([&] { return host->frame()->tick >= first + 100; }));
    EXPECT_LE(frames - before, 6);
    EXPECT_NEAR(host->frame()->time_scale, 1, 0.01);
    EXPECT_EQ(host->frame()->late_ticks, 0u);
    // The result of an input comes as fast as from a world that does not rest.
    const auto queue = std::make_shared<ResultQueue>();
    double longest_ms = 0;
    for (std::uint32_t k = 1; k <= 5; k++) {
        const auto pushed = Clock::now();
        ASSERT_TRUE(host->mailbox().push(
            {.client = 1, .sequence = k, .action = ReleaseCommand{}, .reply = queue}));
        ASSERT_TRUE(wait_until([&] { return !queue->take().empty(); }));
        longest_ms = std::max(longest_ms, to_ms(Clock::now() - pushed));
        std::this_thread::sleep_for(30ms);
    }
    EXPECT_LT(longest_ms, 100);
    EXPECT_NE(host->query_frame(copy_shapes), nullptr);
    // With a client it publishes every tick.
    host->listeners().streams++;
    host->wake();
    const int watched = frames;
    const std::uint32_t from = host->frame()->tick;
    ASSERT_TRUE(wait_until([&] { return host->frame()->tick >= from + 60; }));
    EXPECT_GE(frames - watched, 30);
    host->listeners().streams--;
}

TEST(WorldHost, applies_concurrent_commands_exactly_once) {
    constexpr int clients = 4, each = 50;
    WorldHostSettings settings;
    settings.command_queue_max = 16;  // so that pushes are refused at times
    const auto host = *WorldHost::start("w1", "test", *scenes::find_scene("stack"), settings);
    std::vector<std::shared_ptr<ResultQueue>> queues;
    for (int c = 0; c < clients; ++c) queues.push_back(std::make_shared<ResultQueue>());
    std::vector<std::thread> threads;
    for (int c = 0; c < clients; ++c) {
        threads.emplace_back([&, c] {
            for (std::uint32_t i = 1; i <= each; ++i) {
                SpawnCommand spawn;
                spawn.shape.geometry = physics::Sphere{0.1};
                spawn.pose.position = {c * 2.0, 5.0 + i, 0};
                const Command command{.client = static_cast<ClientId>(c + 1),
                                      .sequence = i,
                                      .action = spawn,
                                      .reply = queues[static_cast<std::size_t>(c)]};
                while (!host->mailbox().push(command)) std::this_thread::sleep_for(1ms);
            }
        });
    }
    // A reader that looks all the while: what it sees is whole.
    std::atomic<bool> done{false};
    std::thread reader([&] {
        while (!done) {
            const FramePtr frame = host->frame();
            ASSERT_EQ(frame->entities.size(), frame->entity_list->size());
        }
    });
    for (std::thread& thread : threads) thread.join();
    std::set<EntityId> spawned;
    int results = 0;
    EXPECT_TRUE(wait_until([&] {
        for (const auto& queue : queues) {
            for (const InputResult& result : queue->take()) {
                results++;
                EXPECT_TRUE(result.status.ok()) << result.status.error().message;
                EXPECT_TRUE(spawned.insert(result.entity).second);
            }
        }
        return results == clients * each;
    }));
    done = true;
    reader.join();
    const FramePtr frame = host->frame();
    EXPECT_EQ(
        std::ranges::count_if(*frame->entity_list, [](const auto& e) { return e->owner != 0; }),
        clients * each);
}

TEST(WorldHost, failed_world_does_not_affect_others) {
    WorldHostSettings broken;
    broken.on_frame = [](bool) { throw std::bad_alloc(); };
    const auto scene = *scenes::find_scene("stack");
    const auto bad = *WorldHost::start("w1", "bad", scene, broken);
    const auto good = *WorldHost::start("w2", "good", scene, {});
    EXPECT_TRUE(wait_until([&] { return bad->lifecycle().stopped(); }));
    const std::uint32_t tick = good->frame()->tick;
    EXPECT_TRUE(wait_until([&] { return good->frame()->tick > tick + 5; }));
    EXPECT_FALSE(good->lifecycle().stopped());
    EXPECT_NE(bad->frame(), nullptr) << "its last frame stays readable";
    bad->stop();
}

TEST(WorldDirectory, rejects_names_that_look_like_ids) {
    WorldDirectory worlds({}, 4);
    const auto scene = *scenes::find_scene("stack");
    EXPECT_FALSE(worlds.create("w2", scene).ok()) << "would take the place of the second world";
    EXPECT_FALSE(worlds.create("w17", scene).ok());
    EXPECT_TRUE(worlds.create("w", scene).ok());
    EXPECT_TRUE(worlds.create("w2b", scene).ok());
}

TEST(WorldDirectory, supports_concurrent_create_find_and_remove) {
    constexpr int threads_count = 4, rounds = 8, worlds_max = 6;
    WorldDirectory worlds({}, worlds_max);
    const auto scene = *scenes::find_scene("stack");
    std::atomic<int> made{0}, removed{0}, won{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < threads_count; ++t) {
        threads.emplace_back([&, t] {
            for (int i = 0; i < rounds; ++i) {
                const std::string own = "own" + std::to_string(t) + "_" + std::to_string(i);
                if (worlds.create(own, scene).ok()) {
                    made++;
                    EXPECT_EQ(worlds.find(own)->name(), own);
                }
                if (worlds.create("wanted by all", scene).ok()) won++;
                EXPECT_LE(worlds.list().size(), static_cast<std::size_t>(worlds_max));
                if (worlds.remove(own)) removed++;
                if (worlds.remove("wanted by all")) won--;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(made, removed) << "each is removed by the one that made it";
    EXPECT_EQ(won, 0) << "of equal names one at a time";
    EXPECT_GT(made, 0);
    EXPECT_TRUE(worlds.list().empty());
}

TEST(WorldDirectory, creates_finds_and_removes_worlds) {
    WorldDirectory worlds({}, 2);
    EXPECT_EQ(worlds.find(""), nullptr);
    const auto scene = *scenes::find_scene("stack");
    const auto first = worlds.create("", scene);
    ASSERT_TRUE(first.ok());
    EXPECT_EQ((*first)->name(), "stack");
    EXPECT_FALSE(worlds.create("stack", scene).ok()) << "the name is taken";
    EXPECT_FALSE(worlds.create(std::string(65, 'x'), scene).ok());
    ASSERT_TRUE(worlds.create("other", scene).ok());
    EXPECT_FALSE(worlds.create("third", scene).ok()) << "two are allowed";
    EXPECT_EQ(worlds.find("")->id(), "w1");
    EXPECT_EQ(worlds.find("w2")->name(), "other");
    EXPECT_EQ(worlds.remove("other")->id(), "w2");
    EXPECT_EQ(worlds.remove("other"), nullptr);
    EXPECT_EQ(worlds.remove(""), nullptr) << "never by accident";
    EXPECT_EQ((*worlds.create("again", scene))->id(), "w3") << "ids are not used again";
}

TEST(WorldDirectory, enforces_the_total_budget) {
    WorldDirectory worlds({.totals = {.bodies_max = 25}}, 10);
    const auto stack = *scenes::find_scene("stack");
    ASSERT_EQ(stack.bodies.size(), 11u);
    ASSERT_TRUE(worlds.create("one", stack).ok() && worlds.create("two", stack).ok());
    EXPECT_EQ(
        worlds.create("three", stack).error().message,
        "all worlds together would have 33 bodies; world.bodies_total_max allows 25; delete a "
        "world first");
    worlds.remove("one");
    EXPECT_TRUE(worlds.create("three", stack).ok());
    const double work = worlds.find("two")->properties().work_per_second;
    WorldDirectory few({.totals = {.work_per_second_max = 1.5 * work}}, 10);
    ASSERT_TRUE(few.create("one", stack).ok());
    EXPECT_NE(few.create("two", stack).error().message.find("units of work per second"),
              std::string::npos);
    EXPECT_FALSE(few.find("two"));
}

}  // namespace
}  // namespace jostle::server
