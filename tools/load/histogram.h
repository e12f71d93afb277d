// SPDX-License-Identifier: MIT
//
// A histogram of durations in microseconds with a relative resolution of 3 %, from 1 us to one day,
// in a few kilobytes of memory. One thread adds; histograms of several threads are merged
// afterwards.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace jostle::load {

class Histogram {
public:
    void add(std::int64_t us);  // negative values count as 0
    void merge(const Histogram& other);

    std::uint64_t count() const { return count_; }
    // The p-th percentile (0..100) in us: the middle of its bucket, at most the maximum. 0 without
    // values.
    double percentile(double p) const;
    std::int64_t max() const { return max_; }

private:
    // Values below 2 * fine have one bucket each; above, each power of two has `fine` buckets.
    static constexpr unsigned fine_bits = 5, value_bits = 37;
    static constexpr std::size_t fine = 1u << fine_bits;

    static std::size_t bucket_of(std::uint64_t value);
    static double bucket_center(std::size_t bucket);

    std::array<std::uint64_t, (value_bits - fine_bits + 1) * fine> counts_{};
    std::uint64_t count_ = 0;
    std::int64_t max_ = 0;
};

// Percentiles of a histogram, ms.
struct Percentiles {
    std::uint64_t count = 0;  // 0: the other values are meaningless
    double p50 = 0, p90 = 0, p99 = 0, p99_9 = 0, max = 0;
};
Percentiles percentiles_of(const Histogram& histogram);

}  // namespace jostle::load
