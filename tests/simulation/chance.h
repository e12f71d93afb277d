// SPDX-License-Identifier: MIT
//
// What happens by chance: the tests' numbers, and a few questions more.
#pragma once

#include <string>

#include "tests/support/random.h"

namespace jostle::simulation {

class Chance : public test::Random {
public:
    using Random::Random;

    bool one_in(double n) { return in(0, n) < 1; }
    std::string bytes(std::size_t count) {
        std::string out(count, '\0');
        for (char& c : out) c = static_cast<char>(bits());
        return out;
    }
};

}  // namespace jostle::simulation
