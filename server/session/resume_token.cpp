// SPDX-License-Identifier: MIT
#include "server/session/resume_token.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <array>

#include "server/messages/client_message.h"
#include "server/util/bytes.h"

namespace jostle::server {
namespace {

// Part of the sealed bytes, so that other uses of the secret yield no valid tokens.
constexpr std::string_view purpose = "jostle resume 2";
using Seal = std::array<unsigned char, 32>;

Seal seal_of(std::string_view bytes, std::string_view secret) {
    std::string sealed(purpose);
    sealed += bytes;
    Seal seal{};
    unsigned size = 0;
    HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()),
         reinterpret_cast<const unsigned char*>(sealed.data()), sealed.size(), seal.data(), &size);
    return seal;
}

// A token without expiry has the latest time that fits.
std::uint64_t to_seconds(WallTime time) {
    const auto seconds =
        std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
    return static_cast<std::uint64_t>(std::min<std::int64_t>(seconds, wall_seconds_max));
}

}  // namespace

std::optional<std::string> seal_token(const ResumeToken& token, std::string_view secret) {
    ByteWriter to;
    to.number(token.client);
    to.text(token.world);
    to.text(token.subject);
    to.text(token.ticket);
    to.text(token.key);
    to.number(token.spectator ? 1U : 0U);
    to.number(to_seconds(token.expires));
    to.number(to_seconds(token.token_expires));
    std::string sealed = to.take();
    const Seal seal = seal_of(sealed, secret);
    sealed.append(reinterpret_cast<const char*>(seal.data()), seal.size());
    if (sealed.size() > resume_token_bytes_max) return std::nullopt;
    return sealed;
}

std::optional<ResumeToken> open_token(std::string_view sealed, std::string_view secret,
                                      WallTime now) {
    if (sealed.size() <= sizeof(Seal)) return std::nullopt;
    const std::string_view bytes = sealed.substr(0, sealed.size() - sizeof(Seal));
    const Seal seal = seal_of(bytes, secret);
    if (CRYPTO_memcmp(seal.data(), sealed.data() + bytes.size(), seal.size()) != 0)
        return std::nullopt;
    ByteReader from(bytes);
    ResumeToken token;
    token.client = from.small();
    token.world = from.text();
    token.subject = from.text();
    token.ticket = from.text();
    token.key = from.text();
    token.spectator = from.number() != 0;
    const std::uint64_t expires = from.number(), token_expires = from.number();
    if (!from.ok() || !from.at_end() || expires > wall_seconds_max ||
        token_expires > wall_seconds_max)
        return std::nullopt;
    token.expires = WallTime(std::chrono::seconds(expires));
    token.token_expires = WallTime(std::chrono::seconds(token_expires));
    if (token.expires <= now) return std::nullopt;
    return token;
}

}  // namespace jostle::server
