// SPDX-License-Identifier: MIT
//
// The probe against the server's own doors, and against doors that are shut, mute or say something
// else.
#include "server/app/health_probe.h"

#include <gmock/gmock.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>
#include <thread>

#include "grpc/health/v1/health.grpc.pb.h"
#include "server/grpc/grpc_server.h"
#include "server/http/http_routes.h"
#include "server/http/http_server.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"
#include "server/util/clock.h"
#include "tests/support/certificates.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;
namespace asio = boost::asio;
using asio::ip::tcp;

// Both listeners of a server without worlds.
class FakeServer {
public:
    FakeServer() {
        EXPECT_TRUE(grpc_.start().ok());
        EXPECT_TRUE(http_server_.start().ok());
    }
    ~FakeServer() {
        http_server_.stop();
        grpc_.stop();
    }
    void become_unhealthy() { healthy_ = false; }
    void drain() { grpc_.drain(1s); }
    HealthTarget target() const {
        return {.grpc = {"127.0.0.1", grpc_.port()},
                .http = {"127.0.0.1", static_cast<std::uint16_t>(http_server_.port())}};
    }

private:
    const Config config_;
    SessionDirectory sessions_{1};
    WorldDirectory worlds_{{}, 1};
    const std::unique_ptr<Authorizer> authorizer_ = *Authorizer::open(config_);
    PlayContext context_{
        .config = config_, .worlds = worlds_, .sessions = sessions_, .authorizer = *authorizer_};
    WorldControl control_{context_};
    const QueryControl queries_{context_};
    const HttpRoutes routes_{control_,
                             queries_,
                             {.web_root = ".",
                              .allowed_origins = {},
                              .not_ready_reason = [] { return std::optional<std::string>(); },
                              .failure_reason = [] { return std::nullopt; }}};
    std::atomic<bool> healthy_{true};
    GrpcServer grpc_{context_, {}, [this] { return healthy_.load(); }, {.port = 0}};
    HttpServer http_server_{context_, routes_, {.host = "127.0.0.1", .port = 0}};
};

// A door that takes one connection and says this, in TLS if it was given a context; nothing: it
// keeps silent for as long as it lives.
class Answer {
public:
    explicit Answer(std::string bytes, asio::ssl::context* tls = nullptr)
        : bytes_(std::move(bytes)), thread_([this, tls] { serve(tls); }) {}
    ~Answer() {
        boost::system::error_code ignored;
        tcp::socket(io_).connect(acceptor_.local_endpoint(), ignored);  // if nobody came
        thread_.join();
    }
    HostPort address() const { return {"127.0.0.1", acceptor_.local_endpoint().port()}; }

private:
    void serve(asio::ssl::context* tls) {
        boost::system::error_code error;
        tcp::socket socket = acceptor_.accept(error);
        if (bytes_.empty()) {
            silent_ = std::move(socket);
            return;
        }
        if (!tls) return say(socket);
        asio::ssl::stream<tcp::socket> stream(std::move(socket), *tls);
        stream.handshake(asio::ssl::stream_base::server, error);
        say(stream);
    }
    template <class Stream>
    void say(Stream& stream) {
        boost::system::error_code error;
        std::string request;
        asio::read_until(stream, asio::dynamic_buffer(request), "\r\n\r\n", error);
        asio::write(stream, asio::buffer(bytes_), error);
    }

    asio::io_context io_;
    tcp::acceptor acceptor_{io_, {asio::ip::address_v4::loopback(), 0}};
    tcp::socket silent_{io_};
    const std::string bytes_;
    std::thread thread_;
};

std::string error_of(const HealthTarget& target) {
    const Result<std::string> found = probe_health(target, 2s);
    return found.ok() ? "" : found.error().message;
}

std::string text(const HostPort& address) {
    return address.host + ":" + std::to_string(address.port);
}

TEST(HealthProbe, is_healthy_when_grpc_and_http_serve) {
    const FakeServer doors;
    const HealthTarget target = doors.target();
    const Result<std::string> found = probe_health(target, 2s);
    ASSERT_TRUE(found.ok()) << found.error().message;
    EXPECT_EQ(*found, "gRPC on " + text(target.grpc) + " and http://" + text(target.http) +
                          "/healthz are serving");
}

TEST(HealthProbe, is_unhealthy_when_ticks_hang_or_server_drains) {
    FakeServer doors;
    const std::string grpc = "gRPC on " + text(doors.target().grpc) + ": ";
    doors.become_unhealthy();
    EXPECT_EQ(error_of(doors.target()), grpc + "NOT_SERVING");
    doors.drain();
    EXPECT_THAT(error_of(doors.target()), StartsWith(grpc));
}

TEST(HealthProbe, closed_port_fails_immediately) {
    HealthTarget target = FakeServer().target();  // stopped again
    const auto began = Clock::now();
    EXPECT_THAT(error_of(target), HasSubstr("gRPC on " + text(target.grpc)));
    EXPECT_LT(Clock::now() - began, 1s);

    const FakeServer doors;
    target.grpc = doors.target().grpc;
    EXPECT_THAT(error_of(target),
                HasSubstr("http://" + text(target.http) + "/healthz: Connection refused"));
}

