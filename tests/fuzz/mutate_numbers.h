// SPDX-License-Identifier: MIT
//
// Varies inputs that are mostly doubles, as saved worlds and points are: every second time a double
// at some place becomes another, else libFuzzer does what it does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tests/fuzz/target.h"
#include "tests/fuzz/values.h"

namespace jostle::fuzz {

inline std::size_t mutate_numbers(std::uint8_t* data, std::size_t size, std::size_t size_max,
                                  unsigned seed) {
    Random random(seed + 1);
    if (size < sizeof(double) || below(random, 2) == 0)
        return LLVMFuzzerMutate(data, size, size_max);
    for (std::uint32_t k = 1 + below(random, 2); k > 0; k--) {
        const auto at = below(random, static_cast<std::uint32_t>(size - sizeof(double) + 1));
        double x = 0;
        std::memcpy(&x, data + at, sizeof x);
        x = mutated_number(x, random);
        std::memcpy(data + at, &x, sizeof x);
    }
    return size;
}

}  // namespace jostle::fuzz
