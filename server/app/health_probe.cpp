// SPDX-License-Identifier: MIT
#include "server/app/health_probe.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <poll.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "grpc/health/v1/health.grpc.pb.h"
#include "server/forwarding/trusted_proxies.h"
#include "server/util/clock.h"
#include "server/util/free_with.h"

namespace jostle::server {
namespace {

namespace health = grpc::health::v1;

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

using ConnectBio = std::unique_ptr<BIO, FreeWith<BIO_free_all>>;
using TlsContext = std::unique_ptr<SSL_CTX, FreeWith<SSL_CTX_free>>;

// Repeats a call on a non-blocking BIO until it succeeds. Returns whether it did before the
// deadline.
template <class Call>
bool complete(BIO* bio, Clock::time_point deadline, Call&& call) {
    while (call() <= 0) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        if (!BIO_should_retry(bio) || left.count() <= 0) return false;
        // A connecting socket becomes writable, and a handshake waits for both directions in turn.
        const short events = BIO_should_read(bio) ? POLLIN : POLLOUT;
        pollfd wait{.fd = static_cast<int>(BIO_get_fd(bio, nullptr)), .events = events};
        poll(&wait, 1, static_cast<int>(left.count()));
    }
    return true;
}

// The reason why a call failed, from the error queue of OpenSSL or from the system.
std::string failure_text(int system_error) {
    const unsigned long error = ERR_peek_error();
    if (ERR_SYSTEM_ERROR(error)) system_error = ERR_GET_REASON(error);
    if (error != 0 && !ERR_SYSTEM_ERROR(error)) {
        const char* reason = ERR_reason_error_string(error);
        return reason ? reason : "unknown TLS error";
    }
    if (system_error != 0) return std::generic_category().message(system_error);
    return "the connection was closed";
}

// Checks the head of a response. Returns its fault, or nothing.
std::optional<std::string> head_fault(std::string_view head) {
    constexpr std::string_view version = "HTTP/1.1 ";
    if (!head.starts_with(version)) return "the response is not HTTP/1.1";
    const std::string_view status = head.substr(version.size(), 3);
    if (status == "200") return {};
    return fmt::format("status {}; expected 200", status);
}

// Returns the failure of /healthz, or nothing.
std::optional<std::string> probe_http(const HealthTarget& target,
                                      std::chrono::milliseconds timeout) {
    constexpr std::size_t head_max = std::size_t{16} << 10;
    const Clock::time_point deadline = Clock::now() + timeout;
    const bool has_tls = !target.certificates.empty();
    const TlsContext tls(has_tls ? SSL_CTX_new(TLS_client_method()) : nullptr);
    const ConnectBio bio(has_tls ? BIO_new_ssl_connect(tls.get()) : BIO_new(BIO_s_connect()));
    if (!bio) return "out of memory";
    const std::string host = text_of(target.http);
    BIO_set_conn_hostname(bio.get(), host.c_str());
    BIO_set_nbio(bio.get(), 1);
    const auto failure = [&]() -> std::string {
        const int cause = errno;
        if (Clock::now() >= deadline)
            return fmt::format("no response within {} ms", timeout.count());
        return failure_text(cause);
    };
    ERR_clear_error();
    errno = 0;
    if (!complete(bio.get(), deadline, [&] { return BIO_do_connect(bio.get()); })) return failure();
    const std::string request =
        fmt::format("GET /healthz HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", host);
    const auto size = static_cast<int>(request.size());
    if (!complete(bio.get(), deadline, [&] { return BIO_write(bio.get(), request.data(), size); }))
        return failure();
    std::string head;
    while (head.find("\r\n\r\n") == std::string::npos) {
        if (head.size() > head_max) return "the head of the response is larger than 16 KiB";
        std::array<char, 4096> bytes;
        int count = 0;
        errno = 0;
        if (!complete(bio.get(), deadline, [&] {
                return count = BIO_read(bio.get(), bytes.data(), static_cast<int>(bytes.size()));
            })) {
            if (count != 0 || head.empty()) return failure();
            return head_fault(head).value_or("the head of the response is not complete");
        }
        head.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return head_fault(head);
}

}  // namespace

Result<HealthTarget> health_target(const Config& config) {
    const Result<HostPort> grpc = reachable("listen", config.listen);
    if (!grpc.ok()) return grpc.error();
    const Result<HostPort> http = reachable("http", config.http);
    if (!http.ok()) return http.error();
    const auto proxies = TrustedProxies::create(config.trusted_proxies, {});
    if (!proxies.ok()) return proxies.error();
    for (const auto& [port, address] : {std::pair("grpc", *grpc), std::pair("http", *http)})
        if (std::ranges::find(config.proxy_protocol, port) != config.proxy_protocol.end() &&
            proxies->contains(address.host))
            return Error{
                ErrorCode::failed_precondition,
                fmt::format("proxy_protocol: connections from {} to the {} port must begin "
                            "with a PROXY header, which this probe does not send; query "
                            "/healthz of the admin port instead",
                            address.host, port)};
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
    // A listener that closes the connection is a result of the probe, not the end of it.
    std::signal(SIGPIPE, SIG_IGN);
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
