// SPDX-License-Identifier: MIT
//
// An adaptive binary range coder (G. N. N. Martin, "Range encoding", 1979; carries as in LZMA):
// each bit is coded against a model of the probability of a one, and the model adapts to it.
// WIRE.md, "Codec 2", is the specification. Encoder and decoder have the same functions, so one
// traversal of a frame serves both: the encoder writes its argument, the decoder ignores it, and
// each returns the coded value. The decoder does not trust its input: reads past the end return
// zeros and are counted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jostle::snapshot {

/// The probability of a one, and the confidence in it.
struct BitModel {
    std::uint16_t one = 32768;  ///< in units of 1/65536
    /// bits, at most seen_max; the model adapts more slowly the more it has seen
    std::uint16_t seen = 0;

    static constexpr std::uint16_t seen_max = 100;

    void learn(bool bit) {
        const std::uint32_t rate = rates[seen];
        if (seen < seen_max) seen++;
        const std::uint32_t p = one;
        const std::uint32_t next = bit ? p + ((65535 - p) * rate >> 16) : p - (p * rate >> 16);
        one = static_cast<std::uint16_t>(next < 64 ? 64 : next > 65472 ? 65472 : next);
    }

private:
    /// 65536 / (seen + 1.6).
    static constexpr std::array<std::uint16_t, seen_max + 1> rates = [] {
        std::array<std::uint16_t, seen_max + 1> table{};
        for (std::uint32_t n = 0; n <= seen_max; n++)
            table[n] = static_cast<std::uint16_t>(655360 / (10 * n + 16));
        return table;
    }();
};

inline constexpr std::uint32_t range_bottom = 1u << 24;  ///< a smaller range shifts in a byte
/// The encoder omits at most this number of trailing zero bytes.
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
    /// Codes `count` bits, at most 40, with equal probability of ones and zeros.
    std::uint64_t raw(std::uint64_t value, unsigned count);
    /// Number of bytes so far, up to a few that later ones may still change.
    std::size_t size() const { return bytes_.size() + pending_ + (holds_ ? 1 : 0); }
    /// Returns all bytes. The encoder must not be used afterwards.
    std::vector<std::byte> finish();

private:
    void shift();

    std::vector<std::byte> bytes_;
    std::uint64_t low_ = 0;  // 33 bits; the highest is a carry
    std::uint32_t range_ = 0xffffffffu;
    std::uint32_t pending_ = 0;  // number of 255 bytes that a carry would still change
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

    /// More zeros were read past the end than an encoder omits.
    bool past_end() const { return at_ > bytes_.size() + range_tail; }
    /// Every byte was consumed.
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

}  // namespace jostle::snapshot
