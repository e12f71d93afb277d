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
            .ticket = std::string(16, 't'),
            .key = std::string(16, 'k'),
            .spectator = true,
            .expires = noon + 24h,
            .token_expires = noon + 1h};
}

TEST(ResumeToken, identifies_the_client_after_a_restart) {
    const auto sealed = seal_token(somebody(), secret);
    ASSERT_TRUE(sealed.has_value());
    EXPECT_LE(sealed->size(), 120u);
    EXPECT_EQ(open_token(*sealed, secret, noon), somebody());
    EXPECT_EQ(open_token(*sealed, secret, noon + 24h), std::nullopt) << "it has expired";
    EXPECT_EQ(open_token(*sealed, std::string(32, 't'), noon), std::nullopt);
}

TEST(ResumeToken, rejects_any_changed_byte) {
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

TEST(ResumeToken, fits_the_client_token_limit) {
    ResumeToken token = somebody();
    token.subject.assign(resume_token_bytes_max, 'x');
    EXPECT_EQ(seal_token(token, secret), std::nullopt);
}

}  // namespace
}  // namespace jostle::server
