// SPDX-License-Identifier: MIT
#include "server/storage/journal_chain.h"

#include <openssl/evp.h>

#include <cstdint>
#include <memory>

#include "jostle/base/result.h"
#include "server/util/free_with.h"

namespace jostle::server {

Digest digest_of(std::span<const std::string_view> pieces) {
    const std::unique_ptr<EVP_MD_CTX, FreeWith<EVP_MD_CTX_free>> context(EVP_MD_CTX_new());
    Digest digest{};
    bool ok = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
    for (const std::string_view piece : pieces) {
        std::uint8_t size[8];
        for (int k = 0; k < 8; k++)
            size[k] = static_cast<std::uint8_t>(std::uint64_t{piece.size()} >> (8 * k));
        ok = ok && EVP_DigestUpdate(context.get(), size, sizeof size) == 1 &&
             EVP_DigestUpdate(context.get(), piece.data(), piece.size()) == 1;
    }
    ok = ok && EVP_DigestFinal_ex(context.get(), digest.data(), nullptr) == 1;
    if (!ok) end_without_value({ErrorCode::internal, "OpenSSL provides no SHA-256"});
    return digest;
}

Chain next_chain(const Chain& previous, std::string_view data) {
    const std::string_view pieces[] = {
        {reinterpret_cast<const char*>(previous.data()), previous.size()}, data};
    return digest_of(pieces);
}

}  // namespace jostle::server
