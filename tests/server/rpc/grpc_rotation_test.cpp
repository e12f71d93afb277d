// SPDX-License-Identifier: MIT
//
// gRPC's own watcher on the store's files: fifty rotations under new handshakes, ten of them broken
// pairs, and none fails. Channels that are open stay so.
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <thread>

#include "grpc/health/v1/health.grpc.pb.h"
#include "support/certificates.h"
#include "support/temp_folder.h"
#include "tls/certificate_store.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::make_certificate;
using test::TestCertificate;
namespace health = grpc::health::v1;

class Healthy final : public health::Health::Service {
    grpc::Status Check(grpc::ServerContext*, const health::HealthCheckRequest*,
                       health::HealthCheckResponse* response) override {
        response->set_status(health::HealthCheckResponse::SERVING);
        return grpc::Status::OK;
    }
};

std::shared_ptr<grpc::ServerCredentials> credentials_of(const CertificateStore& store) {
    const auto provider = std::make_shared<grpc::experimental::FileWatcherCertificateProvider>(
        store.identity_file(), store.identity_file(), 1);
    grpc::experimental::TlsServerCredentialsOptions options(provider);
    options.watch_identity_key_cert_pairs();
    return grpc::experimental::TlsServerCredentials(options);
}

bool answers(health::Health::Stub& stub) {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + 20s);
    health::HealthCheckResponse response;
    return stub.Check(&context, {}, &response).ok();
}

TEST(GrpcRotation, fifty_rotations_with_ten_broken_pairs_fail_no_handshake) {
    const test::TempFolder folder;
    const TestCertificate root = test::make_authority();
    TestCertificate last = make_certificate({}, &root);
    const auto put = [&](const TestCertificate& certificate, const TestCertificate& key) {
        folder.write("key.pem", key.key_pem());
        folder.write("chain.pem", certificate.pem());
    };
    put(last, last);
    const auto store =
        CertificateStore::open({.certificate = folder / "chain.pem", .key = folder / "key.pem"},
                               std::chrono::system_clock::now())
            .value();
    Healthy service;
    grpc::ServerBuilder builder;
    int port = 0;
    builder.AddListeningPort("127.0.0.1:0", credentials_of(*store), &port);
    builder.RegisterService(&service);
    const std::unique_ptr<grpc::Server> server = builder.BuildAndStart();
    ASSERT_TRUE(server);
    // A subchannel pool of its own: each channel makes a handshake of its own.
    const auto connect = [&] {
        grpc::ChannelArguments arguments;
        arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
        return health::Health::NewStub(grpc::CreateCustomChannel(
            "localhost:" + std::to_string(port),
            grpc::SslCredentials({.pem_root_certs = root.pem()}), arguments));
    };
    const auto first = connect();
    ASSERT_TRUE(answers(*first));
    std::atomic<bool> done = false;
    std::atomic<int> handshakes = 0, failed = 0;
    std::vector<std::jthread> clients;
    for (int t = 0; t < 2; ++t)
        clients.emplace_back([&] {
            while (!done) {
                if (!answers(*connect())) ++failed;
                ++handshakes;
                std::this_thread::sleep_for(2ms);
            }
        });
    for (int i = 1; i <= 50; ++i) {
        const TestCertificate next = make_certificate({}, &root);
        if (i % 5 != 0) {
            put(next, next);
            last = next;
        } else {
            put(next, last);
        }
        EXPECT_EQ(store->reload(std::chrono::system_clock::now()),
                  i % 5 != 0 ? CertificateStore::Change::taken : CertificateStore::Change::refused);
        std::this_thread::sleep_for(
            100ms);  // gRPC looks each second: several changes between looks
    }
    done = true;
    clients.clear();
    EXPECT_EQ(failed, 0) << "of " << handshakes;
    EXPECT_GT(handshakes, 20);
    EXPECT_TRUE(answers(*first)) << "the first channel, from before all of them";
    server->Shutdown(std::chrono::system_clock::now() + 1s);
    RecordProperty("handshakes", handshakes);
}

}  // namespace
}  // namespace jostle::server