// Like a process that is stopped or hangs: the kernel still accepts the connection.
TEST(HealthProbe, unresponsive_port_fails_after_the_timeout) {
    const FakeServer doors;
    const Answer mute("");
    const HealthTarget mute_grpc{.grpc = mute.address(), .http = doors.target().http};
    const HealthTarget mute_http{.grpc = doors.target().grpc, .http = mute.address()};
    for (const HealthTarget& target : {mute_grpc, mute_http}) {
        const auto began = Clock::now();
        EXPECT_FALSE(probe_health(target, 300ms).ok());
        EXPECT_GE(Clock::now() - began, 250ms);
        EXPECT_LT(Clock::now() - began, 1500ms);
    }
}

TEST(HealthProbe, reports_unexpected_http_responses) {
    const FakeServer doors;
    const auto error = [&](std::string answer) {
        const Answer door(std::move(answer));
        return error_of({.grpc = doors.target().grpc, .http = door.address()});
    };
    EXPECT_THAT(error("HTTP/1.1 503 No\r\nContent-Length: 0\r\n\r\n"), HasSubstr("status 503"));
    EXPECT_THAT(error("SSH-2.0-OpenSSH_9.2\r\n"), HasSubstr("the response is not HTTP/1.1"));
    EXPECT_THAT(error("HTTP/1.1 200 OK\r\nX: " + std::string(20'000, 'x')),
                HasSubstr("larger than 16 KiB"));
    EXPECT_THAT(error("HTTP/1.1 200"), HasSubstr("not complete"));
}

TEST(HealthProbe, probes_wildcard_listeners_on_loopback) {
    Config config;
    config.listen = "0.0.0.0:50051";
    config.http = "[::]:8080";
    const Result<HealthTarget> target = health_target(config);
    ASSERT_TRUE(target.ok());
    EXPECT_EQ(text(target->grpc), "127.0.0.1:50051");
    EXPECT_EQ(text(target->http), "::1:8080");

    config.http = "127.0.0.1:0";
    EXPECT_THAT(health_target(config).error().message, HasSubstr("http: 127.0.0.1:0 has port 0"));
    config.http = "127.0.0.1:8080";
    config.tls.certificate = "/nowhere/tls.crt";
    EXPECT_EQ(health_target(config).error().message,
              "tls.certificate: cannot read /nowhere/tls.crt; must be a readable PEM file");
    config.tls.certificate.clear();
    config.trusted_proxies = {"127.0.0.1"};
    EXPECT_TRUE(health_target(config).ok());
    config.proxy_protocol = {"http"};
    EXPECT_THAT(health_target(config).error().message, HasSubstr("to the http port must begin"));
    config.trusted_proxies = {"10.0.0.1"};
    EXPECT_TRUE(health_target(config).ok()) << "this machine is no proxy";
}

// gRPC's health service, serving.
class Serving final : public grpc::health::v1::Health::Service {
    grpc::Status Check(grpc::ServerContext*, const grpc::health::v1::HealthCheckRequest*,
                       grpc::health::v1::HealthCheckResponse* response) override {
        response->set_status(grpc::health::v1::HealthCheckResponse::SERVING);
        return grpc::Status::OK;
    }
};

// The certificate is self-signed and has expired. A restart of the server, which a failed probe
// causes, would repair neither.
TEST(HealthProbe, probes_tls_listeners) {
    const test::TestCertificate certificate =
        test::make_certificate({.name = "play.example.org", .ends_in_s = -10});
    Serving service;
    grpc::SslServerCredentialsOptions options;
    options.pem_key_cert_pairs.push_back({certificate.key_pem(), certificate.pem()});
    int port = 0;
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::SslServerCredentials(options), &port);
    builder.RegisterService(&service);
    const auto grpc = builder.BuildAndStart();

    asio::ssl::context tls(asio::ssl::context::tls_server);
    tls.use_private_key(asio::buffer(certificate.key_pem()), asio::ssl::context::pem);
    tls.use_certificate_chain(asio::buffer(certificate.pem()));
    const Answer http("HTTP/1.1 200 OK\r\nContent-Length: 3\r\n\r\nok\n", &tls);

    const HealthTarget target{.grpc = {"127.0.0.1", static_cast<std::uint16_t>(port)},
                              .http = http.address(),
                              .certificates = certificate.pem()};
    const Result<std::string> found = probe_health(target, 2s);
    ASSERT_TRUE(found.ok()) << found.error().message;
    EXPECT_THAT(*found, HasSubstr("https://" + text(http.address())));

    // The same listeners probed in plain text.
    HealthTarget plain = target;
    plain.certificates.clear();
    EXPECT_THAT(error_of(plain), HasSubstr("gRPC on"));
}

}  // namespace
}  // namespace jostle::server
