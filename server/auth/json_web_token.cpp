// SPDX-License-Identifier: MIT
#include "server/auth/json_web_token.h"

#include <algorithm>
#include <array>
#include <optional>

#include "jostle/base/base64.h"
#include "jostle/base/check.h"
#include "server/auth/strict_json.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

using nlohmann::json;
using std::chrono::seconds;

constexpr std::size_t token_depth_max = 4;
constexpr std::size_t audiences_max = 32;
constexpr std::size_t worlds_max = 32;

Error refused(std::string message) {
    return {ErrorCode::unauthenticated, std::move(message)};
}

// The three parts of a token, still encoded.
struct Parts {
    std::string_view header, claims, signature;
    std::string_view signed_text;  // header, '.' and claims
};

std::optional<Parts> split(std::string_view token) {
    if (std::ranges::count(token, '.') != 2) return std::nullopt;
    const std::size_t first = token.find('.'), second = token.rfind('.');
    ASSERT(first < second);
    return Parts{.header = token.substr(0, first),
                 .claims = token.substr(first + 1, second - first - 1),
                 .signature = token.substr(second + 1),
                 .signed_text = token.substr(0, second)};
}

Result<json> read_object(std::string_view encoded, const std::string& what) {
    const Result<std::string> text = decode_base64<std::string>(encoded, Base64::url);
    if (!text.ok()) return refused("the token's " + what + " is not base64url");
    Result<json> object = parse_strict_json(*text, token_depth_max);
    if (!object.ok())
        return refused("the token's " + what + " cannot be parsed: " + object.error().message);
    if (!object->is_object()) return refused("the token's " + what + " is not a JSON object");
    return object;
}

// The key named in the header.
Result<const VerifyKey*> choose_key(const json& header, const VerifyKeys& keys) {
    const std::string* algorithm = string_member(header, "alg");
    if (!algorithm || *algorithm != "ES256")
        return refused("the token is not signed with ES256, the only accepted algorithm");
    if (header.contains("crit"))
        return refused("the token's header requires an extension (crit); none is supported");
    if (const std::string* type = string_member(header, "typ");
        header.contains("typ") && (!type || (*type != "JWT" && *type != "at+jwt")))
        return refused("the token's header has a typ other than JWT and at+jwt");
    const std::string* id = string_member(header, "kid");
    if (!id) return refused("the token's header names no key (kid)");
    const auto key = keys.find(*id);
    if (key == keys.end()) return refused("the token is signed with an unknown key");
    return &key->second;
}

// A time claim; empty: missing.
Result<std::optional<WallTime>> time_of(const json& claims, const char* name) {
    const auto at = claims.find(name);
    if (at == claims.end()) return std::optional<WallTime>();
    const double value = at->is_number() ? at->get<double>() : -1;
    if (!(value >= 0 && value < wall_seconds_max))
        return refused(std::string("the token's ") + name + " is not a time in seconds since 1970");
    return std::optional(WallTime(seconds(static_cast<std::int64_t>(value))));
}

struct Times {
    std::optional<WallTime> expires, issued, begins;
};

Result<Times> read_times(const json& claims) {
    Times times;
    for (const auto& [name, time] :
         {std::pair("exp", &times.expires), std::pair("iat", &times.issued),
          std::pair("nbf", &times.begins)}) {
        const Result<std::optional<WallTime>> read = time_of(claims, name);
        if (!read.ok()) return read.error();
        *time = *read;
    }
    return times;
}

Status check_times(const Times& times, seconds leeway, WallTime now) {
    if (!times.expires) return refused("the token has no expiry time (exp)");
    if (now >= *times.expires + leeway) return refused("the token has expired");
    if (*times.expires > now + token_life_max + leeway)
        return refused("the token expires (exp) more than 24 hours from now");
    if (times.issued && *times.issued > now + leeway)
        return refused("the token was issued (iat) in the future");
    if (times.issued && *times.expires - *times.issued > token_life_max)
        return refused("the token is valid for more than 24 hours (iat to exp)");
    if (times.issued && *times.issued > *times.expires)
        return refused("the token expires (exp) before it was issued (iat)");
    if (times.begins && *times.begins > *times.expires)
        return refused("the token expires (exp) before it is valid (nbf)");
    if (times.begins && *times.begins > now + leeway)
        return refused("the token is not valid yet (nbf)");
    return {};
}

// "aud" is a string or an array of strings.
bool names_audience(const json& claims, const std::string& audience) {
    const auto at = claims.find("aud");
    if (at == claims.end()) return false;
    if (at->is_string()) return at->get_ref<const std::string&>() == audience;
    if (!at->is_array() || at->size() > audiences_max) return false;
    return std::ranges::all_of(*at, [](const json& one) { return one.is_string(); }) &&
           std::ranges::find(*at, json(audience)) != at->end();
}

