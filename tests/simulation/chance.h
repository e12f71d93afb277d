// SPDX-License-Identifier: MIT
//
// Random events: the generator of the tests with a few more functions.
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
