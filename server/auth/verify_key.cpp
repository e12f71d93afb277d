// SPDX-License-Identifier: MIT
#include "server/auth/verify_key.h"

#include <openssl/bn.h>
#include <openssl/core_names.h>
#include <openssl/ec.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/params.h>

#include <string>

#include "jostle/base/check.h"
#include "server/util/free_with.h"

namespace jostle::server {

namespace {

constexpr std::size_t number_bytes = 32;  // a coordinate, r or s

using KeyContext = std::unique_ptr<EVP_PKEY_CTX, FreeWith<EVP_PKEY_CTX_free>>;
using DigestContext = std::unique_ptr<EVP_MD_CTX, FreeWith<EVP_MD_CTX_free>>;
using Number = std::unique_ptr<BIGNUM, FreeWith<BN_free>>;
using Signature = std::unique_ptr<ECDSA_SIG, FreeWith<ECDSA_SIG_free>>;

const unsigned char* bytes_of(std::string_view text) {
    return reinterpret_cast<const unsigned char*>(text.data());
}

Number number_of(std::string_view bytes) {
    return Number(BN_bin2bn(bytes_of(bytes), static_cast<int>(bytes.size()), nullptr));
}

// Converts r and s in sequence to the DER structure that OpenSSL reads; empty: out of memory.
std::string to_der(std::string_view raw) {
    ASSERT(raw.size() == 2 * number_bytes);
    const Signature signature(ECDSA_SIG_new());
    Number r = number_of(raw.substr(0, number_bytes)), s = number_of(raw.substr(number_bytes));
    if (!signature || !r || !s) return {};
    if (ECDSA_SIG_set0(signature.get(), r.get(), s.get()) != 1) return {};
    r.release();  // the signature owns them now
    s.release();
    unsigned char* out = nullptr;
    const int size = i2d_ECDSA_SIG(signature.get(), &out);
    if (size <= 0) return {};
    std::string der(reinterpret_cast<const char*>(out), static_cast<std::size_t>(size));
    OPENSSL_free(out);
    return der;
}

EVP_PKEY* key_of_point(std::string& point) {
    char curve[] = "P-256";
    OSSL_PARAM parameters[] = {
        OSSL_PARAM_construct_utf8_string(OSSL_PKEY_PARAM_GROUP_NAME, curve, 0),
        OSSL_PARAM_construct_octet_string(OSSL_PKEY_PARAM_PUB_KEY, point.data(), point.size()),
        OSSL_PARAM_construct_end()};
    const KeyContext context(EVP_PKEY_CTX_new_from_name(nullptr, "EC", nullptr));
    EVP_PKEY* key = nullptr;
    if (!context || EVP_PKEY_fromdata_init(context.get()) != 1 ||
        EVP_PKEY_fromdata(context.get(), &key, EVP_PKEY_PUBLIC_KEY, parameters) != 1)
        return nullptr;
    return key;
}

// The first 16 bytes of SHA-256.
std::string digest_of(std::string_view bytes) {
    std::string digest(EVP_MAX_MD_SIZE, '\0');
    if (EVP_Digest(bytes.data(), bytes.size(), reinterpret_cast<unsigned char*>(digest.data()),
                   nullptr, EVP_sha256(), nullptr) != 1)
        return {};
    digest.resize(16);
    return digest;
}

bool is_good(EVP_PKEY* key) {
    const KeyContext context(EVP_PKEY_CTX_new_from_pkey(nullptr, key, nullptr));
    return context && EVP_PKEY_public_check(context.get()) == 1;
}

}  // namespace

std::optional<VerifyKey> VerifyKey::from_point(std::string_view x, std::string_view y) {
    if (x.size() != number_bytes || y.size() != number_bytes) return std::nullopt;
    std::string point = "\x04";  // uncompressed point: both coordinates follow
    point.append(x).append(y);
    ASSERT(point.size() == 1 + 2 * number_bytes);
    const std::shared_ptr<EVP_PKEY> key(key_of_point(point), EVP_PKEY_free);
    const std::string id = digest_of(point);
    const bool good = key && is_good(key.get()) && !id.empty();
    ERR_clear_error();  // OpenSSL has an error queue per thread that other code reads
    if (!good) return std::nullopt;
    return VerifyKey(key, id);
}

bool VerifyKey::verifies(std::string_view message, std::string_view signature) const {
    if (signature.size() != 2 * number_bytes) return false;
    ASSERT(key_);
    const std::string der = to_der(signature);
    const DigestContext context(EVP_MD_CTX_new());
    const bool good =
        context && !der.empty() &&
        EVP_DigestVerifyInit(context.get(), nullptr, EVP_sha256(), nullptr, key_.get()) == 1 &&
        EVP_DigestVerify(context.get(), bytes_of(der), der.size(), bytes_of(message),
                         message.size()) == 1;
    ERR_clear_error();
    return good;
}

}  // namespace jostle::server