Status check_parties(const json& claims, const TokenRules& rules) {
    const std::string* issuer = string_member(claims, "iss");
    if (!issuer) return refused("the token has no issuer (iss)");
    if (*issuer != rules.issuer) return refused("the token is from another issuer (iss)");
    if (!claims.contains("aud")) return refused("the token has no audience (aud)");
    if (!names_audience(claims, rules.audience))
        return refused("the token is for another audience (aud)");
    return {};
}

Status check_subject(const std::string* subject) {
    if (!subject || subject->empty()) return refused("the token has no subject (sub)");
    if (subject->size() > subject_bytes_max)
        return refused("the token's subject is longer than 128 bytes");
    if (has_control_character(*subject))
        return refused("the token's subject contains a control character");
    if (*subject == anonymous_subject || subject->starts_with(certificate_prefix))
        return refused("the token's subject is reserved for the server");
    return {};
}

// An optional short string.
Result<std::string> option_of(const json& claims, const char* name) {
    if (!claims.contains(name)) return std::string();
    const std::string* text = string_member(claims, name);
    if (!text || text->empty() || text->size() > subject_bytes_max)
        return refused(std::string("the token's ") + name + " is not a string of 1 to 128 bytes");
    if (has_control_character(*text))
        return refused(std::string("the token's ") + name + " contains a control character");
    return *text;
}

// "world" is a string or an array of strings. An empty array is invalid: it must not open every
// world.
Result<std::vector<std::string>> worlds_of(const json& claims) {
    std::vector<std::string> worlds;
    const auto at = claims.find("world");
    if (at == claims.end()) return worlds;
    const json list = at->is_array() ? *at : json::array({*at});
    if (list.empty() || list.size() > worlds_max)
        return refused("the token's world is not a string or an array of 1 to 32 strings");
    for (const json& world : list) {
        Result<std::string> name = option_of({{"world", world}}, "world");
        if (!name.ok()) return name.error();
        worlds.push_back(*std::move(name));
    }
    return worlds;
}

Result<Identity> read_identity(const json& claims) {
    Identity who{.anonymous = false};
    const std::string* subject = string_member(claims, "sub");
    if (Status s = check_subject(subject); !s.ok()) return s.error();
    who.subject = *subject;
    const std::string* role = string_member(claims, "role");
    const std::optional<Role> named = role ? parse_role(*role) : std::nullopt;
    if (!named || *named == Role::none)
        return refused("the token's role is not viewer, player, director or admin");
    who.role = *named;
    Result<std::string> token_id = option_of(claims, "jti");
    if (!token_id.ok()) return token_id.error();
    who.token_id = *std::move(token_id);
    Result<std::vector<std::string>> worlds = worlds_of(claims);
    if (!worlds.ok()) return worlds.error();
    who.worlds = *std::move(worlds);
    return who;
}

struct SignedClaims {
    json claims;
    std::string key;  // VerifyKey::id()
};

// The claims, if the signature matches the key named in the header.
Result<SignedClaims> read_signed(std::string_view token, const VerifyKeys& keys) {
    if (token.size() > token_bytes_max) return refused("the token is longer than 8192 bytes");
    const std::optional<Parts> parts = split(token);
    if (!parts) return refused("the token does not have three parts");
    const Result<json> header = read_object(parts->header, "header");
    if (!header.ok()) return header.error();
    const Result<const VerifyKey*> key = choose_key(*header, keys);
    if (!key.ok()) return key.error();
    const Result<std::string> signature = decode_base64<std::string>(parts->signature, Base64::url);
    if (!signature.ok() || signature->size() != 64)
        return refused("the token's signature is not 64 bytes of base64url");
    if (!(*key)->verifies(parts->signed_text, *signature))
        return refused("the token's signature does not match its key");
    Result<json> claims = read_object(parts->claims, "claims");
    if (!claims.ok()) return claims.error();
    return SignedClaims{*std::move(claims), (*key)->id()};
}

}  // namespace

Result<Identity> verify_token(std::string_view token, const VerifyKeys& keys,
                              const TokenRules& rules, WallTime now) {
    const Result<SignedClaims> read = read_signed(token, keys);
    if (!read.ok()) return read.error();
    const json& claims = read->claims;
    const Result<Times> times = read_times(claims);
    if (!times.ok()) return times.error();
    if (Status s = check_times(*times, rules.leeway, now); !s.ok()) return s.error();
    if (Status s = check_parties(claims, rules); !s.ok()) return s.error();
    Result<Identity> who = read_identity(claims);
    ASSERT(times->expires);
    if (!who.ok()) return who;
    who->expires = *times->expires + rules.leeway;
    who->key = read->key;
    return who;
}

}  // namespace jostle::server
