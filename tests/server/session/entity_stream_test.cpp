// SPDX-License-Identifier: MIT
#include "server/session/entity_stream.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "jostle/v1/play.pb.h"
#include "tests/server/session/session_harness.h"

namespace jostle::server {
namespace {

class EntityStreamTest : public testing::Test {
protected:
    v1::EntityUpdate next() {
        const std::optional<OutMessage> message = outbox.pop();
        v1::ServerMessage parsed;
        EXPECT_TRUE(message && parsed.ParseFromString(message->concatenated()));
        return parsed.entity_update();
    }

    test::TestServer server;
    const std::shared_ptr<WorldHost> host = server.host(*scenes::find_scene("stack"));
    BroadcastCache broadcast{host, 32};
    BaselineTracker baselines;
    Outbox outbox;
    EntityStream stream{broadcast, baselines, outbox};
};

TEST_F(EntityStreamTest, sends_the_difference_of_two_lists) {
    const std::shared_ptr<const EntityList> list = host->frame()->entity_list;
    ASSERT_GT(list->size(), 2u);
    stream.send_list(list);
    EXPECT_EQ(next().added_size(), static_cast<int>(list->size()));
    stream.send_list(std::make_shared<const EntityList>(list->begin(), list->end() - 1));
    const v1::EntityUpdate change = next();
    EXPECT_EQ(change.added_size(), 0);
    ASSERT_EQ(change.removed_size(), 1);
    EXPECT_EQ(change.removed(0), list->back()->id);
    EXPECT_TRUE(outbox.empty());
    EXPECT_EQ(outbox.replies(), 0u) << "entity updates are no replies";
}

TEST_F(EntityStreamTest, sends_no_message_without_removed_entities) {
    stream.send_removed({});
    EXPECT_TRUE(outbox.empty());
}

TEST_F(EntityStreamTest, records_lists_after_the_newest_snapshot) {
    SentLog log;
    stream.record_in(&log);
    const std::shared_ptr<const EntityList> list = host->frame()->entity_list;
    stream.send_list(list);
    baselines.on_sent(10);
    log.on_snapshot(10, {}, 0);
    EXPECT_EQ(log.known_at(10, *list).list, list);
}

}  // namespace
}  // namespace jostle::server
