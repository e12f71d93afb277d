// SPDX-License-Identifier: MIT
#include "server/session/world_admission.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "tests/server/session/session_harness.h"

namespace jostle::server {
namespace {

class WorldAdmissionTest : public testing::Test {
protected:
    Peer peer() {
        return {.name = "test",
                .address = "127.0.0.1",
                .call = "jostle.v1.PlayService/Play",
                .who = server.authorizer->identify({.address = "127.0.0.1"})};
    }

    test::TestServer server;
    const std::shared_ptr<WorldHost> first = server.host(*scenes::find_scene("stack"));
    const std::shared_ptr<WorldHost> second =
        *server.worlds.create("second", *scenes::find_scene("dominoes"));
};

TEST_F(WorldAdmissionTest, anonymous_client_joins_the_named_world) {
    const Result<AdmittedClient> admitted =
        admit_to_world(server.context, peer(), {.world = "second"});
    ASSERT_TRUE(admitted.ok()) << admitted.error().message;
    EXPECT_EQ(admitted->world, second);
    EXPECT_EQ(admitted->who.subject, "anonymous");
    EXPECT_TRUE(admitted->ticket.empty());
}

TEST_F(WorldAdmissionTest, unknown_world_is_named_in_the_error) {
    const Result<AdmittedClient> admitted =
        admit_to_world(server.context, peer(), {.world = "nowhere"});
    ASSERT_FALSE(admitted.ok());
    EXPECT_EQ(admitted.error().code, ErrorCode::not_found);
    EXPECT_EQ(admitted.error().message, "hello.world: there is no world \"nowhere\"");
}

TEST_F(WorldAdmissionTest, ticket_selects_the_world_and_the_subject_once) {
    const std::string ticket =
        server.authorizer
            ->issue_ticket({.subject = "ann", .role = Role::player, .anonymous = false},
                           second->id(), "127.0.0.1")
            .value();
    const Hello hello{.ticket = ticket};
    const Result<AdmittedClient> admitted = admit_to_world(server.context, peer(), hello);
    ASSERT_TRUE(admitted.ok()) << admitted.error().message;
    EXPECT_EQ(admitted->world, second);
    EXPECT_EQ(admitted->who.subject, "ann");
    EXPECT_EQ(admitted->ticket, Tickets::digest(ticket));
    EXPECT_EQ(admit_to_world(server.context, peer(), hello).error().code,
              ErrorCode::unauthenticated);
}

TEST_F(WorldAdmissionTest, viewer_joins_as_a_spectator_only) {
    const auto with_ticket = [&](bool spectator) {
        Hello hello;
        hello.ticket =
            server.authorizer
                ->issue_ticket({.subject = "bob", .role = Role::viewer, .anonymous = false},
                               first->id(), "127.0.0.1")
                .value();
        hello.spectator = spectator;
        return admit_to_world(server.context, peer(), hello);
    };
    EXPECT_TRUE(with_ticket(true).ok());
    EXPECT_EQ(with_ticket(false).error().code, ErrorCode::permission_denied);
}

}  // namespace
}  // namespace jostle::server
