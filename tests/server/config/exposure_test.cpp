// SPDX-License-Identifier: MIT
#include "server/config/exposure.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using test::error_of;

Config with_tls_and_tokens() {
    Config config;
    config.tls = {.certificate = "chain.pem", .key = "key.pem"};
    config.auth = {.issuer = "i", .audience = "a", .keys = "keys.json"};
    return config;
}

TEST(Exposure, detects_loopback_addresses) {
    for (const char* host : {"localhost", "127.0.0.1", "127.8.9.10", "::1"})
        EXPECT_TRUE(is_loopback(host)) << host;
    for (const char* host : {"0.0.0.0", "::", "192.0.2.1", "127.0.0.1.example.org", "127.1", "",
                             "localhost.example.org", "::ffff:192.0.2.1"})
        EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(Exposure, non_loopback_listeners_require_tls_and_tokens_or_insecure) {
    EXPECT_TRUE(check_exposure({}).ok()) << "loopback addresses need no protection";
    for (std::string Config::*listener : {&Config::listen, &Config::http, &Config::admin}) {
        Config config;
        config.*listener = "0.0.0.0:50051";
        EXPECT_FALSE(check_exposure(config).ok());
        config.insecure = true;
        EXPECT_TRUE(check_exposure(config).ok());
        config = with_tls_and_tokens();
        config.*listener = "[::]:50051";
        EXPECT_TRUE(check_exposure(config).ok());
        config.auth.keys.clear();
        EXPECT_FALSE(check_exposure(config).ok()) << "TLS without authentication is not sufficient";
        config = with_tls_and_tokens();
        config.*listener = "0.0.0.0:50051";
        config.tls = {};
        EXPECT_FALSE(check_exposure(config).ok()) << "authentication without TLS is not sufficient";
    }
}

TEST(Exposure, datagram_port_has_the_same_requirements) {
    Config config;
    config.datagrams.listen = "0.0.0.0:50052";
    EXPECT_NE(error_of(check_exposure(config)).message.find("datagrams.listen is 0.0.0.0:50052"),
              std::string::npos);
    config.datagrams.listen = "127.0.0.1:50052";
    EXPECT_TRUE(check_exposure(config).ok());
}

TEST(Exposure, error_explains_how_to_fix_exposure) {
    Config config;
    config.http = "0.0.0.0:8080";
    const Error error = error_of(check_exposure(config));
    EXPECT_EQ(error.code, ErrorCode::failed_precondition);
    EXPECT_EQ(error.message,
              "http is 0.0.0.0:8080, which other machines can reach, without tls.certificate and "
              "tls.key, and auth.keys, auth.issuer and auth.audience; set them "
              "(docs/guides/operator/secure.md), "
              "listen on 127.0.0.1, or set insecure = true if a proxy in front of this server "
              "provides both");
}

TEST(Exposure, anonymous_role_depends_on_exposure) {
    Config config;
    EXPECT_EQ(anonymous_role(config), "admin");
    config.listen = "0.0.0.0:50051";
    EXPECT_EQ(anonymous_role(config), "director");
    EXPECT_EQ(anonymous_role(with_tls_and_tokens()), "none");
    config.auth.anonymous_role = "viewer";
    EXPECT_EQ(anonymous_role(config), "viewer");
}

// A proxy on the same machine connects clients of other machines to a loopback listener.
TEST(Exposure, trusted_proxies_expose_loopback_listeners) {
    Config config;
    config.trusted_proxies = {"127.0.0.1"};
    EXPECT_EQ(anonymous_role(config), "director");
    EXPECT_NE(error_of(check_exposure(config)).message.find("trusted_proxies is set"),
              std::string::npos);
    config.auth.anonymous_role = "player";
    EXPECT_TRUE(check_exposure(config).ok()) << "the proxy may terminate TLS";
    config.auth.anonymous_role.clear();
    config.insecure = true;
    EXPECT_TRUE(check_exposure(config).ok());
}

TEST(Config, rejects_contradictory_access_settings) {
    const auto fault_of = [](auto change) {
        Config config = with_tls_and_tokens();
        change(config);
        const Status status = check(config);
        return status.ok() ? "" : status.error().message;
    };
    EXPECT_EQ(fault_of([](Config&) {}), "");
    EXPECT_EQ(fault_of([](Config& c) { c.tls.key.clear(); }),
              "tls.certificate and tls.key belong together; set both or neither");
    EXPECT_EQ(fault_of([](Config& c) { c.tls = {.client_ca = "ca.pem"}; }),
              "tls.client_ca is set without tls.certificate and tls.key");
    EXPECT_EQ(
        fault_of([](Config& c) { c.auth.audience.clear(); }),
        "auth.keys is set without auth.issuer and auth.audience; set both to the expected claims");
    EXPECT_EQ(
        fault_of([](Config& c) { c.auth.anonymous_role = "root"; }),
        "auth.anonymous_role is \"root\"; it must be none, viewer, player, director or admin");
    EXPECT_EQ(
        fault_of([](Config& c) { c.allowed_hosts = {"https://play.example.org"}; }),
        "allowed_hosts: \"https://play.example.org\" is not a host name; write only the name, such "
        "as play.example.org");
    EXPECT_EQ(
        fault_of([](Config& c) { c.allowed_origins = {"play.example.org"}; }),
        "allowed_origins: \"play.example.org\" is not an origin; write scheme and host without "
        "a path, such as https://play.example.org");
    EXPECT_EQ(fault_of([](Config& c) { c.trusted_proxies = {"10.0.0.1/8"}; }).substr(0, 60),
              "trusted_proxies: \"10.0.0.1/8\" is not a network: the address ");
    EXPECT_EQ(fault_of([](Config& c) { c.forwarded_header = "x-real-ip"; }),
              "forwarded_header is \"x-real-ip\"; it must be x-forwarded-for or forwarded");
    EXPECT_EQ(fault_of([](Config& c) {
                  c.trusted_proxies = {"10.0.0.1"};
                  c.proxy_protocol = {"admin"};
              }),
              "proxy_protocol: \"admin\" is not a port; the list may contain grpc and http");
    EXPECT_EQ(fault_of([](Config& c) { c.proxy_protocol = {"http"}; }),
              "proxy_protocol is set without trusted_proxies; list the addresses of the proxies");
    EXPECT_EQ(fault_of([](Config& c) { c.auth.leeway_seconds = 301; }),
              "auth.leeway_seconds is 301; it must be from 0 to 300");
    EXPECT_EQ(fault_of([](Config& c) { c.quota.joins_per_minute = 0; }),
              "quota.joins_per_minute is 0; it must be from 1 to 1000000");
}

}  // namespace
}  // namespace jostle::server
