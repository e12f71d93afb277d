// SPDX-License-Identifier: MIT
#include "server/app/health_probe.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <spdlog/fmt/fmt.h>

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>

#include "grpc/health/v1/health.grpc.pb.h"
#include "server/util/clock.h"

namespace jostle::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace health = grpc::health::v1;
using asio::ip::tcp;

// Below the timeout of supervisors (3 s and more), so that the probe reports the cause itself.
constexpr auto probe_timeout = std::chrono::milliseconds(2500);

std::string text_of(const HostPort& address) {
    const bool is_ipv6 = address.host.find(':') != std::string::npos;
    return is_ipv6 ? fmt::format("[{}]:{}", address.host, address.port)
                   : fmt::format("{}:{}", address.host, address.port);
}

Result<HostPort> reachable(const char* setting, const std::string& address) {
    Result<HostPort> parsed = parse_host_port(address);
    if (!parsed.ok()) return parsed;
    if (parsed->port == 0)
        return Error{ErrorCode::invalid_argument,
                     fmt::format("{}: {} has port 0, which stands for any free port; set the port "
                                 "that the server wrote to its port file",
                                 setting, address)};
    if (parsed->host == "0.0.0.0") parsed->host = "127.0.0.1";
    if (parsed->host == "::") parsed->host = "::1";
    return parsed;
}

std::shared_ptr<grpc::ChannelCredentials> credentials(const std::string& certificates) {
    if (certificates.empty()) return grpc::InsecureChannelCredentials();
    grpc::experimental::TlsChannelCredentialsOptions options;
    // gRPC requires root certificates even without verification, and a container image may have
    // none.
    options.set_certificate_provider(
        std::make_shared<grpc::experimental::StaticDataCertificateProvider>(certificates));
    options.watch_root_certs();
    options.set_verify_server_certs(false);
    options.set_check_call_host(false);
    options.set_certificate_verifier(
        std::make_shared<grpc::experimental::NoOpCertificateVerifier>());
    return grpc::experimental::TlsCredentials(options);
}

// Returns the failure of the gRPC health service, or nothing.
std::optional<std::string> probe_grpc(const HealthTarget& target,
                                      std::chrono::milliseconds timeout) {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);  // the server runs on this machine
    const auto stub = health::Health::NewStub(grpc::CreateCustomChannel(
        text_of(target.grpc), credentials(target.certificates), arguments));
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + timeout);
    health::HealthCheckResponse response;
    const grpc::Status status = stub->Check(&context, {}, &response);
    if (!status.ok()) return status.error_message();
    if (response.status() == health::HealthCheckResponse::SERVING) return {};
    return health::HealthCheckResponse::ServingStatus_Name(response.status());
}

template <class Stream>
asio::awaitable<http::status> get_healthz(Stream& stream, const std::string& host) {
    http::request<http::empty_body> request(http::verb::get, "/healthz", 11);
    request.set(http::field::host, host);
    request.set(http::field::connection, "close");
    co_await http::async_write(stream, request, asio::use_awaitable);
    beast::flat_buffer buffer(std::size_t{16} << 10);
    http::response_parser<http::empty_body> parser;
    co_await http::async_read_header(stream, buffer, parser, asio::use_awaitable);
    co_return parser.get().result();
}

asio::awaitable<http::status> request_healthz(asio::io_context& io, const HealthTarget& target) {
    tcp::resolver resolver(io);
    const auto addresses = co_await resolver.async_resolve(
        target.http.host, std::to_string(target.http.port), asio::use_awaitable);
    const std::string host = text_of(target.http);
    if (target.certificates.empty()) {
        beast::tcp_stream stream(io);
        co_await stream.async_connect(addresses, asio::use_awaitable);
        co_return co_await get_healthz(stream, host);
    }
    asio::ssl::context tls(asio::ssl::context::tls_client);
    tls.set_verify_mode(asio::ssl::verify_none);
    beast::ssl_stream<beast::tcp_stream> stream(io, tls);
    co_await beast::get_lowest_layer(stream).async_connect(addresses, asio::use_awaitable);
    co_await stream.async_handshake(asio::ssl::stream_base::client, asio::use_awaitable);
    co_return co_await get_healthz(stream, host);
}

// Returns the failure of /healthz, or nothing.
std::optional<std::string> probe_http(const HealthTarget& target,
                                      std::chrono::milliseconds timeout) {
    asio::io_context io;
    std::optional<std::string> fault = fmt::format("no response within {} ms", timeout.count());
    asio::co_spawn(io, request_healthz(io, target),
                   [&](const std::exception_ptr& failure, http::status status) {
                       // Asio coroutines report socket errors as exceptions.
                       try {
                           if (failure) std::rethrow_exception(failure);
                           fault.reset();
                           if (status != http::status::ok)
                               fault = fmt::format("status {}; expected 200",
                                                   static_cast<unsigned>(status));
                       } catch (const std::exception& error) {
                           fault = error.what();
                       }
                   });
    io.run_for(timeout);
    return fault;
}

}  // namespace

Result<HealthTarget> health_target(const Config& config) {
    const Result<HostPort> grpc = reachable("listen", config.listen);
    if (!grpc.ok()) return grpc.error();
    const Result<HostPort> http = reachable("http", config.http);
    if (!http.ok()) return http.error();
    HealthTarget target{.grpc = *grpc, .http = *http};
    if (config.tls.certificate.empty()) return target;
    std::ifstream file(config.tls.certificate, std::ios::binary);
    target.certificates.assign(std::istreambuf_iterator<char>(file), {});
    if (target.certificates.empty())
        return Error{ErrorCode::not_found, "tls.certificate: cannot read " +
                                               config.tls.certificate +
                                               "; must be a readable PEM file"};
    return target;
}

Result<std::string> probe_health(const HealthTarget& target, std::chrono::milliseconds timeout) {
    const auto deadline = Clock::now() + timeout;
    const auto left = [&] {
        return std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    };
    const std::string grpc = text_of(target.grpc);
    const std::string http = fmt::format(
        "{}://{}/healthz", target.certificates.empty() ? "http" : "https", text_of(target.http));
    if (const auto fault = probe_grpc(target, left()))
        return Error{ErrorCode::unavailable, fmt::format("gRPC on {}: {}", grpc, *fault)};
    if (const auto fault = probe_http(target, left()))
        return Error{ErrorCode::unavailable, fmt::format("{}: {}", http, *fault)};
    return fmt::format("gRPC on {} and {} are serving", grpc, http);
}

int run_health_probe(const Config& config) {
    const Result<HealthTarget> target = health_target(config);
    const Result<std::string> result =
        target.ok() ? probe_health(*target, probe_timeout) : target.error();
    if (result.ok())
        std::printf("healthy: %s\n", result->c_str());
    else
        std::printf("not healthy: %s\n", result.error().message.c_str());
    return result.ok() ? 0 : 1;
}

}  // namespace jostle::server
