// SPDX-License-Identifier: MIT
//
// Tokens: as a stranger wrote them, or, when the first byte is odd, a header and claims (a line
// each) that are signed here with a key that is believed, which no fuzzer guesses.
#include "server/auth/json_web_token.h"

#include "server/auth/key_set.h"
#include "tests/fuzz/target.h"
#include "tests/support/tokens.h"

namespace jostle::fuzz {

namespace {

using test::LoginService;

struct Verifier {
    LoginService login;
    server::VerifyKeys keys = server::read_key_set(login.published()).value().keys;
    server::TokenRules rules{.issuer = LoginService::issuer, .audience = LoginService::audience};
};

std::string signed_token(std::string_view text, const LoginService& login) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string header(text.substr(0, end)),
        claims(text.substr(std::min(end + 1, text.size())));
    return test::assemble(header, claims,
                          [&](const std::string& all) { return login.key.sign(all); });
}

}  // namespace

void run(Bytes input) {
    static const Verifier verifier;
    if (input.empty()) return;
    const std::string_view text = text_of(input.subspan(1));
    const std::string token =
        input[0] % 2 == 1 ? signed_token(text, verifier.login) : std::string(text);
    const server::WallTime now(std::chrono::seconds(1'790'000'000));
    const auto who = server::verify_token(token, verifier.keys, verifier.rules, now);
    if (!who.ok()) {
        expect(who.error().code == ErrorCode::unauthenticated, "a bad token is unauthenticated");
        return expect(!who.error().message.empty(), "a refusal has a reason");
    }
    expect(!who->subject.empty() && who->subject.size() <= server::subject_bytes_max,
           "a token says who it is for");
    expect(who->expires > now &&
               who->expires <= now + server::token_life_max + 2 * verifier.rules.leeway,
           "a token is good for a day at most");
}

}  // namespace jostle::fuzz
