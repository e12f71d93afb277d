// SPDX-License-Identifier: MIT
//
// Operator requests on running worlds with one connected client.
#include "server/services/admin_control.h"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/admin.pb.h"
#include "jostle/v1/play.pb.h"
#include "server/session/client_session.h"
#include "tests/server/server_parts.h"
#include "tests/support/error_of.h"

namespace jostle::server {

using namespace std::chrono_literals;
using test::error_of;

namespace {

class AdminControlTest : public testing::Test, protected ServerParts {
protected:
    AdminControlTest() : ServerParts(2, 4) {}
    void SetUp() override {
        ASSERT_TRUE(worlds.create("arena", *scenes::find_scene("stack")).ok());
        ASSERT_TRUE(worlds.create("other", *scenes::find_scene("dominoes")).ok());
    }
    // A client in "arena" that reads all messages.
    struct Player {
        explicit Player(PlayContext& context)
            : link(context,
                   Peer{.name = "10.0.0.1:4000",
                        .address = "10.0.0.1",
                        .call = "jostle.v1.PlayService/Play",
                        .who = context.authorizer.identify({.address = "10.0.0.1"})},
                   Clock::now()) {
            v1::ClientMessage hello;
            hello.mutable_hello()->set_protocol(1);
            hello.mutable_hello()->set_name("ann");
            hello.mutable_hello()->set_world("arena");
            link.receive(hello.SerializeAsString(), Clock::now());
            listen();
        }
        void listen() {
            while (const auto message = link.take_message(Clock::now())) {
                v1::ServerMessage parsed;
                ASSERT_TRUE(parsed.ParseFromString(message->header +
                                                   (message->shared ? *message->shared : "")));
                if (parsed.has_notice()) notice = parsed.notice().message();
            }
        }
        ClientSession link;
        std::string notice;
    };

