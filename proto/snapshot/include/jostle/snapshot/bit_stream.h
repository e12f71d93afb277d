// SPDX-License-Identifier: MIT
//
// Writes and reads bits and the two codes of WIRE.md: Rice (R. F. Rice, "Some Practical Universal
// Noiseless Coding Techniques", JPL 1979) and exponential Golomb. Bits fill bytes from the least
// significant bit. The reader does not trust its input: reads past the end return zeros and set a
// flag.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jostle::snapshot {

/// A unary prefix of rice_escape ones means that the value follows in rice_escape_bits bits: enough
/// for any zig-zag encoded difference of two int32.
inline constexpr unsigned rice_escape = 15;
inline constexpr unsigned rice_escape_bits = 33;

/// Maps 0, -1, 1, -2, ... to 0, 1, 2, 3, ...
inline std::uint64_t zig_zag_encode(std::int64_t v) {
    return (static_cast<std::uint64_t>(v) << 1) ^ static_cast<std::uint64_t>(v >> 63);
}
inline std::int64_t zig_zag_decode(std::uint64_t u) {
    return static_cast<std::int64_t>(u >> 1) ^ -static_cast<std::int64_t>(u & 1);
}
/// Number of bits needed to write x: 0 1 2 2 3 3 3 3 4 ... for x = 0, 1, 2, ...
inline unsigned bit_width(std::uint64_t x) {
    return static_cast<unsigned>(std::bit_width(x));
}

class BitWriter {
public:
    void bits(std::uint64_t value, unsigned count);  ///< count <= 57
    /// Rice code: value >> k in unary (ones, then a zero), then the low k bits. A value whose unary
    /// part would need rice_escape or more ones uses the escape; it must be below
    /// 2^rice_escape_bits. k is at most 40.
    void rice(std::uint64_t value, unsigned k);
    /// Exponential Golomb code of order k, for counts and gaps below 2^40.
    void exp_golomb(std::uint64_t value, unsigned k);
    /// Returns all bytes, the last one padded with zeros, and clears the writer.
    std::vector<std::byte> finish();

private:
    void put_word();

    std::vector<std::byte> bytes_;  // longer than its used part
    std::size_t size_ = 0;
    std::uint64_t pending_ = 0;
    unsigned pending_bits_ = 0;  // below 64 between calls
};

class BitReader {
public:
    explicit BitReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::uint64_t bits(unsigned count);  ///< count <= 57
    std::uint64_t rice(unsigned k);
    std::uint64_t exp_golomb(unsigned k);
    /// Returns whether the next rice_escape bits are all ones, and consumes them if so.
    bool take_escape();

    bool past_end() const { return at_ > bytes_.size() * 8; }
    std::size_t bit_position() const { return at_; }
    /// Returns whether only padding is left: fewer than eight bits, all zero.
    bool at_clean_end() const;

private:
    std::uint64_t peek(unsigned count) const;

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;  // bit position
};

}  // namespace jostle::snapshot
