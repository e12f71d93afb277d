// SPDX-License-Identifier: MIT
#include "server/session/sent_log.h"

#include <gtest/gtest.h>

#include <memory>

namespace jostle::server {
namespace {

std::shared_ptr<const EntityList> list_of(std::initializer_list<EntityId> ids) {
    auto list = std::make_shared<EntityList>();
    for (const EntityId id : ids) {
        auto entity = std::make_shared<EntityDescription>();
        entity->id = id;
        list->push_back(std::move(entity));
    }
    return list;
}

InputResult result(std::uint32_t sequence) {
    return {.sequence = sequence, .status = {}, .tick = 0, .entity = 0};
}

std::vector<std::uint32_t> sequences(const SentLog::Known& known) {
    std::vector<std::uint32_t> out;
    for (const InputResult& r : known.results) out.push_back(r.sequence);
    return out;
}

using Numbers = std::vector<std::uint32_t>;

TEST(SentLog, resends_data_after_the_last_received_snapshot) {
    SentLog log;
    log.on_list(list_of({1, 2}), 0);
    const std::vector<InputResult> none, first{result(1)}, second{result(2), result(3)};
    log.on_snapshot(10, none, 5);
    log.on_snapshot(11, first, 6);
    log.on_snapshot(12, second, 8);
    const SentLog::Known known = log.known_at(11, *list_of({1, 2}));
    EXPECT_EQ(sequences(known), (Numbers{2, 3}));
    EXPECT_EQ(known.events, 6u);
    ASSERT_TRUE(known.list);
    EXPECT_TRUE(known.removed.empty());
    EXPECT_EQ(sequences(log.known_at(10, *list_of({1, 2}))), (Numbers{1, 2, 3}));
    EXPECT_EQ(sequences(log.known_at(0, *list_of({1, 2}))), (Numbers{1, 2, 3}));
}

TEST(SentLog, lists_entities_removed_since_the_last_received_snapshot) {
    SentLog log;
    log.on_list(list_of({1, 2}), 0);
    log.on_snapshot(10, {}, 0);
    log.on_list(list_of({1, 2, 3, 4}), 10);  // before snapshot 11
    log.on_snapshot(11, {}, 0);
    const auto now = list_of({1, 4, 5});
    const SentLog::Known early = log.known_at(10, *now);
    EXPECT_EQ(early.list->size(), 2u);
    EXPECT_EQ(early.removed, (Numbers{2, 3}))
        << "it may have heard of 3; 2 comes with the list as well";
    const SentLog::Known late = log.known_at(11, *now);
    EXPECT_EQ(late.list->size(), 4u);
    EXPECT_TRUE(late.removed.empty()) << "what its list has is told by the next roster";
}

TEST(SentLog, resends_unacknowledged_shapes) {
    SentLog log;
    log.on_geometry(77, 0);
    log.on_list(list_of({1}), 0);
    log.on_snapshot(10, {}, 0);
    log.on_geometry(88, 10);
    log.on_snapshot(11, {}, 0);
    EXPECT_EQ(log.known_at(10, *list_of({1})).geometry, (std::vector<std::uint64_t>{88}));
    EXPECT_TRUE(log.known_at(11, *list_of({1})).geometry.empty());
}

TEST(SentLog, discards_acknowledged_data) {
    SentLog log;
    log.on_list(list_of({1}), 0);
    const std::vector<InputResult> first{result(1)}, second{result(2)};
    log.on_snapshot(10, first, 0);
    log.on_list(list_of({1, 2}), 10);
    log.on_snapshot(11, second, 0);
    log.on_snapshot(12, {}, 0);
    log.on_ack(99);  // was never sent
    EXPECT_EQ(sequences(log.known_at(10, *list_of({1}))), Numbers{2});
    log.on_ack(11);
    EXPECT_FALSE(log.known_at(10, *list_of({1})).list);
    const SentLog::Known known = log.known_at(11, *list_of({1, 2}));
    ASSERT_TRUE(known.list);
    EXPECT_EQ(known.list->size(), 2u);
    EXPECT_TRUE(known.results.empty());
    EXPECT_FALSE(log.known_at(13, *list_of({1})).list) << "nor ahead of what was sent";
}

TEST(SentLog, preserves_unacknowledged_data_across_two_disconnects) {
    SentLog log;
    log.on_list(list_of({1}), 0);
    log.on_snapshot(10, {}, 0);
    log.on_list(list_of({1, 2}), 10);
    log.on_snapshot(11, {}, 0);
    log.roll_back_to(10);  // the first break; 2 is gone, and that was told and lost again
    log.on_list(list_of({1, 3}), 10);
    EXPECT_EQ(log.known_at(10, *list_of({1, 3})).removed, Numbers{2});
    log.on_snapshot(20, {}, 0);
    EXPECT_EQ(log.known_at(20, *list_of({1, 3})).list->back()->id, 3u);
}

}  // namespace
}  // namespace jostle::server
