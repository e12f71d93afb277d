// SPDX-License-Identifier: MIT
//
// Fifty players over TLS while the certificate is replaced fifty times, ten times by a mismatched
// pair. No player is disconnected and no concurrent handshake fails.
#include <gtest/gtest.h>

#include <thread>

#include "jostle/client/client.h"
#include "jostle/client/world_client.h"
#include "jostle/scenes/catalog.h"
#include "server/grpc/grpc_server.h"
#include "server/services/call_method.h"
#include "server/services/world_control.h"
#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::make_certificate;
using test::TestCertificate;

class GrpcRotationTest : public testing::Test {
protected:
    void put(const TestCertificate& certificate, const TestCertificate& key) const {
        folder.write("key.pem", key.key_pem());
        folder.write("chain.pem", certificate.pem());
    }
    void SetUp() override {
        put(last, last);
        store =
            CertificateStore::open({.certificate = folder / "chain.pem", .key = folder / "key.pem"},
                                   std::chrono::system_clock::now())
                .value();
        ASSERT_TRUE(worlds.create("sandbox", *scenes::find_scene("stack")).ok());
        config.quota.joins_per_minute = config.quota.queries_per_second = 1e6;
        authorizer = *Authorizer::open(config);
        context.reset(new PlayContext{
            .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *authorizer});
        control = std::make_unique<WorldControl>(*context);
        server = std::make_unique<GrpcServer>(
            *context, world_methods(*control, worlds, 4 << 20), [] { return true; },
            GrpcSettings{.port = 0, .certificates = store.get()});
        ASSERT_TRUE(server->start().ok());
        woken = server.get();
        target = "localhost:" + std::to_string(server->port());
    }
    void TearDown() override {
        worlds.stop_all();
        context->closing = true;
        server->drain({});
        server->stop();
    }
    client::Security believing(const TestCertificate& authority) const {
        return {.tls = true, .root_certificates_pem = authority.pem()};
    }

    const test::TempFolder folder;
    const TestCertificate root = test::make_authority();
    TestCertificate last = make_certificate({}, &root);
    std::unique_ptr<CertificateStore> store;
    Config config;
    SessionDirectory sessions{100};
    std::atomic<GrpcServer*> woken = nullptr;
    WorldDirectory worlds{{.on_frame =
                               [this](bool) {
                                   if (GrpcServer* const s = woken) s->wake();
                               }},
                          4};
    std::unique_ptr<Authorizer> authorizer;
    std::unique_ptr<PlayContext> context;
    std::unique_ptr<WorldControl> control;
    std::unique_ptr<GrpcServer> server;
    std::string target;
};

TEST_F(GrpcRotationTest, fifty_certificate_rotations_drop_no_client_and_fail_no_handshake) {
    client::Loop loop;
    std::vector<std::shared_ptr<client::Client>> players;
    for (int i = 0; i < 50; i++)
        players.push_back(client::Client::connect(
            loop, {.target = target, .security = believing(root), .reconnect = false}));
    const auto all_play = [&] {
        return std::ranges::all_of(players, [](const auto& p) { return p->stats().connected; });
    };
    for (const auto end = Clock::now() + 20s; !all_play() && Clock::now() < end;)
        std::this_thread::sleep_for(10ms);
    ASSERT_TRUE(all_play()) << players[0]->stats().last_error;

    std::atomic<bool> done = false;
    std::atomic<int> handshakes = 0, failed = 0;
    std::jthread newcomer([&] {
        while (!done) {
            if (!client::WorldClient(target, believing(root)).list().ok()) ++failed;
            ++handshakes;
        }
    });
    for (int i = 1; i <= 50; ++i) {
        const TestCertificate next = make_certificate({}, &root);
        const bool fits = i % 5 != 0;
        put(next, fits ? next : last);
        if (fits) last = next;
        EXPECT_EQ(store->reload(std::chrono::system_clock::now()),
                  fits ? CertificateStore::Change::taken : CertificateStore::Change::refused);
        std::this_thread::sleep_for(20ms);
        for (const auto end = Clock::now() + 20s; handshakes < i / 2 && Clock::now() < end;)
            std::this_thread::sleep_for(1ms);
    }
    done = true;
    newcomer.join();
    EXPECT_EQ(failed, 0) << "of " << handshakes;
    EXPECT_GT(handshakes, 20);
    // A loaded machine may need some time.
    for (const auto& player : players) {
        const auto previous = player->stats().snapshots;
        for (const auto end = Clock::now() + 20s;
             player->stats().snapshots == previous && Clock::now() < end;)
            std::this_thread::sleep_for(10ms);
        EXPECT_GT(player->stats().snapshots, previous);
        EXPECT_TRUE(player->stats().connected);
        EXPECT_EQ(player->stats().stream_failures, 0u);
    }
}

TEST_F(GrpcRotationTest, rejects_clients_without_the_certificate_authority) {
    const TestCertificate stranger = test::make_authority();
    EXPECT_FALSE(client::WorldClient(target, believing(stranger)).list().ok());
    EXPECT_TRUE(client::WorldClient(target, believing(root)).list().ok());
}

}  // namespace
}  // namespace jostle::server
