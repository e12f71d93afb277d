// SPDX-License-Identifier: MIT
#include "server/auth/json_web_token.h"

#include <gtest/gtest.h>
#include <openssl/hmac.h>

#include <set>

#include "server/auth/key_set.h"
#include "tests/support/tokens.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::Json;
using test::LoginService;

const WallTime now = WallTime(1'790'000'000s);

class JsonWebToken : public testing::Test {
protected:
    Result<Identity> verify(const std::string& token, WallTime at = now) const {
        return verify_token(token, keys, rules, at);
    }
    // The reason why a token with these claims is rejected; "" if it is valid. Members that are
    // null are omitted.
    std::string fault_with(const Json& changes, WallTime at = now) const {
        Json claims = LoginService::claims("anna", "player", now);
        claims.update(changes);
        for (const auto& [name, value] : changes.items())
            if (value.is_null()) claims.erase(name);
        return fault_of(login.token(claims), at);
    }
    std::string fault_of(const std::string& token, WallTime at = now) const {
        const Result<Identity> who = verify(token, at);
        if (who.ok()) return "";
        EXPECT_EQ(who.error().code, ErrorCode::unauthenticated);
        return who.error().message;
    }

    LoginService login;
    VerifyKeys keys = read_key_set(login.published()).value().keys;
    TokenRules rules{.issuer = LoginService::issuer, .audience = LoginService::audience};
    const std::int64_t seconds = std::chrono::system_clock::to_time_t(now);
    Json good = LoginService::claims("anna", "player", now);
};

TEST_F(JsonWebToken, returns_subject_and_expiry) {
    good["jti"] = "t-17";
    good["world"] = "arena";
    const Result<Identity> who = verify(login.token(good));
    ASSERT_TRUE(who.ok()) << who.error().message;
    EXPECT_EQ(who->subject, "anna");
    EXPECT_EQ(who->role, Role::player);
    EXPECT_FALSE(who->anonymous);
    EXPECT_EQ(who->token_id, "t-17");
    EXPECT_EQ(who->worlds, std::vector<std::string>{"arena"});
    EXPECT_EQ(who->expires, now + 1h + 30s) << "1 h plus the leeway";
}

TEST_F(JsonWebToken, accepts_audience_list_containing_ours) {
    EXPECT_EQ(fault_with({{"aud", {"billing", "jostle"}}}), "");
    EXPECT_NE(fault_with({{"aud", {"billing", "mail"}}}), "");
    EXPECT_NE(fault_with({{"aud", {"jostle", 7}}}), "") << "aud must be an array of strings";
    EXPECT_NE(fault_with({{"aud", Json::array()}}), "");
    EXPECT_NE(fault_with({{"aud", std::vector<std::string>(33, "jostle")}}), "");
}

TEST_F(JsonWebToken, error_names_missing_claim) {
    EXPECT_EQ(fault_with({{"iss", nullptr}}), "the token has no issuer (iss)");
    EXPECT_EQ(fault_with({{"aud", nullptr}}), "the token has no audience (aud)");
    EXPECT_EQ(fault_with({{"sub", nullptr}}), "the token has no subject (sub)");
    EXPECT_EQ(fault_with({{"exp", nullptr}}), "the token has no expiry time (exp)");
    EXPECT_EQ(fault_with({{"role", nullptr}}),
              "the token's role is not viewer, player, director or admin");
    EXPECT_EQ(fault_with({{"iat", nullptr}}), "") << "iat is not required";
}

TEST_F(JsonWebToken, enforces_expiry_with_30_seconds_of_leeway) {
    EXPECT_EQ(fault_with(Json::object(), now + 3629s), "");
    EXPECT_EQ(fault_with(Json::object(), now + 3630s), "the token has expired");
    rules.leeway = 0s;
    EXPECT_EQ(fault_with(Json::object(), now + 3599s), "");
    EXPECT_EQ(fault_with(Json::object(), now + 3600s), "the token has expired");
}

TEST_F(JsonWebToken, rejects_lifetimes_over_one_day) {
    constexpr std::int64_t day = 86400;
    EXPECT_EQ(fault_with({{"exp", seconds + day}}), "");
    EXPECT_EQ(fault_with({{"exp", seconds + 25 * 3600}}),
              "the token expires (exp) more than 24 hours from now");
    EXPECT_EQ(fault_with({{"exp", seconds + 25 * 3600}, {"iat", nullptr}}),
              "the token expires (exp) more than 24 hours from now");
    EXPECT_EQ(fault_with({{"iat", seconds - 5 * 3600}, {"exp", seconds + 20 * 3600}}),
              "the token is valid for more than 24 hours (iat to exp)");
}

TEST_F(JsonWebToken, rejects_tokens_before_nbf) {
    EXPECT_EQ(fault_with({{"nbf", seconds + 30}}), "");
    EXPECT_EQ(fault_with({{"nbf", seconds + 31}}), "the token is not valid yet (nbf)");
    EXPECT_EQ(fault_with({{"iat", seconds + 31}}), "the token was issued (iat) in the future");
    EXPECT_EQ(fault_with({{"nbf", seconds + 31}}, now + 1s), "");
}

TEST_F(JsonWebToken, rejects_invalid_timestamps) {
    for (const Json& time :
         {Json("soon"), Json(-1), Json(1e300), Json(true), Json::array({1}), Json(253402300799)})
        EXPECT_EQ(fault_with({{"exp", time}}),
                  "the token's exp is not a time in seconds since 1970");
    EXPECT_EQ(fault_with({{"exp", static_cast<double>(seconds) + 60.5}}), "");
}

TEST_F(JsonWebToken, rejects_wrong_issuer_and_audience) {
    EXPECT_EQ(fault_with({{"iss", "https://login.example.org/"}}),
              "the token is from another issuer (iss)");
    EXPECT_EQ(fault_with({{"aud", "Jostle"}}), "the token is for another audience (aud)");
}

TEST_F(JsonWebToken, rejects_reserved_subjects_and_unknown_roles) {
    EXPECT_NE(fault_with({{"sub", "anonymous"}}), "");
    EXPECT_NE(fault_with({{"sub", "certificate:CN=boss"}}), "");
    EXPECT_NE(fault_with({{"sub", ""}}), "");
    EXPECT_NE(fault_with({{"sub", std::string(129, 'a')}}), "");
    EXPECT_NE(fault_with({{"role", "none"}}), "");
    EXPECT_NE(fault_with({{"role", "Admin"}}), "");
    EXPECT_NE(fault_with({{"role", {"admin"}}}), "");
    EXPECT_NE(fault_with({{"world", 5}}), "");
    EXPECT_NE(fault_with({{"world", ""}}), "") << "an empty name would match any world";
    EXPECT_NE(fault_with({{"world", Json::array()}}), "") << "no world would mean any world";
    EXPECT_NE(fault_with({{"world", Json::array({"arena", 5})}}), "");
    EXPECT_NE(fault_with({{"world", Json::array({"arena", ""})}}), "");
    EXPECT_NE(fault_with({{"world", Json(std::vector<std::string>(33, "arena"))}}), "");
    EXPECT_EQ(fault_with({{"world", Json(std::vector<std::string>(32, "arena"))}}), "");
}

// Names reach logs, terminals and the list of clients.
TEST_F(JsonWebToken, rejects_control_characters_in_names) {
    const std::string nul("a\0b", 3);
    const std::string bad[] = {nul,
                               "a\nb",
                               "a\rb",
                               "a\tb",
                               "\x1b[2J",
                               "a\x7f",
                               "a\xc2\x85",      // U+0085, next line
                               "a\xe2\x80\xa8",  // U+2028, line separator
                               "a\xe2\x80\xae",  // U+202E, right-to-left override
                               "a\xe2\x81\xa6",  // U+2066, left-to-right isolate
                               "\xef\xbb\xbf"
                               "a"};  // U+FEFF, byte order mark
    for (const std::string& name : bad)
        for (const char* claim : {"sub", "jti", "world"}) {
            const std::string fault = fault_with({{claim, name}});
            EXPECT_NE(fault.find("contains a control character"), std::string::npos)
                << claim << ": " << fault;
        }
    for (const char* name : {"J\xc3\xb8rn", "\xe4\xbd\xa0\xe5\xa5\xbd", "a b", "\xf0\x9f\x99\x82"})
        for (const char* claim : {"sub", "jti", "world"})
            EXPECT_EQ(fault_with({{claim, name}}), "") << claim << name;
}

TEST_F(JsonWebToken, rejects_claims_with_byte_order_mark_zero_byte_or_duplicates) {
    const auto sign = [&](const std::string& text) { return login.key.sign(text); };
    const std::string claims = good.dump();
    const auto fault = [&](const std::string& text) {
        return fault_of(test::assemble(login.header().dump(), text, sign));
    };
    EXPECT_EQ(fault(claims), "");
    EXPECT_NE(fault("\xef\xbb\xbf" + claims), "");
    EXPECT_NE(fault(claims + std::string(1, '\0')), "");
    EXPECT_NE(fault(R"({"sub": "eve",)" + claims.substr(1)), "");
    EXPECT_NE(fault(R"({"\u0073ub": "eve",)" + claims.substr(1)), "");
    EXPECT_NE(fault_of(test::assemble("\xef\xbb\xbf" + login.header().dump(), claims, sign)), "");
}

TEST_F(JsonWebToken, rejects_contradicting_times) {
    EXPECT_EQ(fault_with({{"iat", seconds + 20}, {"exp", seconds + 10}}),
              "the token expires (exp) before it was issued (iat)");
    EXPECT_EQ(fault_with({{"nbf", seconds + 20}, {"exp", seconds + 10}}),
              "the token expires (exp) before it is valid (nbf)");
    EXPECT_EQ(fault_with({{"nbf", seconds + 10}, {"exp", seconds + 10}}), "");
}

TEST_F(JsonWebToken, accepts_only_es256) {
    const std::string wrong_algorithm =
        "the token is not signed with ES256, the only accepted algorithm";
    const auto sign = [&](const std::string& text) { return login.key.sign(text); };
    for (const char* algorithm : {"none", "None", "RS256", "HS256", "ES384", "es256", ""}) {
        Json header = login.header();
        header["alg"] = algorithm;
        EXPECT_EQ(fault_of(test::assemble(header.dump(), good.dump(), sign)), wrong_algorithm)
            << algorithm;
    }
    Json header = login.header();
    header.erase("alg");
    EXPECT_EQ(fault_of(login.token(header, good)), wrong_algorithm);
    // No signature.
    const auto nothing = [](const std::string&) { return std::string(); };
    EXPECT_EQ(fault_of(test::assemble(R"({"alg":"none"})", good.dump(), nothing)), wrong_algorithm);
    EXPECT_EQ(fault_of(test::assemble(login.header().dump(), good.dump(), nothing)),
              "the token's signature is not 64 bytes of base64url");
}

TEST_F(JsonWebToken, rejects_hmac_signed_with_the_public_key) {
    const std::string secret = login.key.public_key("first").dump();
    const auto hmac = [&](const std::string& text) {
        std::string out(32, '\0');
        HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()),
             reinterpret_cast<const unsigned char*>(text.data()), text.size(),
             reinterpret_cast<unsigned char*>(out.data()), nullptr);
        return out;
    };
    Json header = login.header();
    header["alg"] = "HS256";
    EXPECT_NE(fault_of(test::assemble(header.dump(), good.dump(), hmac)), "");
}

