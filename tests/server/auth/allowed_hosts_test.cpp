// SPDX-License-Identifier: MIT
#include "server/auth/allowed_hosts.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(AllowedHosts, accepts_ip_addresses_localhost_and_listed_names_only) {
    const std::vector<std::string> none, some = {"play.example.org"}, all = {"*"};
    for (const char* host : {"127.0.0.1:8080", "192.0.2.7", "[::1]:8080", "[2001:db8::1]",
                             "localhost", "LocalHost:8080", ""})
        EXPECT_TRUE(host_is_allowed(host, none)) << host;
    for (const char* host : {"rebound.example.net:8080", "play.example.org", "localhost.evil.org",
                             "127.0.0.1.evil.org", "evil.org#localhost", "[evil", "[evil]:1", ":80",
                             "1.2.3", "localhost/"})
        EXPECT_FALSE(host_is_allowed(host, none)) << host;
    for (const char* host : {"play.example.org", "Play.Example.Org:443", "play.example.org.:443"})
        EXPECT_TRUE(host_is_allowed(host, some)) << host;
    EXPECT_FALSE(host_is_allowed("evil.play.example.org", some));
    EXPECT_FALSE(host_is_allowed("play.example.org.evil.net", some));
    EXPECT_TRUE(host_is_allowed("anything:1", all));
}

}  // namespace
}  // namespace jostle::server
