// SPDX-License-Identifier: MIT
#include "jostle/datagram/content.h"

#include <algorithm>

#include "jostle/datagram/little_endian.h"

namespace jostle::datagram {

namespace {

enum class Kind : std::uint8_t { message = 1, fragment = 2, path_challenge = 3, path_response = 4 };

std::string begin(Kind kind) {
    return {static_cast<char>(kind)};
}

std::string token_of(Kind kind, std::uint64_t token) {
    std::string content = begin(kind);
    put_number(content, token);
    return content;
}

Error bad(const std::string& reason) {
    return {ErrorCode::corrupt_data, "invalid datagram content: " + reason};
}

Result<Content> decode_fragment(std::string_view bytes) {
    if (bytes.size() < 6)
        return bad("fragment header of " + std::to_string(bytes.size()) + " bytes");
    const Fragment fragment{.message = number_at<std::uint32_t>(bytes, 0),
                            .index = number_at<std::uint8_t>(bytes, 4),
                            .count = number_at<std::uint8_t>(bytes, 5),
                            .bytes = bytes.substr(6)};
    if (fragment.count < 2 || fragment.count > fragments_max || fragment.index >= fragment.count)
        return bad("fragment " + std::to_string(fragment.index) + " of " +
                   std::to_string(fragment.count));
    const bool last = fragment.index + 1 == fragment.count;
    if (fragment.bytes.empty() || fragment.bytes.size() > fragment_bytes ||
        (!last && fragment.bytes.size() != fragment_bytes))
        return bad("fragment of " + std::to_string(fragment.bytes.size()) + " bytes");
    return Content{fragment};
}

}  // namespace

Result<Content> decode_content(std::string_view content) {
    if (content.empty()) return bad("empty");
    const std::string_view rest = content.substr(1);
    const auto kind = static_cast<Kind>(content[0]);
    switch (kind) {
        case Kind::message:
            return Content{Message{rest}};
        case Kind::fragment:
            return decode_fragment(rest);
        case Kind::path_challenge:
        case Kind::path_response:
            if (rest.size() != sizeof(std::uint64_t))
                return bad("path token of " + std::to_string(rest.size()) + " bytes");
            if (kind == Kind::path_challenge)
                return Content{PathChallenge{number_at<std::uint64_t>(rest, 0)}};
            return Content{PathResponse{number_at<std::uint64_t>(rest, 0)}};
    }
    return bad("unknown kind " + std::to_string(number_at<std::uint8_t>(content, 0)));
}

std::string encode(const PathChallenge& path_challenge) {
    return token_of(Kind::path_challenge, path_challenge.token);
}
std::string encode(const PathResponse& path_response) {
    return token_of(Kind::path_response, path_response.token);
}

std::vector<std::string> encode_message(std::span<const std::string_view> pieces,
                                        std::uint32_t number) {
    std::size_t size = 0;
    for (const std::string_view piece : pieces) size += piece.size();
    const bool whole = size <= message_bytes_max;
    const std::size_t most = whole ? message_bytes_max : fragment_bytes;
    const std::size_t count = whole ? 1 : (size + most - 1) / most;
    std::vector<std::string> contents;
    if (count > fragments_max) return contents;
    contents.reserve(count);
    std::size_t room = 0;
    const auto next = [&] {
        std::string& content = contents.emplace_back(begin(whole ? Kind::message : Kind::fragment));
        if (!whole) {
            put_number(content, number);
            put_number(content, static_cast<std::uint8_t>(contents.size() - 1));
            put_number(content, static_cast<std::uint8_t>(count));
        }
        room = most;
    };
    next();
    for (std::string_view piece : pieces)
        while (!piece.empty()) {
            if (room == 0) next();
            const std::size_t taken = std::min(room, piece.size());
            contents.back() += piece.substr(0, taken);
            piece.remove_prefix(taken);
            room -= taken;
        }
    return contents;
}

}  // namespace jostle::datagram
