// SPDX-License-Identifier: MIT
#include "server/storage/compression.h"

#include <zstd.h>

#include <algorithm>
#include <memory>
#include <new>

#include "jostle/base/check.h"
#include "server/util/free_with.h"

namespace jostle::server {
namespace {

// Level 3 takes 50 % longer for a saved world and is no smaller.
constexpr int level = 1;

Error not_compressed(const std::string& why) {
    return {ErrorCode::corrupt_data, "compressed data: " + why};
}

}  // namespace

std::string compress(std::span<const std::string_view> pieces) {
    // A tick compresses a few hundred bytes; creating a context takes longer than that.
    thread_local const std::unique_ptr<ZSTD_CCtx, FreeWith<ZSTD_freeCCtx>> context(
        ZSTD_createCCtx());
    if (!context) throw std::bad_alloc();
    ZSTD_CCtx_reset(context.get(), ZSTD_reset_session_only);
    std::size_t size = 0;
    for (const std::string_view piece : pieces) size += piece.size();
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    ZSTD_CCtx_setPledgedSrcSize(context.get(), size);
    std::string packed;
    std::string chunk(std::min(ZSTD_CStreamOutSize(), ZSTD_compressBound(size)), '\0');
    const auto feed = [&](std::string_view piece, ZSTD_EndDirective end) {
        ZSTD_inBuffer in{piece.data(), piece.size(), 0};
        for (;;) {
            ZSTD_outBuffer out{chunk.data(), chunk.size(), 0};
            const std::size_t left = ZSTD_compressStream2(context.get(), &out, &in, end);
            // The buffers are large enough: the only possible error is lack of memory.
            if (ZSTD_isError(left)) throw std::bad_alloc();
            ASSERT(out.pos <= chunk.size());
            packed.append(chunk.data(), out.pos);
            if (end == ZSTD_e_end ? left == 0 : in.pos == in.size) return;
        }
    };
    for (const std::string_view piece : pieces) feed(piece, ZSTD_e_continue);
    feed({}, ZSTD_e_end);
    ASSERT(!packed.empty());
    return packed;
}

Result<std::string> decompress(std::string_view packed, std::size_t bytes_max) {
    const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN)
        return not_compressed("the size is missing");
    if (size > bytes_max)
        return not_compressed(std::to_string(size) + " bytes when decompressed; at most " +
                              std::to_string(bytes_max) + " are allowed");
    if (ZSTD_findFrameCompressedSize(packed.data(), packed.size()) != packed.size())
        return not_compressed("the frame has the wrong length");
    std::string bytes(size, '\0');
    const std::size_t got =
        ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    if (ZSTD_isError(got)) return not_compressed(std::string("corrupt: ") + ZSTD_getErrorName(got));
    if (got != size) return not_compressed("shorter than the stated size");
    return bytes;
}

}  // namespace jostle::server
