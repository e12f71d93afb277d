// SPDX-License-Identifier: MIT
//
// Exact sums: a value as a list of non-overlapping doubles of increasing magnitude (Shewchuk 1997;
// two_sum is Knuth's, two_product Dekker's). Valid while nothing overflows and no product is below
// 2^-1022.
#pragma once

#include <array>
#include <cstddef>

#include "jostle/base/check.h"

namespace jostle::physics::planar {

// value + error is the exact result; value is the rounded result.
struct Rounded {
    double value, error;
};

inline Rounded two_sum(double a, double b) {
    const double sum = a + b, of_b = sum - a, of_a = sum - of_b;
    return {sum, (a - of_a) + (b - of_b)};
}
inline Rounded two_difference(double a, double b) {
    return two_sum(a, -b);
}
// Splits both factors into 26-bit halves, whose products are exact.
inline Rounded two_product(double a, double b) {
    const double big_a = 134217729.0 * a, big_b = 134217729.0 * b;  // 2^27 + 1
    const double high_a = big_a - (big_a - a), low_a = a - high_a;
    const double high_b = big_b - (big_b - b), low_b = b - high_b;
    const double product = a * b;
    const double error = ((product - high_a * high_b) - low_a * high_b) - high_a * low_b;
    return {product, low_a * low_b - error};
}

template <int capacity>
class Expansion {
public:
    // At most `capacity` non-zero components.
    void add(double x) {
        int retained = 0;
        for (int k = 0; k < count_; k++) {
            const Rounded sum = two_sum(x, parts_[at(k)]);
            x = sum.value;
            if (sum.error != 0) parts_[at(retained++)] = sum.error;
        }
        if (x != 0) parts_[at(retained++)] = x;
        count_ = retained;
        ASSERT(count_ <= capacity);
    }
    void add(Rounded both) {
        add(both.error);
        add(both.value);
    }
    // Returns the sum with the exact sign, rounded to within a few units in the last place.
    double value() const {
        double sum = 0;
        for (int k = 0; k < count_; k++) sum += parts_[at(k)];
        return sum;
    }

private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }

    std::array<double, capacity> parts_;
    int count_ = 0;
};

}  // namespace jostle::physics::planar
