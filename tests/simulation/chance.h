// SPDX-License-Identifier: MIT
//
// Chance that is the same everywhere: splitmix64 (Steele, Lea, Flood 2014). The standard's
// distributions differ from library to library.
#pragma once

#include <cstdint>
#include <string>

namespace jostle::simulation {

class Chance {
public:
    explicit Chance(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    std::uint64_t below(std::uint64_t end) { return next() % end; }
    // From 0 to 1.
    double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * share(); }
    bool one_in(double n) { return share() * n < 1; }
    std::string bytes(std::size_t count) {
        std::string out(count, '\0');
        for (char& c : out) c = static_cast<char>(next());
        return out;
    }

private:
    std::uint64_t state_;
};

}  // namespace jostle::simulation