TEST_F(JsonWebToken, rejects_forged_signatures) {
    const std::string forged = "the token's signature does not match its key";
    const test::SigningKey stranger;
    const auto of_stranger = [&](const std::string& text) { return stranger.sign(text); };
    EXPECT_EQ(fault_of(test::assemble(login.header().dump(), good.dump(), of_stranger)), forged);
    const auto zeros = [](const std::string&) { return std::string(64, '\0'); };
    EXPECT_EQ(fault_of(test::assemble(login.header().dump(), good.dump(), zeros)), forged)
        << "r = s = 0";
    // A signature of a different token.
    const std::string token = login.token(good);
    good["role"] = "admin";
    const std::string other = login.token(good);
    EXPECT_EQ(fault_of(other.substr(0, other.rfind('.')) + token.substr(token.rfind('.'))), forged);
}

// A token with one changed character is rejected, independent of its position.
TEST_F(JsonWebToken, rejects_any_modified_character) {
    const std::string token = login.token(good);
    ASSERT_EQ(fault_of(token), "");
    for (std::size_t at = 0; at < token.size(); ++at) {
        std::string changed = token;
        changed[at] = changed[at] == 'A' ? 'B' : 'A';
        EXPECT_NE(fault_of(changed), "") << at;
    }
}

TEST_F(JsonWebToken, rejects_keys_outside_the_key_set) {
    const std::string unknown = "the token is signed with an unknown key";
    Json header = login.header();
    header["kid"] = "second";
    EXPECT_EQ(fault_of(login.token(header, good)), unknown);
    header["kid"] = 1;
    EXPECT_EQ(fault_of(login.token(header, good)), "the token's header names no key (kid)");
    header.erase("kid");
    EXPECT_EQ(fault_of(login.token(header, good)), "the token's header names no key (kid)");
    // A key inside the token is ignored.
    const test::SigningKey stranger;
    header["jwk"] = stranger.public_key("mine");
    header["kid"] = "mine";
    const auto sign = [&](const std::string& text) { return stranger.sign(text); };
    EXPECT_EQ(fault_of(test::assemble(header.dump(), good.dump(), sign)), unknown);
    keys.clear();
    EXPECT_EQ(fault_of(login.token(good)), unknown);
}

