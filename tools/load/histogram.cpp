// SPDX-License-Identifier: MIT
#include "tools/load/histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace jostle::load {

std::size_t Histogram::bucket_of(std::uint64_t value) {
    if (value < 2 * fine) return static_cast<std::size_t>(value);
    const auto shift = static_cast<unsigned>(std::bit_width(value)) - fine_bits - 1;
    return shift * fine + static_cast<std::size_t>(value >> shift);
}

double Histogram::bucket_center(std::size_t bucket) {
    if (bucket < 2 * fine) return static_cast<double>(bucket);
    const std::size_t shift = bucket / fine - 1;
    const double low =
        std::ldexp(static_cast<double>(bucket - shift * fine), static_cast<int>(shift));
    return low + 0.5 * (std::ldexp(1.0, static_cast<int>(shift)) - 1);
}

void Histogram::add(std::int64_t us) {
    constexpr std::int64_t largest = (std::int64_t{1} << value_bits) - 1;
    us = std::clamp(us, std::int64_t{0}, largest);
    counts_[bucket_of(static_cast<std::uint64_t>(us))]++;
    count_++;
    max_ = std::max(max_, us);
}

void Histogram::merge(const Histogram& other) {
    for (std::size_t k = 0; k < counts_.size(); k++) counts_[k] += other.counts_[k];
    count_ += other.count_;
    max_ = std::max(max_, other.max_);
}

double Histogram::percentile(double p) const {
    if (count_ == 0) return 0;
    const auto rank = static_cast<std::uint64_t>(p / 100 * static_cast<double>(count_ - 1) + 0.5);
    std::uint64_t passed = 0;
    for (std::size_t k = 0; k < counts_.size(); k++) {
        passed += counts_[k];
        if (passed > rank) return std::min(bucket_center(k), static_cast<double>(max_));
    }
    return static_cast<double>(max_);
}

Percentiles percentiles_of(const Histogram& h) {
    const auto ms = [&](double p) { return h.percentile(p) / 1000; };
    return {.count = h.count(),
            .p50 = ms(50),
            .p90 = ms(90),
            .p99 = ms(99),
            .p99_9 = ms(99.9),
            .max = static_cast<double>(h.max()) / 1000};
}

}  // namespace jostle::load
