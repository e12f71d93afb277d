// SPDX-License-Identifier: MIT
#include "persistence/compressed.h"

#include <zstd.h>

#include <memory>
#include <new>

#include "base/free_with.h"

namespace jostle::server {
namespace {

// The fastest: level 3 saves another tenth and takes twice the time.
constexpr int level = 1;

Error not_packed(const std::string& why) {
    return {ErrorCode::corrupt_data, "packed bytes " + why};
}

}  // namespace

std::string compress(std::string_view bytes) {
    const std::unique_ptr<ZSTD_CCtx, FreeWith<ZSTD_freeCCtx>> context(ZSTD_createCCtx());
    if (!context) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    std::string packed(ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t size =
        ZSTD_compress2(context.get(), packed.data(), packed.size(), bytes.data(), bytes.size());
    // With room for the worst case only memory can be short.
    if (ZSTD_isError(size)) throw std::bad_alloc();
    packed.resize(size);
    packed.shrink_to_fit();
    return packed;
}

Result<std::string> decompress(std::string_view packed, std::size_t bytes_max) {
    const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN)
        return not_packed("do not say how many they are");
    if (size > bytes_max)
        return not_packed("are " + std::to_string(size) + " unpacked; " +
                          std::to_string(bytes_max) + " are allowed");
    if (ZSTD_findFrameCompressedSize(packed.data(), packed.size()) != packed.size())
        return not_packed("have an end that is not theirs");
    std::string bytes(size, '\0');
    const std::size_t got =
        ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    if (ZSTD_isError(got)) return not_packed(std::string("are damaged: ") + ZSTD_getErrorName(got));
    if (got != size) return not_packed("are fewer than they say");
    return bytes;
}

}  // namespace jostle::server
