// SPDX-License-Identifier: MIT
#include "jostle/snapshot/word_changes.h"

#include <bit>

namespace jostle::snapshot {

namespace {

constexpr std::size_t word_bytes = 4, byte_bits = 8;

std::size_t bits_of(std::string_view bytes) {
    std::size_t bits = 0;
    for (const char byte : bytes)
        bits += static_cast<std::size_t>(std::popcount(static_cast<unsigned char>(byte)));
    return bits;
}

std::uint32_t word_at(std::string_view bytes) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < word_bytes; k++)
        word |= std::uint32_t{static_cast<unsigned char>(bytes[k])} << (byte_bits * k);
    return word;
}

}  // namespace

WordChanges changes_between(std::span<const std::uint32_t> before,
                            std::span<const std::uint32_t> now) {
    WordChanges changes;
    for (std::size_t k = 0; k < now.size(); k++) {
        if (now[k] == (k < before.size() ? before[k] : 0)) continue;
        changes.changed.resize(k / byte_bits + 1, '\0');
        changes.changed.back() = static_cast<char>(
            static_cast<unsigned char>(changes.changed.back()) | (1u << (k % byte_bits)));
        for (std::size_t byte = 0; byte < word_bytes; byte++)
            changes.values.push_back(static_cast<char>(now[k] >> (byte_bits * byte)));
    }
    return changes;
}

Result<std::vector<std::uint32_t>> apply_changes(std::span<const std::uint32_t> before,
                                                 std::size_t size, std::string_view changed,
                                                 std::string_view values) {
    const auto wrong = [](const std::string& reason) {
        return Error{ErrorCode::corrupt_data, "controlled entity state: " + reason};
    };
    if (size > words_max)
        return wrong(std::to_string(size) + " words; at most " + std::to_string(words_max) +
                     " are allowed");
    if (values.size() != word_bytes * bits_of(changed))
        return wrong(std::to_string(bits_of(changed)) + " words changed, but there are " +
                     std::to_string(values.size()) + " bytes of values");
    std::vector<std::uint32_t> words(before.begin(), before.end());
    words.resize(size);
    for (std::size_t k = 0; k < byte_bits * changed.size(); k++) {
        if ((static_cast<unsigned char>(changed[k / byte_bits]) >> (k % byte_bits) & 1) == 0)
            continue;
        if (k >= size) return wrong("word " + std::to_string(k) + " is past the end of the list");
        words[k] = word_at(values);
        values.remove_prefix(word_bytes);
    }
    return words;
}

}  // namespace jostle::snapshot
