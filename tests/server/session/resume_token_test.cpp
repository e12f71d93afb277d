// SPDX-License-Identifier: MIT
#include "server/session/resume_token.h"

#include <gtest/gtest.h>

#include "server/messages/client_message.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

const std::string secret(32, 's');
const WallTime noon{std::chrono::seconds(1'800'000'000)};

ResumeToken somebody() {
    return {.client = 70000,
            .world = "w3-ab12cd34",
            .subject = "ada@example.org",
            .by_ticket = true,
            .spectator = false,
            .expires = noon + 24h};
}

TEST(ResumeToken, says_after_a_restart_who_it_was_made_for) {
    const auto sealed = seal_token(somebody(), secret);
    ASSERT_TRUE(sealed.has_value());
    EXPECT_LE(sealed->size(), 80u);
    EXPECT_EQ(open_token(*sealed, secret, noon), somebody());
    EXPECT_EQ(open_token(*sealed, secret, noon + 24h), std::nullopt) << "it has expired";
    EXPECT_EQ(open_token(*sealed, std::string(32, 't'), noon), std::nullopt);
}

TEST(ResumeToken, no_changed_byte_is_taken_for_the_same_or_for_somebody_else) {
    const std::string sealed = *seal_token(somebody(), secret);
    for (std::size_t at = 0; at < sealed.size(); at++)
        for (int bit = 0; bit < 8; bit++) {
            std::string changed = sealed;
            changed[at] = static_cast<char>(changed[at] ^ (1 << bit));
            EXPECT_EQ(open_token(changed, secret, noon), std::nullopt) << "byte " << at;
        }
    for (std::size_t size = 0; size < sealed.size(); size++)
        EXPECT_EQ(open_token(sealed.substr(0, size), secret, noon), std::nullopt);
}

TEST(ResumeToken, is_never_longer_than_what_a_client_may_send_back) {
    ResumeToken token = somebody();
    token.subject.assign(resume_token_bytes_max, 'x');
    EXPECT_EQ(seal_token(token, secret), std::nullopt);
}

}  // namespace
}  // namespace jostle::server
