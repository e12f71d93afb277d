// SPDX-License-Identifier: MIT
//
// Start, shutdown and misbehaving clients. Each test has its own server.
#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <random>
#include <thread>

#include "grpc/health/v1/health.grpc.pb.h"
#include "jostle/v1/world.grpc.pb.h"
#include "tests/system/player.h"
#include "tests/system/server_process.h"

namespace jostle::test {
namespace {

using namespace std::chrono_literals;
namespace asio = boost::asio;
using asio::ip::tcp;

std::vector<std::string> free_ports(std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"});
    return more;
}

bool has_snapshot(const PlayState& state) {
    return state.snapshots > 0;
}

std::unique_ptr<v1::WorldService::Stub> world_service(const ServerProcess& server) {
    return v1::WorldService::NewStub(
        grpc::CreateChannel(server.grpc_address(), grpc::InsecureChannelCredentials()));
}

// Sends bytes to a port. Waits 0.5 s for a response, or up to 10 s until it contains `expected`,
// because a loaded machine may need a while. Returns whether it does.
bool request_raw(int port, const std::string& bytes, const std::string& expected = {}) {
    asio::io_context io;
    tcp::socket socket(io);
    boost::system::error_code error;
    socket.connect({asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)}, error);
    asio::write(socket, asio::buffer(bytes), error);
    std::string answer;
    if (expected.empty())
        asio::async_read(socket, asio::dynamic_buffer(answer), [](auto, auto) {});
    else
        asio::async_read_until(socket, asio::dynamic_buffer(answer), expected, [](auto, auto) {});
    io.run_for(expected.empty() ? 500ms : 10s);
    return answer.find(expected) != std::string::npos;
}

// A machine without processor time, and a process that was stopped, are no faults of a world.
// CMakeLists.txt runs it alone.
TEST(StarvedServer, twenty_busy_processes_and_a_stopped_process_pause_no_world) {
    ServerProcess server(
        free_ports({"--scene", "sandbox", "--scene", "pile", "--admin", "127.0.0.1:0"}));
    ASSERT_TRUE(server.is_running()) << server.log();
    std::vector<pid_t> busy;
    for (int k = 0; k < 20; k++) {
        const pid_t child = fork();
        if (child == 0)
            for (std::mt19937 work;;) work.discard(1000);
        busy.push_back(child);
    }
    std::this_thread::sleep_for(3s);
    EXPECT_TRUE(request_raw(server.http_port(), "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n",
                            "200 OK"));
    server.signal(SIGSTOP);
    std::this_thread::sleep_for(3s);
    server.signal(SIGCONT);
    EXPECT_TRUE(request_raw(server.http_port(), "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n",
                            "200 OK"));
    for (const pid_t child : busy) {
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
    }
    const auto worlds = world_service(server);
    grpc::ClientContext context;
    v1::ListWorldsResponse listed;
    ASSERT_TRUE(worlds->ListWorlds(&context, {}, &listed).ok());
    ASSERT_EQ(listed.worlds_size(), 2);
    for (const v1::WorldInfo& world : listed.worlds())
        EXPECT_EQ(world.paused(), "") << world.name();
    EXPECT_EQ(server.log().find("was paused"), std::string::npos) << server.log();
    EXPECT_EQ(server.log().find(" error "), std::string::npos) << server.log();
}

TEST(Lifecycle, a_taken_port_is_one_error_line) {
    ServerProcess first(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(first.is_running()) << first.log();
    ServerProcess second({"--scene", "stack", "--listen", "127.0.0.1:0", "--http",
                          "127.0.0.1:" + std::to_string(first.http_port())});
    EXPECT_EQ(second.wait(10s), 1);
    const std::string log = second.log();
    const std::size_t error = log.find(" error ");
    ASSERT_NE(error, std::string::npos) << log;
    EXPECT_EQ(log.find(" error ", error + 1), std::string::npos) << log;
    EXPECT_NE(log.find("Address already in use", error), std::string::npos) << log;
}

TEST(Lifecycle, sigterm_notifies_clients_and_exits_with_0) {
    ServerProcess server(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(server.is_running()) << server.log();
    const auto grpc = grpc_player(server.grpc_address());
    const auto browser = websocket_player(server.http_port());
    for (const auto* player : {grpc.get(), browser.get()}) {
        const_cast<Player*>(player)->hello();
        ASSERT_TRUE(player->wait_until(has_snapshot));
    }
    server.signal(SIGTERM);
    for (const auto* player : {grpc.get(), browser.get()}) {
        EXPECT_TRUE(player->wait_until([](const PlayState& s) {
            return !s.notices.empty() && s.notices[0].code() == v1::NOTICE_CODE_DRAINING;
        }));
        EXPECT_FALSE(player->end()) << "clients must have time to leave";
    }
    EXPECT_TRUE(request_raw(server.http_port(), "GET /readyz HTTP/1.1\r\nHost: x\r\n\r\n", "503"));
    // No client leaves: the server ends both streams after its drain timeout of 5 s.
    EXPECT_EQ(server.wait(9s), 0) << server.log();
    EXPECT_TRUE(grpc->wait_for_end());
    EXPECT_TRUE(grpc->end()->starts_with("14: ")) << *grpc->end();  // UNAVAILABLE
    EXPECT_TRUE(browser->wait_for_end());
    EXPECT_EQ(*browser->end(), "1012");  // service restart
}

TEST(Lifecycle, exposes_metrics) {
    ServerProcess server(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(server.is_running());
    const auto grpc = grpc_player(server.grpc_address());
    const auto browser = websocket_player(server.http_port());
    for (Player* player : {grpc.get(), browser.get()}) {
        player->hello();
        ASSERT_TRUE(player->wait_until(has_snapshot));
    }
    v1::GetWorldResponse world;
    grpc::ClientContext known, unknown;
    ASSERT_TRUE(world_service(server)->GetWorld(&known, {}, &world).ok());
    v1::GetWorldRequest nowhere;
    nowhere.set_world("nowhere");
    EXPECT_FALSE(world_service(server)->GetWorld(&unknown, nowhere, &world).ok());
    // Connections are counted a few times per second.
    const auto has = [&](const char* line) {
        for (int tries = 0; tries < 20; tries++) {
            if (request_raw(server.admin_port(),
                            "GET /metrics HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n", line))
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        return false;
    };
    EXPECT_TRUE(has("jostle_clients{world=\"stack\"} 2\n"));
    EXPECT_TRUE(has("jostle_connections{listener=\"http\"} 1\n"));
    for (const char* code : {"OK", "NOT_FOUND"})
        EXPECT_TRUE(has((std::string("grpc_server_handled_total{grpc_code=\"") + code +
                         "\",grpc_method=\"GetWorld\",grpc_service=\"jostle.v1.WorldService\"} 1\n")
                            .c_str()));
    grpc->leave();
    ASSERT_TRUE(grpc->wait_for_end());
    EXPECT_TRUE(has("jostle_clients{world=\"stack\"} 1\n"));
    EXPECT_TRUE(
        has("grpc_server_handled_total{grpc_code=\"OK\",grpc_method=\"Play\",grpc_service="
            "\"jostle.v1.PlayService\"} 1\n"));
    EXPECT_FALSE(has("jostle_snapshots_sent_total 0\n"));
}

TEST(Lifecycle, serves_health_check_and_watch) {
    using grpc::health::v1::HealthCheckResponse;
    ServerProcess server(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(server.is_running());
    const auto player = grpc_player(server.grpc_address());  // blocks the drain
    player->hello();
    ASSERT_TRUE(player->wait_until(has_snapshot));
    const auto health = grpc::health::v1::Health::NewStub(
        grpc::CreateChannel(server.grpc_address(), grpc::InsecureChannelCredentials()));
    grpc::health::v1::HealthCheckRequest request;
    HealthCheckResponse response;
    for (const char* service :
         {"", "jostle.v1.PlayService", "jostle.v1.QueryService", "jostle.v1.WorldService"}) {
        grpc::ClientContext context;
        request.set_service(service);
        ASSERT_TRUE(health->Check(&context, request, &response).ok()) << service;
        EXPECT_EQ(response.status(), HealthCheckResponse::SERVING) << service;
    }
    grpc::ClientContext unknown, watch;
    request.set_service("nothing");
    EXPECT_EQ(health->Check(&unknown, request, &response).error_code(),
              grpc::StatusCode::NOT_FOUND);
    request.set_service("");
    const auto changes = health->Watch(&watch, request);
    ASSERT_TRUE(changes->Read(&response));
    EXPECT_EQ(response.status(), HealthCheckResponse::SERVING);
    server.signal(SIGTERM);
    ASSERT_TRUE(changes->Read(&response));
    EXPECT_EQ(response.status(), HealthCheckResponse::NOT_SERVING);
    player->leave();
    EXPECT_EQ(server.wait(5s), 0) << "a Watch stream must not block the shutdown";
}

TEST(Lifecycle, exits_when_the_last_client_leaves_or_on_a_second_signal) {
    ServerProcess one(free_ports({"--scene", "stack"})), two(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(one.is_running() && two.is_running());
    const auto leaves = grpc_player(one.grpc_address()), stays = grpc_player(two.grpc_address());
    leaves->hello();
    stays->hello();
    ASSERT_TRUE(leaves->wait_until(has_snapshot) && stays->wait_until(has_snapshot));
    one.signal(SIGTERM);
    two.signal(SIGINT);
    ASSERT_TRUE(stays->wait_until([](const PlayState& s) { return !s.notices.empty(); }));
    leaves->leave();
    two.signal(SIGINT);
    EXPECT_EQ(one.wait(3s), 0) << one.log();
    EXPECT_EQ(two.wait(3s), 0) << two.log();
}

TEST(Lifecycle, reports_a_port_in_use) {
    ServerProcess first(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(first.is_running());
    ServerProcess grpc(
        {"--scene", "stack", "--listen", first.grpc_address(), "--http", "127.0.0.1:0"});
    EXPECT_EQ(grpc.wait(10s), 1);
    EXPECT_NE(grpc.log().find("cannot listen on " + first.grpc_address()), std::string::npos)
        << grpc.log();
    const std::string http = "127.0.0.1:" + std::to_string(first.http_port());
    ServerProcess web({"--scene", "stack", "--listen", "127.0.0.1:0", "--http", http});
    EXPECT_EQ(web.wait(10s), 1);
    EXPECT_NE(web.log().find("cannot listen on " + http), std::string::npos) << web.log();
    const std::string admin = "127.0.0.1:" + std::to_string(first.admin_port());
    ServerProcess admin_taken(free_ports({"--scene", "stack", "--admin", admin}));
    EXPECT_EQ(admin_taken.wait(10s), 1);
    EXPECT_NE(admin_taken.log().find("choose another with --admin HOST:PORT"), std::string::npos)
        << admin_taken.log();
    ServerProcess without_admin(free_ports({"--scene", "stack", "--admin", ""}));
    EXPECT_TRUE(without_admin.is_running()) << without_admin.log();
    EXPECT_EQ(without_admin.admin_port(), 0) << "an empty address must disable the admin listener";
    EXPECT_TRUE(first.is_running());
}

TEST(Lifecycle, reports_invalid_flags) {
    ServerProcess scene(free_ports({"--scene", "no_such_scene"}));
    EXPECT_EQ(scene.wait(10s), 1);
    EXPECT_NE(scene.log().find("no_such_scene"), std::string::npos) << scene.log();
    ServerProcess address({"--listen", "nowhere"});
    EXPECT_EQ(address.wait(10s), 2);
    EXPECT_NE(address.log().find("nowhere"), std::string::npos) << address.log();
}

TEST(Lifecycle, survives_garbage_on_both_ports) {
    ServerProcess server(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(server.is_running());
    std::minstd_rand random(1);
    for (int i = 0; i < 10; ++i) {
        std::string bytes(1 + random() % 20000, '\0');
        for (char& c : bytes) c = static_cast<char>(random());
        request_raw(server.grpc_port(), bytes);
        request_raw(server.http_port(), bytes);
    }
    EXPECT_TRUE(request_raw(server.http_port(),
                            "GET / HTTP/1.1\r\nX: " + std::string(10000, 'x') + "\r\n\r\n",
                            " 431 "));
    EXPECT_TRUE(request_raw(
        server.http_port(),
        "POST /api/worlds HTTP/1.1\r\nHost: x\r\nContent-Length: 99999999\r\n\r\n", " 413 "));
    // Regression test: the chunk parser aborted the process when the last chunk arrived in such
    // pieces.
    EXPECT_TRUE(request_raw(server.http_port(),
                            "PUT / HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n",
                            " 411 "));
    EXPECT_TRUE(request_raw(server.http_port(),
                            "GET /../../etc/passwd HTTP/1.1\r\nHost: localhost\r\n\r\n", " 400 "));
    const auto player = grpc_player(server.grpc_address());
    player->hello();
    EXPECT_TRUE(player->wait_until(has_snapshot));
    EXPECT_TRUE(server.is_running());
}

TEST(Lifecycle, disconnects_protocol_violators_with_a_notice) {
    ServerProcess server(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(server.is_running());
    struct Case {
        const char* what;
        std::function<void(Player&)> misbehave;
        const char* status;
    };
    const Case cases[] = {
        {"an unknown world", [](Player& p) { p.hello("nowhere"); }, "5: "},
        {"inputs before hello", [](Player& p) { p.send_inputs({}); }, "9: "},
        {"a long name", [](Player& p) { p.hello("", std::string(33, 'x')); }, "3: "},
        {"an empty message", [](Player& p) { p.send({}); }, "3: "},
        {"a huge message", [](Player& p) { p.hello(std::string(100000, 'x')); }, "8: "},
        {"a second hello",
         [](Player& p) {
             p.hello();
             p.hello();
         },
         "9: "},
    };
    for (const Case& c : cases) {
        const auto player = grpc_player(server.grpc_address());
        c.misbehave(*player);
        ASSERT_TRUE(player->wait_for_end()) << c.what;
        EXPECT_TRUE(player->end()->starts_with(c.status)) << c.what << ": " << *player->end();
        player->with_state([&](const PlayState& s) {
            ASSERT_FALSE(s.notices.empty()) << c.what;
            EXPECT_EQ(s.notices.back().code(), v1::NOTICE_CODE_REFUSED) << c.what;
            EXPECT_FALSE(s.notices.back().message().empty()) << c.what;
        });
    }
    const auto lost = websocket_player(server.http_port()),
               huge = websocket_player(server.http_port());
    lost->hello("nowhere");
    ASSERT_TRUE(lost->wait_for_end());
    EXPECT_EQ(*lost->end(), "1008");  // policy violation
    EXPECT_EQ(lost->with_state([](const PlayState& s) { return s.notices.size(); }), 1u);
    huge->hello(std::string(100000, 'x'));
    ASSERT_TRUE(huge->wait_for_end());
    EXPECT_EQ(*huge->end(), "1009");  // message too big
    // A cross-origin page must not get a stream.
    const auto stranger = websocket_player(server.http_port(), "http://elsewhere.example");
    EXPECT_TRUE(stranger->wait_for_end());
    EXPECT_TRUE(stranger->end()->starts_with("handshake")) << *stranger->end();
    EXPECT_TRUE(server.is_running());
}

TEST(Lifecycle, stalled_client_does_not_affect_others) {
    ServerProcess server(free_ports({"--scene", "pile",  // 1,000 moving bodies
                                     "--set", "stream.client_timeout_seconds=5"}));
    ASSERT_TRUE(server.is_running());
    const auto stalled_grpc = grpc_player(server.grpc_address());
    const auto stalled_browser = websocket_player(server.http_port());
    const auto good = grpc_player(server.grpc_address());
    for (Player* player : {stalled_grpc.get(), stalled_browser.get(), good.get()}) {
        player->hello();
        ASSERT_TRUE(player->wait_until(has_snapshot));
    }
    stalled_grpc->stall();
    stalled_browser->stall();
    const auto worlds = world_service(server);
    const int previous = good->with_state([](const PlayState& s) { return s.snapshots; });
    const auto begin = std::chrono::steady_clock::now();
    // Both sent nothing for more than 5 s. The other one receives snapshots before and afterwards.
    const auto clients = [&] {
        v1::GetWorldResponse world;
        grpc::ClientContext context;
        EXPECT_TRUE(worlds->GetWorld(&context, {}, &world).ok());
        return world.world().clients();
    };
    int before_timeout = 0, received = 0;
    for (bool stalled = true; std::chrono::steady_clock::now() < begin + 60s;) {
        good->send_inputs({});
        std::this_thread::sleep_for(33ms);
        received = good->with_state([](const PlayState& s) { return s.snapshots; }) - previous;
        if (stalled) before_timeout = received;
        stalled = stalled && clients() > 1;
        if (!stalled && received > before_timeout + 60) break;
    }
    EXPECT_GT(before_timeout, 30);
    EXPECT_GT(received, before_timeout + 60);
    EXPECT_EQ(clients(), 1u);
    good->with_state([](const PlayState& s) { EXPECT_EQ(s.violations, 0) << s.first_violation; });
}

TEST(Lifecycle, creates_joins_and_deletes_worlds) {
    ServerProcess server(free_ports({"--scene", "stack"}));
    ASSERT_TRUE(server.is_running());
    const auto worlds = world_service(server);
    const auto context = [] {
        auto made = std::make_unique<grpc::ClientContext>();
        made->set_deadline(std::chrono::system_clock::now() + 10s);
        return made;
    };
    v1::CreateWorldRequest create;
    v1::CreateWorldResponse created;
    create.set_scene_name("dominoes");
    create.set_name("mine");
    ASSERT_TRUE(worlds->CreateWorld(context().get(), create, &created).ok());
    EXPECT_EQ(worlds->CreateWorld(context().get(), create, &created).error_code(),
              grpc::StatusCode::ALREADY_EXISTS);
    create.set_name("other");
    create.set_scene_name("no_such_scene");
    EXPECT_EQ(worlds->CreateWorld(context().get(), create, &created).error_code(),
              grpc::StatusCode::NOT_FOUND);
    create.mutable_scene()->set_name("ball");
    v1::Shape& ball = *create.mutable_scene()->add_bodies()->add_shapes();
    ball.mutable_sphere()->set_radius(-1);
    const grpc::Status bad = worlds->CreateWorld(context().get(), create, &created);
    EXPECT_EQ(bad.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_NE(bad.error_message().find("radius"), std::string::npos) << bad.error_message();
    ball.mutable_sphere()->set_radius(0.5);
    const grpc::Status good = worlds->CreateWorld(context().get(), create, &created);
    ASSERT_TRUE(good.ok()) << good.error_message();
    EXPECT_EQ(created.world().bodies(), 1u);

    v1::JoinWorldRequest join;
    v1::JoinWorldResponse joined;
    join.set_world("mine");
    ASSERT_TRUE(worlds->JoinWorld(context().get(), join, &joined).ok());
    EXPECT_EQ(joined.play_address(), server.grpc_address());
    v1::ClientMessage hello;
    hello.mutable_hello()->set_protocol(1);
    hello.mutable_hello()->set_ticket(joined.ticket());
    const auto player = grpc_player(joined.play_address()),
               again = grpc_player(joined.play_address());
    player->send(hello);
    ASSERT_TRUE(player->wait_until(has_snapshot));
    EXPECT_EQ(player->with_state([](const PlayState& s) { return s.welcome.world_name(); }),
              "mine");
    again->send(hello);
    ASSERT_TRUE(again->wait_for_end());
    EXPECT_TRUE(again->end()->starts_with("16: ")) << *again->end();  // a ticket is valid once

    v1::DeleteWorldRequest remove;
    v1::DeleteWorldResponse removed;
    remove.set_world("mine");
    ASSERT_TRUE(worlds->DeleteWorld(context().get(), remove, &removed).ok());
    EXPECT_TRUE(player->wait_for_end());
    EXPECT_TRUE(player->end()->starts_with("10: ")) << *player->end();  // ABORTED
    EXPECT_EQ(worlds->DeleteWorld(context().get(), remove, &removed).error_code(),
              grpc::StatusCode::NOT_FOUND);
}

}  // namespace
}  // namespace jostle::test