TEST_F(JsonWebToken, rejects_crit_extensions_and_other_types) {
    Json header = login.header();
    header["crit"] = {"exp"};
    EXPECT_NE(fault_of(login.token(header, good)), "");
    header.erase("crit");
    header["typ"] = "at+jwt";
    EXPECT_EQ(fault_of(login.token(header, good)), "");
    header["typ"] = "logout+jwt";
    EXPECT_NE(fault_of(login.token(header, good)), "");
}

TEST_F(JsonWebToken, rejects_malformed_tokens) {
    const auto sign = [&](const std::string& text) { return login.key.sign(text); };
    const std::string head = login.header().dump();
    for (const std::string& token :
         {std::string(), std::string("."), std::string(".."), std::string("a.b"),
          std::string("a.b.c.d.e"), std::string(100000, 'A'), login.token(good) + "=",
          login.token(good) + "\n", " " + login.token(good), login.token(good) + ".",
          test::assemble("[]", good.dump(), sign), test::assemble("null", good.dump(), sign),
          test::assemble(head, "[]", sign), test::assemble(head, "", sign),
          test::assemble(head, good.dump() + "{}", sign)}) {
        EXPECT_NE(fault_of(token), "") << token.substr(0, 80);
    }
}

TEST_F(JsonWebToken, rejects_duplicate_claims) {
    std::string claims = good.dump();
    claims.insert(1, R"("role":"admin",)");
    const auto sign = [&](const std::string& text) { return login.key.sign(text); };
    EXPECT_EQ(fault_of(test::assemble(login.header().dump(), claims, sign)),
              "the token's claims cannot be parsed: an object has a duplicate key");
}

