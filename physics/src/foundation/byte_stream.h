// SPDX-License-Identifier: MIT
//
// Numbers to little-endian bytes and back. Reading never trusts the bytes: past the end it gives
// zeros and remembers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
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

class ByteWriter {
public:
    template <class T>
    void write(T value) {
        const auto bits = bits_of(value);
        for (std::size_t k = 0; k < sizeof(bits); k++)
            bytes_.push_back(static_cast<std::byte>(static_cast<std::uint64_t>(bits) >> (8 * k)));
    }
    std::vector<std::byte>& bytes() { return bytes_; }

private:
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
        std::uint64_t wide = 0;
        for (std::size_t k = 0; k < sizeof(bits); k++)
            wide |= std::to_integer<std::uint64_t>(bytes_[at_++]) << (8 * k);
        bits = static_cast<decltype(bits)>(wide);
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
