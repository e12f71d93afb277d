// SPDX-License-Identifier: MIT
#include "jostle/datagram/content.h"

#include <algorithm>

#include "jostle/datagram/little_endian.h"

namespace jostle::datagram {

namespace {

enum class Kind : std::uint8_t { message = 1, part = 2, question = 3, answer = 4 };

std::string begin(Kind kind) {
    return {static_cast<char>(kind)};
}

std::string token_of(Kind kind, std::uint64_t token) {
    std::string content = begin(kind);
    put_number(content, token);
    return content;
}

Error bad(const std::string& why) {
    return {ErrorCode::corrupt_data, "a datagram's content: " + why};
}

Result<Content> decode_fragment(std::string_view bytes) {
    if (bytes.size() < 6) return bad("a part of " + std::to_string(bytes.size()) + " bytes");
    const Fragment part{.message = number_at<std::uint32_t>(bytes, 0),
                        .index = number_at<std::uint8_t>(bytes, 4),
                        .count = number_at<std::uint8_t>(bytes, 5),
                        .bytes = bytes.substr(6)};
    if (part.count < 2 || part.count > fragments_max || part.index >= part.count)
        return bad("part " + std::to_string(part.index) + " of " + std::to_string(part.count));
    const bool last = part.index + 1 == part.count;
    if (part.bytes.empty() || part.bytes.size() > fragment_bytes ||
        (!last && part.bytes.size() != fragment_bytes))
        return bad("a part with " + std::to_string(part.bytes.size()) + " bytes");
    return Content{part};
}

}  // namespace

Result<Content> decode_content(std::string_view content) {
    if (content.empty()) return bad("it is empty");
    const std::string_view rest = content.substr(1);
    const auto kind = static_cast<Kind>(content[0]);
    switch (kind) {
        case Kind::message:
            return Content{Message{rest}};
        case Kind::part:
            return decode_fragment(rest);
        case Kind::question:
        case Kind::answer:
            if (rest.size() != sizeof(std::uint64_t))
                return bad("a word of " + std::to_string(rest.size()) + " bytes");
            if (kind == Kind::question)
                return Content{PathChallenge{number_at<std::uint64_t>(rest, 0)}};
            return Content{PathResponse{number_at<std::uint64_t>(rest, 0)}};
    }
    return bad("kind " + std::to_string(number_at<std::uint8_t>(content, 0)) + " is not known");
}

std::string encode(const PathChallenge& question) {
    return token_of(Kind::question, question.token);
}
std::string encode(const PathResponse& answer) {
    return token_of(Kind::answer, answer.token);
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
        std::string& content = contents.emplace_back(begin(whole ? Kind::message : Kind::part));
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
