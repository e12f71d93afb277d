// SPDX-License-Identifier: MIT
//
// An adaptive binary range coder (G. N. N. Martin, "Range encoding", 1979; carries as in LZMA):
// each bit is coded against a model of how often it was one, and the model learns from it. WIRE.md,
// "Codec 2", is the specification. Encoder and decoder have the same functions, so that one walk
// over a frame serves both: the encoder takes what it is given, the decoder ignores it, and each
// returns what is in the stream. The decoder never trusts the bytes: past the end it reads zeros
// and remembers how many.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jostle::wire {

// How likely the next bit is a one, and how sure that is.
struct BitModel {
    std::uint16_t one = 32768;  // of 65536
    std::uint16_t seen = 0;     // bits, at most seen_max: the more, the slower it learns

    static constexpr std::uint16_t seen_max = 100;

    void learn(bool bit) {
        const std::uint32_t rate = rates[seen];
        if (seen < seen_max) seen++;
        const std::uint32_t p = one;
        const std::uint32_t next = bit ? p + ((65535 - p) * rate >> 16) : p - (p * rate >> 16);
        one = static_cast<std::uint16_t>(next < 64 ? 64 : next > 65472 ? 65472 : next);
    }

private:
    // 65536 / (seen + 1.6).
    static constexpr std::array<std::uint16_t, seen_max + 1> rates = [] {
        std::array<std::uint16_t, seen_max + 1> table{};
        for (std::uint32_t n = 0; n <= seen_max; n++)
            table[n] = static_cast<std::uint16_t>(655360 / (10 * n + 16));
        return table;
    }();
};

inline constexpr std::uint32_t range_bottom = 1u << 24;  // a smaller range takes in a byte
// Zeros at the end are left out, and so many at most.
inline constexpr std::size_t range_tail = 4;

class RangeEncoder {
public:
    static constexpr bool encoding = true;

    bool bit(BitModel& model, bool value) {
        const std::uint32_t bound = (range_ >> 16) * model.one;
        if (value) {
            range_ = bound;
        } else {
            low_ += bound;
            range_ -= bound;
        }
        model.learn(value);
        while (range_ < range_bottom) shift();
        return value;
    }
    // `count` bits, at most 40, each as likely a one as a zero.
    std::uint64_t raw(std::uint64_t value, unsigned count);
    // All bytes. Then the encoder is spent.
    std::vector<std::byte> finish();

private:
    void shift();

    std::vector<std::byte> bytes_;
    std::uint64_t low_ = 0;  // 33 bits: the last one is a carry
    std::uint32_t range_ = 0xffffffffu;
    std::uint32_t pending_ = 0;  // bytes of 255 that a carry would still change
    std::uint8_t held_ = 0;      // the byte before them
    bool holds_ = false;
};

class RangeDecoder {
public:
    static constexpr bool encoding = false;

    explicit RangeDecoder(std::span<const std::byte> bytes) : bytes_(bytes) {
        for (int k = 0; k < 4; k++) code_ = code_ << 8 | next();
    }

    bool bit(BitModel& model, bool = false) {
        const std::uint32_t bound = (range_ >> 16) * model.one;
        const bool value = code_ < bound;
        if (value) {
            range_ = bound;
        } else {
            code_ -= bound;
            range_ -= bound;
        }
        model.learn(value);
        while (range_ < range_bottom) take();
        return value;
    }
    std::uint64_t raw(std::uint64_t, unsigned count);

    // More zeros were read past the end than an encoder leaves out.
    bool past_end() const { return at_ > bytes_.size() + range_tail; }
    // Whether every byte was needed.
    bool at_clean_end() const { return !past_end() && at_ >= bytes_.size(); }
    std::size_t byte_position() const { return at_ < bytes_.size() ? at_ : bytes_.size(); }

private:
    std::uint32_t next() {
        const std::size_t at = at_++;
        return at < bytes_.size() ? std::to_integer<std::uint32_t>(bytes_[at]) : 0;
    }
    void take() {
        range_ <<= 8;
        code_ = code_ << 8 | next();
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    std::uint32_t range_ = 0xffffffffu;
    std::uint32_t code_ = 0;
};

}  // namespace jostle::wire