    const Identity anyone{.role = Role::admin};
    AdminControl control{context};
};

TEST_F(AdminControlTest, lists_connected_clients) {
    Player player(context);
    std::this_thread::sleep_for(50ms);
    player.listen();
    v1::ListClientsRequest request;
    v1::ListClientsResponse response;
    ASSERT_TRUE(control.list_clients(request, response, anyone).ok());
    ASSERT_EQ(response.clients_size(), 1);
    EXPECT_EQ(response.clients(0).name(), "ann");
    EXPECT_EQ(response.clients(0).world_name(), "arena");
    EXPECT_EQ(response.clients(0).address(), "10.0.0.1:4000");
    EXPECT_GT(response.clients(0).kbit_per_second(), 0);
    response.Clear();
    request.set_world("other");
    ASSERT_TRUE(control.list_clients(request, response, anyone).ok());
    EXPECT_EQ(response.clients_size(), 0);
    request.set_world("nowhere");
    EXPECT_EQ(error_of(control.list_clients(request, response, anyone)).code, ErrorCode::not_found);
}

TEST_F(AdminControlTest, kicked_client_receives_the_reason_and_disconnects) {
    Player player(context);
    v1::KickRequest request;
    v1::KickResponse response;
    request.set_client(1);
    request.set_reason(std::string(101, 'x'));
    EXPECT_EQ(error_of(control.kick(request, response, anyone)).code, ErrorCode::invalid_argument);
    request.set_reason("please be kind");
    ASSERT_TRUE(control.kick(request, response, anyone).ok());
    player.listen();
    ASSERT_TRUE(player.link.end());
    EXPECT_EQ(player.link.end()->error().code, ErrorCode::permission_denied);
    EXPECT_EQ(player.notice, "an operator removed the client: please be kind");
    EXPECT_EQ(error_of(control.kick(request, response, anyone)).code, ErrorCode::not_found);
}

TEST_F(AdminControlTest, administrator_of_another_world_neither_sees_nor_removes_a_client) {
    Player player(context);
    const Identity here{.role = Role::admin, .worlds = {"pit", "arena"}},
        elsewhere{.role = Role::admin, .worlds = {"other"}};
    v1::ListClientsResponse listed;
    ASSERT_TRUE(control.list_clients({}, listed, elsewhere).ok());
    EXPECT_EQ(listed.clients_size(), 0);
    ASSERT_TRUE(control.list_clients({}, listed, here).ok());
    EXPECT_EQ(listed.clients_size(), 1);
    v1::ListClientsRequest of_world;
    of_world.set_world("arena");
    EXPECT_EQ(error_of(control.list_clients(of_world, listed, elsewhere)).code,
              ErrorCode::permission_denied);
    v1::KickRequest request;
    v1::KickResponse response;
    std::vector<std::string> refusals;
    for (const std::uint32_t client : {1u, 999u}) {
        request.set_client(client);
        const Error error = error_of(control.kick(request, response, elsewhere));
        EXPECT_EQ(error.code, ErrorCode::permission_denied);
        refusals.push_back(error.message);
    }
    EXPECT_EQ(refusals[0],
              "there is no client 1 in the worlds of the token; ListClients lists them");
    EXPECT_EQ(refusals[1],
              "there is no client 999 in the worlds of the token; ListClients lists them")
        << "does not reveal which clients exist";
    player.listen();
    EXPECT_FALSE(player.link.end());
    request.set_client(1);
    EXPECT_TRUE(control.kick(request, response, here).ok());
    player.listen();
    EXPECT_TRUE(player.link.end());
}

TEST_F(AdminControlTest, ban_ends_sessions_and_refuses_new_ones_until_it_is_removed) {
    Player player(context);
    v1::BanRequest request;
    v1::BanResponse response;
    request.set_network("::ffff:10.0.0.0/104");
    request.set_reason("spamming");
    request.set_duration_seconds(3600);
    ASSERT_TRUE(control.ban(request, response, anyone).ok());
    EXPECT_EQ(response.ban().network(), "10.0.0.0/8");
    EXPECT_EQ(response.ban().expires().size(), 24u);
    EXPECT_FALSE(response.persisted());
    player.listen();
    ASSERT_TRUE(player.link.end());
    EXPECT_EQ(player.link.end()->error().code, ErrorCode::permission_denied);
    EXPECT_EQ(player.notice,
              "this network is banned until " + response.ban().expires() + ": spamming");
    EXPECT_EQ(context.resume_registry.disconnected(), 0u) << "the session cannot be resumed";
    Player again(context);
    ASSERT_TRUE(again.link.end());
    EXPECT_EQ(again.notice, player.notice);
    v1::ListBansResponse listed;
    ASSERT_TRUE(control.list_bans({}, listed).ok());
    ASSERT_EQ(listed.bans_size(), 1);
    EXPECT_EQ(listed.bans(0).reason(), "spamming");
    v1::UnbanRequest removal;
    v1::UnbanResponse removed;
    removal.set_network("10.0.0.0/8");
    ASSERT_TRUE(control.unban(removal, removed).ok());
    EXPECT_EQ(error_of(control.unban(removal, removed)).code, ErrorCode::not_found);
    Player third(context);
    EXPECT_FALSE(third.link.end());
}

TEST_F(AdminControlTest, rejects_invalid_bans) {
    const Identity boss{.subject = "boss", .role = Role::admin, .anonymous = false};
    v1::BanResponse response;
    const auto code = [&](const std::function<void(v1::BanRequest&)>& change) {
        v1::BanRequest request;
        request.set_subject("eve");
        change(request);
        return error_of(control.ban(request, response, boss)).code;
    };
    using R = v1::BanRequest;
    EXPECT_EQ(code([](R& r) { r.clear_subject(); }), ErrorCode::invalid_argument);
    EXPECT_EQ(code([](R& r) { r.set_subject("boss"); }), ErrorCode::invalid_argument);
    EXPECT_EQ(code([](R& r) { r.set_subject("anonymous"); }), ErrorCode::invalid_argument);
    EXPECT_EQ(code([](R& r) { r.set_network("10.0.0.1/8"); }), ErrorCode::invalid_argument);
    EXPECT_EQ(code([](R& r) { r.set_reason("a\nb"); }), ErrorCode::invalid_argument);
    for (const double seconds : {-1.0, 1e9, std::nan("")})
        EXPECT_EQ(code([&](R& r) { r.set_duration_seconds(seconds); }),
                  ErrorCode::invalid_argument);
    v1::ListBansResponse listed;
    ASSERT_TRUE(control.list_bans({}, listed).ok());
    EXPECT_EQ(listed.bans_size(), 0);
}

TEST_F(AdminControlTest, pauses_steps_and_resumes_a_world) {
    v1::StepWorldRequest step;
    v1::StepWorldResponse stepped;
    step.set_world("arena");
    step.set_steps(5);
    EXPECT_EQ(error_of(control.step_world(step, stepped)).code, ErrorCode::failed_precondition);
    v1::SetPausedRequest pause;
    v1::SetPausedResponse paused;
    pause.set_world("arena");
    pause.set_paused(true);
    ASSERT_TRUE(control.set_paused(pause, paused).ok());
    EXPECT_EQ(worlds.find("arena")->lifecycle().paused(), "by an operator");
    ASSERT_TRUE(control.step_world(step, stepped).ok());
    EXPECT_EQ(stepped.steps_taken(), 5u);
    EXPECT_GT(stepped.tick(), paused.tick());
    for (const std::uint32_t steps : {0u, 1001u}) {
        step.set_steps(steps);
        EXPECT_EQ(error_of(control.step_world(step, stepped)).code, ErrorCode::invalid_argument);
    }
    pause.set_paused(false);
    ASSERT_TRUE(control.set_paused(pause, paused).ok());
    EXPECT_FALSE(worlds.find("arena")->lifecycle().paused());
    pause.clear_world();
    EXPECT_EQ(error_of(control.set_paused(pause, paused)).code, ErrorCode::invalid_argument)
        << "the world must be named explicitly";
}

// An exported scene is valid for the strict scene reader.
TEST_F(AdminControlTest, exports_a_valid_scene) {
    v1::ExportWorldRequest request;
    v1::ExportWorldResponse response;
    request.set_world("other");
    ASSERT_TRUE(control.export_world(request, response).ok());
    const auto scene = scenes::from_message(response.scene());
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->bodies.size(), scenes::find_scene("dominoes")->bodies.size());
    EXPECT_GT(response.tick(), 0u);
    request.set_world("nowhere");
    EXPECT_EQ(error_of(control.export_world(request, response)).code, ErrorCode::not_found);
}

TEST_F(AdminControlTest, an_export_can_be_downloaded_in_pieces) {
    v1::DownloadWorldRequest request;
    v1::DownloadWorldResponse response;
    request.set_world("other");
    ASSERT_TRUE(control.download_world(request, response).ok());
    request.set_id(response.id());
    std::string bytes = response.data();
    EXPECT_EQ(response.bytes(), bytes.size());
    v1::DownloadWorldRequest second;
    second.set_world("other");
    v1::DownloadWorldResponse ignored;
    const Error busy = error_of(control.download_world(second, ignored));
    EXPECT_EQ(busy.code, ErrorCode::resource_exhausted);
    EXPECT_EQ(busy.retry_after_ms, 1000);
    request.set_offset(bytes.size());
    ASSERT_TRUE(control.download_world(request, response).ok());
    EXPECT_TRUE(response.data().empty()) << "the end";
    v1::ExportWorldResponse exported;
    ASSERT_TRUE(exported.ParseFromString(bytes));
    EXPECT_TRUE(scenes::from_message(exported.scene()).ok());
    EXPECT_EQ(error_of(control.download_world(request, response)).code, ErrorCode::not_found)
        << "an export is deleted when it was read";
}

TEST(ExportDownload, has_pieces_of_1_mib_and_is_deleted_if_nobody_reads_it) {
    ExportDownload download;
    const Clock::time_point start = Clock::now();
    std::string bytes(std::size_t{5} << 19, 'x');
    bytes.back() = 'y';
    const auto first = download.begin("w1", bytes, start);
    ASSERT_TRUE(first.ok());
    EXPECT_EQ(first->bytes, bytes.size());
    std::string read = first->data;
    EXPECT_EQ(read.size(), std::size_t{1} << 20);
    EXPECT_EQ(error_of(download.read("w2", first->id, 0, start)).code, ErrorCode::not_found)
        << "the export of another world";
    EXPECT_EQ(error_of(download.read("w1", first->id, bytes.size() + 1, start)).code,
              ErrorCode::invalid_argument);
    for (;;) {
        const auto piece = download.read("w1", first->id, read.size(), start);
        ASSERT_TRUE(piece.ok());
        if (piece->data.empty()) break;
        read += piece->data;
    }
    EXPECT_TRUE(read == bytes);

    const auto second = download.begin("w1", "z", start);
    ASSERT_TRUE(second.ok());
    EXPECT_FALSE(download.begin("w2", "z", start + std::chrono::seconds(9)).ok());
    download.remove_idle(start + std::chrono::seconds(11));
    EXPECT_EQ(error_of(download.read("w1", second->id, 0, start)).code, ErrorCode::not_found);
}

TEST_F(AdminControlTest, profiles_for_the_requested_duration) {
    v1::ProfileRequest request;
    v1::ProfileResponse response;
    request.set_world("arena");
    for (const double seconds : {0.0, 0.5, 31.0, std::nan("")}) {
        request.set_seconds(seconds);
        EXPECT_EQ(error_of(control.profile(request, response)).code, ErrorCode::invalid_argument);
    }
    request.set_seconds(1);
    ASSERT_TRUE(control.profile(request, response).ok());
    EXPECT_GE(response.ticks(), 20u);
    EXPECT_NE(response.trace().find("\"name\":\"update_pairs\""), std::string::npos);
}

TEST_F(AdminControlTest, moderates_a_room_without_its_restrictions) {
    ASSERT_TRUE(worlds.create("room", *scenes::find_scene("stack"), "ada", RoomProperties{}).ok());
    const auto world = worlds.find("room");
    world->mailbox().enter(7, {.member = "subject/eve"});
    v1::ModerateRoomRequest request;
    v1::ModerateRoomResponse response;
    request.set_world("room");
    request.mutable_command()->mutable_ban()->set_client(7);
    request.mutable_command()->mutable_ban()->set_reason("spamming");
    const auto deadline = Clock::now() + 5s;
    while (!world->frame()->room->find(7) && Clock::now() < deadline)
        std::this_thread::sleep_for(1ms);
    ASSERT_TRUE(control.moderate_room(request, response).ok());
    while (world->frame()->room->bans.empty() && Clock::now() < deadline)
        std::this_thread::sleep_for(1ms);
    v1::GetRoomRequest of;
    of.set_world("room");
    v1::GetRoomResponse room;
    ASSERT_TRUE(control.get_room(of, room).ok());
    EXPECT_EQ(room.owner(), "subject/ada");
    ASSERT_EQ(room.members_size(), 1);
    EXPECT_TRUE(room.members(0).removed());
    ASSERT_EQ(room.bans_size(), 1);
    EXPECT_EQ(room.bans(0).member(), "subject/eve");
    EXPECT_TRUE(room.bans(0).permanent());
    request.mutable_command()->mutable_kick()->set_client(99);
    EXPECT_EQ(error_of(control.moderate_room(request, response)).code, ErrorCode::not_found);
    request.mutable_command()->mutable_pause()->set_paused(true);
    EXPECT_EQ(error_of(control.moderate_room(request, response)).code, ErrorCode::invalid_argument);
    request.set_world("arena");
    request.mutable_command()->mutable_reset();
    EXPECT_EQ(error_of(control.moderate_room(request, response)).code,
              ErrorCode::failed_precondition);
    of.set_world("arena");
    EXPECT_EQ(error_of(control.get_room(of, room)).code, ErrorCode::failed_precondition);
}

TEST_F(AdminControlTest, limits_concurrent_blocking_calls) {
    std::vector<std::thread> waiting;
    std::atomic<int> refused{0};
    for (int i = 0; i < 12; i++)
        waiting.emplace_back([&, i] {
            v1::ProfileRequest request;
            v1::ProfileResponse response;
            request.set_world(i % 2 ? "arena" : "other");
            request.set_seconds(1);
            const Status status = control.profile(request, response);
            if (!status.ok() && status.error().code == ErrorCode::resource_exhausted) refused++;
        });
    for (std::thread& thread : waiting) thread.join();
    EXPECT_GE(refused, 8) << "at most two worlds record at a time and at most four calls wait";
}

TEST_F(AdminControlTest, drain_returns_client_count_and_is_idempotent) {
    const Player player(context);
    v1::DrainResponse response;
    ASSERT_TRUE(control.drain({}, response).ok());
    EXPECT_EQ(response.clients(), 1u);
    EXPECT_EQ(response.timeout_seconds(), 5);
    EXPECT_TRUE(context.drain_requested);
    EXPECT_TRUE(control.drain({}, response).ok());
}

}  // namespace
}  // namespace jostle::server
