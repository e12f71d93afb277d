// SPDX-License-Identifier: MIT
//
// A public key on the curve P-256 that verifies token signatures (ES256). Immutable and shared; any
// thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

extern "C" {
typedef struct evp_pkey_st EVP_PKEY;
}

namespace jostle::server {

class VerifyKey {
public:
    // Coordinates of 32 bytes each, big-endian. Empty if they are not a point of the curve.
    static std::optional<VerifyKey> from_point(std::string_view x, std::string_view y);

    // Whether `signature` is this key's signature of `message`: 64 bytes, r and s, as in tokens.
    bool verifies(std::string_view message, std::string_view signature) const;

    // 16 bytes that differ between keys, whatever their names.
    const std::string& id() const { return id_; }

private:
    VerifyKey(std::shared_ptr<EVP_PKEY> key, std::string id)
        : key_(std::move(key)), id_(std::move(id)) {}

    std::shared_ptr<EVP_PKEY> key_;
    std::string id_;
};

}  // namespace jostle::server
