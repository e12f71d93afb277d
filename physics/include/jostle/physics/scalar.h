// SPDX-License-Identifier: MIT
//
// Scalar mathematics. The engine uses no functions besides + - * / and the ones in this file. sin,
// cos and atan2 of the C library differ between machines in the last bit, which would break
// determinism; the functions below use fixed polynomials and give the same bits everywhere. IEEE
// 754 defines sqrt exactly, so the C library's version is used.
#pragma once

#include <cmath>

namespace jostle::physics {

/// Ratio of a circle's circumference to its diameter.
inline constexpr double pi = 3.14159265358979323846;

/// Returns the square root of x. Exactly rounded.
inline double square_root(double x) {
    return std::sqrt(x);
}
/// Returns the absolute value of x.
inline double absolute(double x) {
    return x < 0 ? -x : x;
}
/// Returns the smaller value; a if they are equal or one is NaN.
inline double minimum(double a, double b) {
    return b < a ? b : a;
}
/// Returns the larger value; a if they are equal or one is NaN.
inline double maximum(double a, double b) {
    return a < b ? b : a;
}
/// Returns x limited to low..high. NaN is returned unchanged.
inline double clamp(double x, double low, double high) {
    return x < low ? low : (high < x ? high : x);
}
/// Returns false for NaN and both infinities.
inline bool is_finite(double x) {
    return x - x == 0;
}

/// Sine and cosine of one angle.
struct SinCos {
    double sin, cos;
};

/// Returns sine and cosine of any finite angle in radians. The error is below 1e-14 for |angle| <
/// 1e6.
///
/// Range reduction by pi/2 in two parts, then Taylor polynomials on [-pi/4, pi/4] (Muller,
/// "Elementary Functions", chapter 11).
inline SinCos sin_cos(double angle) {
    const double turns = angle * (2 / pi);
    const double whole = std::floor(turns + 0.5);
    // pi/2 = high + low; high has 33 bits, so whole * high is exact up to 2^20 quarter turns.
    constexpr double high = 1.57079632673412561417e+00, low = 6.07710050650619224932e-11;
    const double x = (angle - whole * high) - whole * low, x2 = x * x;
    const double s =
        x + x * x2 *
                (-1.0 / 6 +
                 x2 * (1.0 / 120 + x2 * (-1.0 / 5040 +
                                         x2 * (1.0 / 362880 + x2 * (-1.0 / 39916800 +
                                                                    x2 * (1.0 / 6227020800.0))))));
    const double c =
        1 + x2 * (-0.5 +
                  x2 * (1.0 / 24 +
                        x2 * (-1.0 / 720 +
                              x2 * (1.0 / 40320 +
                                    x2 * (-1.0 / 3628800 +
                                          x2 * (1.0 / 479001600 - x2 * (1.0 / 87178291200.0)))))));
    const double quarter = whole - 4 * std::floor(whole * 0.25);
    if (quarter == 0) return {s, c};
    if (quarter == 1) return {c, -s};
    if (quarter == 2) return {-s, -c};
    return {-c, s};
}

/// Returns the angle of the point (x, y) from the x axis in radians, in -pi..pi; 0 for the origin.
/// The error is below 1e-14.
///
/// Reduction to |t| <= tan(pi/8), then the series of the arc tangent.
inline double arc_tangent(double y, double x) {
    const double ax = absolute(x), ay = absolute(y);
    if (ax == 0 && ay == 0) return 0;
    const bool steep = ay > ax;
    double t = steep ? ax / ay : ay / ax, base = 0;
    if (t > 0.41421356237309504880) {
        t = (t - 1) / (t + 1);
        base = pi / 4;
    }
    const double t2 = t * t;
    double sum = 0;
    for (int k = 37; k >= 1; k -= 2) sum = 1.0 / k - t2 * sum;
    double angle = base + t * sum;
    if (steep) angle = pi / 2 - angle;
    if (x < 0) angle = pi - angle;
    return y < 0 ? -angle : angle;
}

}  // namespace jostle::physics
