// SPDX-License-Identifier: MIT
//
// Vectors of six doubles, one velocity of a body, in three registers of two. The order of all sums
// is fixed.
#pragma once

#include <cstring>

namespace jostle::physics {

typedef double Two __attribute__((vector_size(16)));

struct Six {
    Two a, b, c;
};

// No alignment is needed.
inline Six load_six(const double* from) {
    Six v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
inline void store_six(double* to, Six v) {
    std::memcpy(to, &v, sizeof v);
}
inline Six operator*(Six v, double s) {
    return {v.a * s, v.b * s, v.c * s};
}
inline Six operator+(Six u, Six v) {
    return {u.a + v.a, u.b + v.b, u.c + v.c};
}
inline Six operator-(Six u, Six v) {
    return {u.a - v.a, u.b - v.b, u.c - v.c};
}
inline double dot6(Six u, Six v) {
    const Two sum = (u.a * v.a + u.b * v.b) + u.c * v.c;
    return sum[0] + sum[1];
}
inline double dot6(const double* u, const double* v) {
    return dot6(load_six(u), load_six(v));
}
// to += v s
inline void add_six(double* to, Six v, double s) {
    store_six(to, load_six(to) + v * s);
}

}  // namespace jostle::physics
