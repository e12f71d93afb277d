// SPDX-License-Identifier: MIT
//
// Numbers to little-endian bytes and back. Reading never trusts the bytes: past the end it gives
// zeros and remembers.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace jostle::physics {

// The bits of a number as an unsigned integer of the same size.
template <class T>
auto bits_of(T value) {
    if constexpr (std::is_enum_v<T>) {
        return static_cast<std::make_unsigned_t<std::underlying_type_t<T>>>(value);
    } else if constexpr (std::is_same_v<T, bool>) {
        return static_cast<std::uint8_t>(value ? 1 : 0);
    } else if constexpr (std::is_floating_point_v<T>) {
        using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
        return std::bit_cast<Bits>(value);
    } else {
        return static_cast<std::make_unsigned_t<T>>(value);
    }
}

// The number whose little-endian bytes are there, and back: a load or a store where the machine
// itself is so.
template <class Bits>
Bits load_little_endian(const std::byte* at) {
    Bits bits = 0;
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(&bits, at, sizeof bits);
    } else {
        std::uint64_t wide = 0;
        for (std::size_t k = 0; k < sizeof bits; k++)
            wide |= std::to_integer<std::uint64_t>(at[k]) << (8 * k);
        bits = static_cast<Bits>(wide);
    }
    return bits;
}
template <class Bits>
void store_little_endian(std::byte* at, Bits bits) {
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(at, &bits, sizeof bits);
    } else {
        for (std::size_t k = 0; k < sizeof bits; k++)
            at[k] = static_cast<std::byte>(static_cast<std::uint64_t>(bits) >> (8 * k));
    }
}

// A world has millions of numbers of a few bytes: they gather in a small array, which the compiler
// knows the end of, before they go to the vector.
class ByteWriter {
public:
    template <class T>
    void write(T value) {
        const auto bits = bits_of(value);
        if (used_ + sizeof(bits) > gathered_.size()) flush();
        store_little_endian(&gathered_[used_], bits);
        used_ += sizeof(bits);
    }
    // What was written so far.
    std::vector<std::byte>& bytes() {
        flush();
        return bytes_;
    }

private:
    void flush() {
        bytes_.insert(bytes_.end(), gathered_.begin(),
                      gathered_.begin() + static_cast<std::ptrdiff_t>(used_));
        used_ = 0;
    }

    std::array<std::byte, 4096> gathered_;
    std::size_t used_ = 0;
    std::vector<std::byte> bytes_;
};

class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    // The bits of a T, as bits_of makes them.
    template <class T>
    auto read_bits() {
        decltype(bits_of(T{})) bits = 0;
        if (bytes_.size() - at_ < sizeof(bits)) {
            failed_ = true;
            at_ = bytes_.size();
            return bits;
        }
        bits = load_little_endian<decltype(bits)>(&bytes_[at_]);
        at_ += sizeof(bits);
        return bits;
    }
    bool failed() const { return failed_; }
    std::size_t at() const { return at_; }
    std::size_t left() const { return bytes_.size() - at_; }

private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

}  // namespace jostle::physics
