// SPDX-License-Identifier: MIT
#include "server/util/text.h"

#include <cstdint>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

bool is_continuation(unsigned char c) {
    return (c & 0xc0) == 0x80;
}

// Bytes of the UTF-8 character at the start of `text`; 0 if it is not valid (RFC 3629: no overlong
// forms, no surrogates, nothing above U+10FFFF).
std::size_t character_at(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    ASSERT(!text.empty());
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < size) return 0;
    for (std::size_t i = 1; i < size; i++)
        if (!is_continuation(byte(i))) return 0;
    const unsigned char second = byte(1);
    if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
        (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f))
        return 0;
    return size;
}

// ASCII control characters; U+0080 to U+009F, which terminals also obey; and Unicode characters
// that break lines, change their direction or are invisible: U+200E to 200F, 2028 to 202E, 2066 to
// 2069, FEFF.
bool is_control(std::string_view character) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
    const auto within = [](unsigned char c, int low, int high) { return low <= c && c <= high; };
    ASSERT(!character.empty());
    if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7f;
    if (character.size() == 2) return byte(0) == 0xc2 && byte(1) < 0xa0;
    if (character == "\xef\xbb\xbf") return true;
    if (character.size() != 3 || byte(0) != 0xe2) return false;
    if (byte(1) == 0x80) return within(byte(2), 0x8e, 0x8f) || within(byte(2), 0xa8, 0xae);
    return byte(1) == 0x81 && within(byte(2), 0xa6, 0xa9);
}

std::string escaped(std::string_view bytes) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string out;
    for (const char b : bytes) {
        const auto c = static_cast<unsigned char>(b);
        if (c == '\n')
            out += "\\n";
        else if (c == '\r')
            out += "\\r";
        else if (c == '\t')
            out += "\\t";
        else if (c == '\\')
            out += "\\\\";
        else
            (out += "\\x") += {digits[c >> 4], digits[c & 15]};
    }
    return out;
}

}  // namespace

std::string_view clip_utf8(std::string_view text, std::size_t bytes_max) {
    if (text.size() <= bytes_max) return text;
    std::size_t end = bytes_max;
    while (end > 0 && bytes_max - end < 4 && is_continuation(static_cast<unsigned char>(text[end])))
        end--;
    ASSERT(end <= bytes_max);
    return text.substr(0, end);
}

std::string printable(std::string_view text, std::size_t bytes_max) {
    std::string out;
    while (!text.empty()) {
        const std::size_t size = character_at(text);
        const std::string_view character = text.substr(0, size == 0 ? 1 : size);
        const bool plain = size > 0 && !is_control(character) && character != "\\";
        const std::string piece = plain ? std::string(character) : escaped(character);
        if (out.size() + piece.size() > bytes_max) break;
        out += piece;
        ASSERT(out.size() <= bytes_max);
        text.remove_prefix(character.size());
    }
    return out;
}

std::string in_quotes(std::string_view text, std::size_t bytes_max) {
    std::string out = "\"";
    for (const char c : printable(text, bytes_max)) {
        if (c == '"') out += '\\';
        out += c;
    }
    return out + '"';
}

bool has_control_character(std::string_view text) {
    while (!text.empty()) {
        const std::size_t size = character_at(text);
        if (size == 0 || is_control(text.substr(0, size))) return true;
        text.remove_prefix(size);
    }
    return false;
}

}  // namespace jostle::server
