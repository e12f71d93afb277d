// SPDX-License-Identifier: MIT
#include "jostle/snapshot/bit_stream.h"

#include <cstring>

namespace jostle::snapshot {
namespace {

std::uint64_t low_mask(unsigned count) {
    return (std::uint64_t{1} << count) - 1;
}

}  // namespace

void BitWriter::bits(std::uint64_t value, unsigned count) {
    value &= low_mask(count);
    pending_ |= value << pending_bits_;
    pending_bits_ += count;
    if (pending_bits_ < 64) return;
    pending_bits_ -= 64;
    put_word();
    // The bits that did not fit; zero if all fitted, because count is below 64.
    pending_ = value >> (count - pending_bits_);
}

void BitWriter::put_word() {
    if (bytes_.size() < size_ + 8) bytes_.resize(2 * size_ + 256);
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(&bytes_[size_], &pending_, 8);
    } else {
        for (unsigned k = 0; k < 8; k++)
            bytes_[size_ + k] = static_cast<std::byte>(pending_ >> 8 * k & 0xff);
    }
    size_ += 8;
}

void BitWriter::rice(std::uint64_t value, unsigned k) {
    const std::uint64_t high = value >> k;
    if (high < rice_escape) {
        const auto ones = static_cast<unsigned>(high);
        bits(low_mask(ones) | (value & low_mask(k)) << (ones + 1), ones + 1 + k);
    } else {
        bits(low_mask(rice_escape), rice_escape);
        bits(value, rice_escape_bits);
    }
}

void BitWriter::exp_golomb(std::uint64_t value, unsigned k) {
    const std::uint64_t x = value + (std::uint64_t{1} << k);
    const unsigned width = bit_width(x) - 1 - k;
    rice(width, 0);
    bits(x, width + k);
}

std::vector<std::byte> BitWriter::finish() {
    const std::size_t last = (pending_bits_ + 7) / 8;
    put_word();
    bytes_.resize(size_ - 8 + last);
    pending_ = 0;
    pending_bits_ = 0;
    size_ = 0;
    return std::move(bytes_);
}

std::uint64_t BitReader::peek(unsigned count) const {
    std::uint64_t value = 0;
    const std::size_t first = at_ / 8;
    if (std::endian::native == std::endian::little && first + 8 <= bytes_.size()) {
        std::memcpy(&value, bytes_.data() + first, 8);
    } else {  // the last bytes, one by one
        for (std::size_t k = 0; k < 8 && first + k < bytes_.size(); k++)
            value |= std::to_integer<std::uint64_t>(bytes_[first + k]) << (8 * k);
    }
    return (value >> (at_ % 8)) & low_mask(count);
}

std::uint64_t BitReader::bits(unsigned count) {
    const std::uint64_t value = peek(count);
    at_ += count;
    return value;
}

std::uint64_t BitReader::rice(unsigned k) {
    const auto ones = static_cast<unsigned>(std::countr_one(peek(rice_escape)));
    if (ones >= rice_escape) {
        at_ += rice_escape;
        return bits(rice_escape_bits);
    }
    at_ += ones + 1;
    return (std::uint64_t{ones} << k) | bits(k);
}

std::uint64_t BitReader::exp_golomb(unsigned k) {
    const std::uint64_t width = rice(0);
    // A valid count or gap needs no more than 40 bits; a larger shift would be undefined.
    if (width + k > 40) {
        at_ = bytes_.size() * 8 + 1;
        return 0;
    }
    const auto low = static_cast<unsigned>(width) + k;
    return (bits(low) | std::uint64_t{1} << low) - (std::uint64_t{1} << k);
}

bool BitReader::take_escape() {
    if (peek(rice_escape) != low_mask(rice_escape)) return false;
    at_ += rice_escape;
    return true;
}

bool BitReader::at_clean_end() const {
    const std::size_t total = bytes_.size() * 8;
    return at_ <= total && total - at_ < 8 && peek(static_cast<unsigned>(total - at_)) == 0;
}

}  // namespace jostle::snapshot
