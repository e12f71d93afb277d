// SPDX-License-Identifier: MIT
//
// Conversion of numbers to little-endian bytes and back. The reader accepts untrusted bytes: a read
// past the end returns zeros and sets failed().
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace jostle::physics {

// Returns the bits of a number as an unsigned integer of the same size.
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

// Little-endian byte order on every machine.
template <class Bits>
void put_bits(std::byte* to, Bits bits) {
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(to, &bits, sizeof bits);
    } else {
        for (std::size_t k = 0; k < sizeof bits; k++)
            to[k] = static_cast<std::byte>(static_cast<std::uint64_t>(bits) >> (8 * k));
    }
}
template <class Bits>
Bits get_bits(const std::byte* from) {
    if constexpr (std::endian::native == std::endian::little) {
        Bits bits;
        std::memcpy(&bits, from, sizeof bits);
        return bits;
    } else {
        std::uint64_t wide = 0;
        for (std::size_t k = 0; k < sizeof(Bits); k++)
            wide |= std::to_integer<std::uint64_t>(from[k]) << (8 * k);
        return static_cast<Bits>(wide);
    }
}

// write() is called for millions of numbers, so its only check is for free capacity.
class ByteWriter {
public:
    ByteWriter() = default;
    ByteWriter(const ByteWriter&) = delete;
    ByteWriter& operator=(const ByteWriter&) = delete;

    // Reserves a total capacity. The writer grows beyond it when needed.
    void reserve(std::size_t bytes) {
        if (bytes <= room_.size()) return;
        const std::size_t written = size();
        room_.resize(bytes);
        next_ = room_.data() + written;
        end_ = room_.data() + room_.size();
    }
    template <class T>
    [[gnu::always_inline]] void write(T value) {
        const auto bits = bits_of(value);
        if (end_ - next_ < static_cast<std::ptrdiff_t>(sizeof bits)) [[unlikely]]
            reserve(2 * room_.size() + 256);
        put_bits(next_, bits);
        next_ += sizeof bits;
    }
    // Overwrites a previously written value.
    template <class T>
    void write_at(std::size_t at, T value) {
        put_bits(room_.data() + at, bits_of(value));
    }
    std::size_t size() const { return static_cast<std::size_t>(next_ - room_.data()); }
    std::span<const std::byte> bytes() const { return {room_.data(), size()}; }
    // Returns the written bytes and leaves the writer empty.
    std::vector<std::byte> take() {
        room_.resize(size());
        next_ = end_ = nullptr;
        return std::exchange(room_, {});
    }

private:
    std::vector<std::byte> room_;                 // written up to next_
    std::byte *next_ = nullptr, *end_ = nullptr;  // point into room_
};

class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    // Reads the bits of a T in the format of bits_of().
    template <class T>
    auto read_bits() {
        using Bits = decltype(bits_of(T{}));
        if (bytes_.size() - at_ < sizeof(Bits)) {
            failed_ = true;
            at_ = bytes_.size();
            return Bits{0};
        }
        const Bits bits = get_bits<Bits>(bytes_.data() + at_);
        at_ += sizeof bits;
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
