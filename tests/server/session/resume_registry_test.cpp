// SPDX-License-Identifier: MIT
#include "server/session/resume_registry.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/server/session/session_start.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using ClaimStatus = ResumeRegistry::ClaimStatus;

DisconnectedClient lost(ClientId client, std::string network = "192.0.2.7") {
    DisconnectedClient out;
    out.client = client;
    out.network = std::move(network);
    return out;
}

TEST(ResumeRegistry, tokens_are_16_bytes_and_unique) {
    ResumeRegistry desk;
    std::set<std::string> tokens;
    for (ClientId client = 1; client <= 1000; client++) tokens.insert(desk.open(client)->token);
    EXPECT_EQ(tokens.size(), 1000u);
    for (const std::string& token : tokens) EXPECT_EQ(token.size(), 16u);
}

TEST(ResumeRegistry, token_restores_suspended_state_once) {
    ResumeRegistry desk;
    const auto resume_session = desk.open(7);
    desk.suspend(*resume_session, lost(7), start + 30s);
    EXPECT_EQ(desk.claim("no token").status, ClaimStatus::unknown);
    EXPECT_EQ(desk.claim({}).status, ClaimStatus::unknown);
    const ResumeRegistry::Claim claim = desk.claim(resume_session->token);
    ASSERT_EQ(claim.status, ClaimStatus::claimed);
    EXPECT_EQ(claim.client->client, 7u);
    EXPECT_EQ(claim.resume_session, resume_session);
    EXPECT_EQ(claim.until, start + 30s);
    EXPECT_EQ(desk.claim(resume_session->token).status, ClaimStatus::pending)
        << "he has his place now";
    EXPECT_TRUE(desk.take_expired(start + 60s).empty()) << "and does not lose it";
    desk.close(*resume_session);
    EXPECT_EQ(desk.claim(resume_session->token).status, ClaimStatus::unknown);
}

TEST(ResumeRegistry, claim_supersedes_the_old_session) {
    ResumeRegistry desk;
    const auto resume_session = desk.open(7);
    EXPECT_FALSE(resume_session->is_superseded);
    EXPECT_EQ(desk.claim(resume_session->token).status, ClaimStatus::pending);
    EXPECT_TRUE(resume_session->is_superseded);
    desk.suspend(*resume_session, lost(7), start + 30s);
    EXPECT_EQ(desk.claim(resume_session->token).status, ClaimStatus::claimed);
    EXPECT_FALSE(resume_session->is_superseded) << "the new one keeps it";
}

TEST(ResumeRegistry, sessions_expire_and_the_oldest_of_a_network_is_evicted_first) {
    ResumeRegistry desk;
    const auto a = desk.open(1), b = desk.open(2), c = desk.open(3);
    desk.suspend(*a, lost(1, "192.0.2.1"), start + 10s);
    desk.suspend(*b, lost(2, "192.0.2.2"), start + 20s);
    desk.suspend(*c, lost(3, "192.0.2.2"), start + 30s);
    EXPECT_EQ(desk.disconnected(), 3u);
    EXPECT_EQ(desk.take_oldest("192.0.2.2")->client, 2u);
    EXPECT_FALSE(desk.take_oldest("192.0.2.9"));
    EXPECT_TRUE(desk.take_expired(start + 9s).empty());
    const auto expired = desk.take_expired(start + 10s);
    ASSERT_EQ(expired.size(), 1u);
    EXPECT_EQ(expired[0].client, 1u);
    EXPECT_EQ(desk.claim(a->token).status, ClaimStatus::unknown);
    EXPECT_EQ(desk.take_oldest({})->client, 3u);
    EXPECT_EQ(desk.disconnected(), 0u);
}

}  // namespace
}  // namespace jostle::server
