// SPDX-License-Identifier: MIT
#include "jostle/snapshot/range_coder.h"

#include <algorithm>
#include <utility>

namespace jostle::snapshot {
namespace {

constexpr unsigned piece = 16;  // raw bits per division of the range

}  // namespace

// The top byte of `low_` is final except for a carry, which propagates through bytes of 255: those
// are pending.
void RangeEncoder::shift() {
    const auto carry = static_cast<std::uint8_t>(low_ >> 32);
    if (low_ < 0xff000000u || carry != 0) {
        if (holds_) bytes_.push_back(static_cast<std::byte>(held_ + carry));
        bytes_.insert(bytes_.end(), pending_, static_cast<std::byte>(0xff + carry));
        pending_ = 0;
        held_ = static_cast<std::uint8_t>(low_ >> 24);
        holds_ = true;
    } else {
        pending_++;
    }
    low_ = (low_ & 0x00ffffffu) << 8;
    range_ <<= 8;
}

std::uint64_t RangeEncoder::raw(std::uint64_t value, unsigned count) {
    for (unsigned left = count; left > 0;) {
        const unsigned bits = std::min(left, piece);
        left -= bits;
        range_ >>= bits;
        low_ += range_ * (value >> left & ((1u << bits) - 1));
        while (range_ < range_bottom) shift();
    }
    return value;
}

std::vector<std::byte> RangeEncoder::finish() {
    // Of all numbers in the range, the one with the most trailing zeros.
    for (unsigned zeros = 32;; zeros -= 8) {
        const std::uint64_t mask = (std::uint64_t{1} << zeros) - 1, rounded = (low_ + mask) & ~mask;
        if (rounded >= low_ + range_) continue;
        low_ = rounded;
        break;
    }
    for (int k = 0; k < 5; k++) shift();
    for (std::size_t k = 0; k < range_tail && !bytes_.empty() && bytes_.back() == std::byte{0}; k++)
        bytes_.pop_back();
    return std::move(bytes_);
}

std::uint64_t RangeDecoder::raw(std::uint64_t, unsigned count) {
    std::uint64_t value = 0;
    for (unsigned left = count; left > 0;) {
        const unsigned bits = std::min(left, piece);
        left -= bits;
        range_ >>= bits;
        // No valid encoder produces more, but untrusted bytes may.
        const std::uint32_t digit = std::min(code_ / range_, (1u << bits) - 1);
        code_ -= digit * range_;
        value = value << bits | digit;
        while (range_ < range_bottom) take();
    }
    return value;
}

}  // namespace jostle::snapshot