TEST_F(JsonWebToken, rejects_tokens_larger_than_8_kib) {
    good["note"] = std::string(5500, 'x');
    const std::string token = login.token(good);
    ASSERT_LT(token.size(), token_bytes_max);
    EXPECT_EQ(fault_of(token), "");
    good["note"] = std::string(7000, 'x');
    ASSERT_GT(login.token(good).size(), token_bytes_max);
    EXPECT_EQ(fault_of(login.token(good)), "the token is longer than 8192 bytes");
}

// Each error has a distinct message that contains no part of the token.
TEST_F(JsonWebToken, errors_are_distinct_and_quote_no_token_content) {
    const Json deep = Json::parse(R"({"a": {"b": {"c": {"d": {}}}}})");
    std::set<std::string> messages;
    const Json changes[] = {{{"iss", nullptr}},
                            {{"iss", "evil-issuer"}},
                            {{"aud", nullptr}},
                            {{"aud", "evil-audience"}},
                            {{"sub", nullptr}},
                            {{"sub", std::string(200, 'e')}},
                            {{"sub", "anonymous"}},
                            {{"exp", nullptr}},
                            {{"exp", 1}},
                            {{"exp", "evil-time"}},
                            {{"exp", seconds + 90000}},
                            {{"iat", seconds - 86400}},
                            {{"iat", seconds + 600}},
                            {{"nbf", seconds + 600}},
                            {{"role", "evil-role"}},
                            {{"world", 1}},
                            {{"jti", 1}},
                            deep};
    for (const Json& change : changes) {
        const std::string message = fault_with(change);
        EXPECT_TRUE(messages.insert(message).second) << message;
        EXPECT_EQ(message.find("evil"), std::string::npos) << message;
        EXPECT_EQ(message.find("anna"), std::string::npos) << message;
    }
    EXPECT_FALSE(messages.contains(""));
}

}  // namespace
}  // namespace jostle::server
