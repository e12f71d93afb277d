// SPDX-License-Identifier: MIT
//
// Numbers in the output of the range coder, and their models (WIRE.md, "Numbers"). The Coder is a
// RangeEncoder, which writes the argument, or a RangeDecoder, which ignores it; each function
// returns the coded number.
#pragma once

#include <algorithm>
#include <cstdint>

#include "jostle/snapshot/bit_stream.h"
#include "jostle/snapshot/range_coder.h"

namespace jostle::snapshot {

/// Models of a signed number: is it nonzero, negative, above 1, above 3, and odd (2 or 3).
struct MagnitudeModels {
    BitModel nonzero, negative, above_1, above_3, odd;
};
/// Shared models of numbers above 3: is it above 7, 15, 31, ..., and the bit below the leading one.
struct TailModels {
    static constexpr unsigned first_width = 2, last_width = 14;  ///< bits below the leading one
    BitModel wider[last_width - first_width], second[last_width - first_width + 1];
};
/// A count or a gap: its width in unary.
struct CountModels {
    static constexpr unsigned widths = 40;
    BitModel wider[widths];
};

/// Codes a number >= 0: the width of value + 1 in unary, then its bits below the leading one. A
/// decoder may read a width of up to 40.
template <class Coder>
std::uint64_t code_count(Coder& coder, CountModels& m, std::uint64_t value) {
    const unsigned target_width = bit_width(value + 1) - 1;
    unsigned width = 0;
    while (width < CountModels::widths && coder.bit(m.wider[width], target_width > width)) width++;
    const std::uint64_t leading = std::uint64_t{1} << width;
    return (leading | coder.raw((value + 1) & (leading - 1), width)) - 1;
}

/// Codes the magnitude of a number above 3.
template <class Coder>
std::uint64_t code_large(Coder& coder, TailModels& tail, std::uint64_t size) {
    constexpr unsigned first = TailModels::first_width, last = TailModels::last_width;
    const unsigned target_width = bit_width(size) - 1;
    unsigned width = first;
    while (width < last && coder.bit(tail.wider[width - first], target_width > width)) width++;
    if (width == last) width += static_cast<unsigned>(coder.raw(target_width - last, 5));
    const bool second =
        coder.bit(tail.second[std::min(width, last) - first], (size >> (width - 1) & 1) != 0);
    const std::uint64_t low = (std::uint64_t{1} << (width - 1)) - 1;
    return (std::uint64_t{2} | (second ? 1 : 0)) << (width - 1) | coder.raw(size & low, width - 1);
}

/// Codes a number of up to 45 bits and a sign.
template <class Coder>
std::int64_t code_number(Coder& coder, MagnitudeModels& m, TailModels& tail, std::int64_t value) {
    if (!coder.bit(m.nonzero, value != 0)) return 0;
    const bool negative = coder.bit(m.negative, value < 0);
    const auto size = static_cast<std::uint64_t>(value < 0 ? -value : value);
    std::uint64_t coded = 1;
    if (coder.bit(m.above_1, size > 1)) {
        if (!coder.bit(m.above_3, size > 3))
            coded = 2 | (coder.bit(m.odd, (size & 1) != 0) ? 1 : 0);
        else
            coded = code_large(coder, tail, size);
    }
    return negative ? -static_cast<std::int64_t>(coded) : static_cast<std::int64_t>(coded);
}

}  // namespace jostle::snapshot
