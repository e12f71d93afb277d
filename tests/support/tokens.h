// SPDX-License-Identifier: MIT
//
// A login service for tests: its own keys, the key set that a server reads, and valid and forged
// tokens.
#pragma once

#include <openssl/bn.h>
#include <openssl/core_names.h>
#include <openssl/ec.h>
#include <openssl/evp.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "jostle/base/base64.h"

namespace jostle::test {

using Json = nlohmann::json;

inline std::string to_base64url(std::string_view bytes) {
    return encode_base64(std::as_bytes(std::span(bytes)), Base64::url);
}

// A private key on the curve P-256.
class SigningKey {
public:
    SigningKey() : key_(EVP_EC_gen("P-256"), EVP_PKEY_free) {
        if (!key_) throw std::runtime_error("OpenSSL cannot create a key");
    }

    // r and s, 32 bytes each, in the format of ES256.
    std::string sign(std::string_view message) const {
        const std::shared_ptr<EVP_MD_CTX> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
        const auto* text = reinterpret_cast<const unsigned char*>(message.data());
        std::string der(128, '\0');
        std::size_t size = der.size();
        if (EVP_DigestSignInit(context.get(), nullptr, EVP_sha256(), nullptr, key_.get()) != 1 ||
            EVP_DigestSign(context.get(), reinterpret_cast<unsigned char*>(der.data()), &size, text,
                           message.size()) != 1)
            throw std::runtime_error("OpenSSL cannot sign");
        const auto* at = reinterpret_cast<const unsigned char*>(der.data());
        const std::shared_ptr<ECDSA_SIG> signature(
            d2i_ECDSA_SIG(nullptr, &at, static_cast<long>(size)), ECDSA_SIG_free);
        return number(ECDSA_SIG_get0_r(signature.get())) +
               number(ECDSA_SIG_get0_s(signature.get()));
    }

    // The public key as an entry of a key set.
    Json public_key(const std::string& id) const {
        return {{"kty", "EC"},
                {"crv", "P-256"},
                {"use", "sig"},
                {"alg", "ES256"},
                {"kid", id},
                {"x", to_base64url(coordinate(OSSL_PKEY_PARAM_EC_PUB_X))},
                {"y", to_base64url(coordinate(OSSL_PKEY_PARAM_EC_PUB_Y))}};
    }

private:
    static std::string number(const BIGNUM* value) {
        std::string bytes(32, '\0');
        BN_bn2binpad(value, reinterpret_cast<unsigned char*>(bytes.data()), 32);
        return bytes;
    }
    std::string coordinate(const char* name) const {
        BIGNUM* value = nullptr;
        EVP_PKEY_get_bn_param(key_.get(), name, &value);
        const std::string bytes = number(value);
        BN_free(value);
        return bytes;
    }

    std::shared_ptr<EVP_PKEY> key_;
};

inline std::string key_set(const Json& keys) {
    return Json{{"keys", keys}}.dump();
}

// Header and claims, signed by a function.
template <class Sign>
std::string assemble(const std::string& header, const std::string& claims, Sign sign) {
    const std::string text = to_base64url(header) + "." + to_base64url(claims);
    return text + "." + to_base64url(sign(text));
}

struct LoginService {
    static constexpr const char* issuer = "https://login.example.org";
    static constexpr const char* audience = "jostle";

    SigningKey key;
    std::string key_id = "first";

    std::string published() const { return key_set(Json::array({key.public_key(key_id)})); }

    Json header() const { return {{"alg", "ES256"}, {"typ", "JWT"}, {"kid", key_id}}; }
    // Valid for one hour.
    static Json claims(const std::string& subject, const std::string& role,
                       std::chrono::system_clock::time_point now) {
        const std::int64_t seconds = std::chrono::system_clock::to_time_t(now);
        return {{"iss", issuer}, {"aud", audience}, {"sub", subject},
                {"role", role},  {"iat", seconds},  {"exp", seconds + 3600}};
    }
    std::string token(const Json& claims) const { return token(header(), claims); }
    std::string token(const Json& header, const Json& claims) const {
        return assemble(header.dump(), claims.dump(),
                        [&](const std::string& text) { return key.sign(text); });
    }
};

}  // namespace jostle::test
