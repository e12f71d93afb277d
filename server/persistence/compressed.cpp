// SPDX-License-Identifier: MIT
#include "persistence/compressed.h"

#include <zstd.h>

#include <cstdint>
#include <memory>

#include "base/free_with.h"

namespace jostle::server {

namespace {

constexpr std::string_view compressed_magic = "jstz";
constexpr char compressed_version = 1;
constexpr std::size_t size_at = compressed_magic.size() + 1, frame_at = size_at + 8;
// Of zstd's blocks: the least that one takes (a head and the byte that it repeats), and the most
// that it holds.
constexpr std::uint64_t block_bytes_min = 4, block_holds_max = ZSTD_BLOCKSIZE_MAX;

Error not_compressed(std::string why) {
    return {ErrorCode::corrupt_data, "compressed bytes: " + std::move(why)};
}

std::string frame_head(std::uint64_t size) {
    std::string head(compressed_magic);
    head += compressed_version;
    for (int k = 0; k < 8; k++) head += static_cast<char>(static_cast<std::uint8_t>(size >> 8 * k));
    return head;
}

std::uint64_t size_in(std::string_view head) {
    std::uint64_t size = 0;
    for (std::size_t k = 0; k < 8; k++)
        size |= std::uint64_t{static_cast<std::uint8_t>(head[size_at + k])} << 8 * k;
    return size;
}

// Why they cannot be what compress() made; empty: they may be.
std::string fault_of(std::string_view compressed, std::size_t bytes_max) {
    if (!compressed.starts_with(compressed_magic))
        return "they do not begin with \"jstz\", so Jostle did not write them";
    if (compressed.size() < frame_at) return "they end within their head";
    if (compressed[compressed_magic.size()] != compressed_version)
        return "version " +
               std::to_string(static_cast<std::uint8_t>(compressed[compressed_magic.size()])) +
               ", and this program reads 1: use the one that wrote them, or a newer one";
    const std::uint64_t size = size_in(compressed);
    const std::string says = "they say that they hold " + std::to_string(size) + " bytes";
    if (size > bytes_max) return says + ", and " + std::to_string(bytes_max) + " are allowed";
    const std::string_view frame = compressed.substr(frame_at);
    if (size / block_holds_max > frame.size() / block_bytes_min)
        return says + ", more than " + std::to_string(frame.size()) + " can hold";
    if (ZSTD_getFrameContentSize(frame.data(), frame.size()) != size)
        return says + ", and the frame of zstd at byte " + std::to_string(frame_at) +
               " does not say so";
    if (ZSTD_findFrameCompressedSize(frame.data(), frame.size()) != frame.size())
        return "they are cut, or others follow";
    return {};
}

}  // namespace

std::string compress(std::string_view bytes) {
    const std::unique_ptr<ZSTD_CCtx, FreeWith<ZSTD_freeCCtx>> context(ZSTD_createCCtx());
    if (!context) end_without_value({ErrorCode::internal, "zstd has no memory to compress in"});
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, 1);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    // Uninitialised, and copied at its true size: only the pages that are used cost anything.
    const std::size_t room = ZSTD_compressBound(bytes.size());
    const auto frame = std::make_unique_for_overwrite<char[]>(room);
    const std::size_t size =
        ZSTD_compress2(context.get(), frame.get(), room, bytes.data(), bytes.size());
    if (ZSTD_isError(size))
        end_without_value(
            {ErrorCode::internal, std::string("zstd cannot compress: ") + ZSTD_getErrorName(size)});
    std::string compressed = frame_head(bytes.size());
    compressed.reserve(frame_at + size);
    compressed.append(frame.get(), size);
    return compressed;
}

Result<std::string> decompress(std::string_view compressed, std::size_t bytes_max) {
    if (std::string fault = fault_of(compressed, bytes_max); !fault.empty())
        return not_compressed(std::move(fault));
    const std::string_view frame = compressed.substr(frame_at);
    std::string bytes(static_cast<std::size_t>(size_in(compressed)), '\0');
    const std::size_t size =
        ZSTD_decompress(bytes.data(), bytes.size(), frame.data(), frame.size());
    if (ZSTD_isError(size))
        return not_compressed(std::string("they are damaged (zstd: ") + ZSTD_getErrorName(size) +
                              "): take an older checkpoint");
    if (size != bytes.size())
        return not_compressed("they hold " + std::to_string(size) + " bytes and say " +
                              std::to_string(bytes.size()));
    return bytes;
}

}  // namespace jostle::server
