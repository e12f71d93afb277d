// SPDX-License-Identifier: MIT
//
// Numbers and strings in sequence, with the same bytes on every machine. The reader checks ok() at
// the end: after a read beyond the end or of a malformed number, every value is 0 or empty.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace jostle::server {

class ByteWriter {
public:
    void number(std::uint64_t value) {  // varint: seven bits per byte, least significant first
        for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(value | 0x80);
        bytes_ += static_cast<char>(value);
    }
    void real(double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        for (int k = 0; k < 8; k++) bytes_ += static_cast<char>(bits >> (8 * k));
    }
    void text(std::string_view value) {
        number(value.size());
        bytes_ += value;
    }

    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    std::uint64_t number() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            const std::uint64_t byte = next();
            value |= (byte & 0x7f) << shift;
            if (byte < 0x80) return value;
        }
        return fail();
    }
    std::uint32_t small() {
        const std::uint64_t value = number();
        return value <= 0xffffffff ? static_cast<std::uint32_t>(value)
                                   : static_cast<std::uint32_t>(fail());
    }
    double real() {
        std::uint64_t bits = 0;
        for (int k = 0; k < 8; k++) bits |= std::uint64_t{next()} << (8 * k);
        return std::bit_cast<double>(bits);
    }
    std::string_view text() {
        const std::uint64_t size = number();
        if (size > bytes_.size()) return fail(), std::string_view();
        const std::string_view value = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return value;
    }
    // Number of list elements, each of which takes at least one byte; fails if it exceeds the
    // number of remaining bytes.
    std::size_t count() {
        const std::uint64_t value = number();
        return value <= bytes_.size() ? value : fail();
    }

    bool ok() const { return ok_; }
    bool at_end() const { return bytes_.empty(); }
    // A value that was read is invalid.
    std::uint64_t fail() {
        ok_ = false;
        bytes_ = {};
        return 0;
    }

private:
    std::uint8_t next() {
        if (bytes_.empty()) return static_cast<std::uint8_t>(fail());
        const auto byte = static_cast<std::uint8_t>(bytes_.front());
        bytes_.remove_prefix(1);
        return byte;
    }

    std::string_view bytes_;
    bool ok_ = true;
};

}  // namespace jostle::server
