// SPDX-License-Identifier: MIT
//
// Counts of durations in microseconds, by size: as fine as 3 % of a value, from 1 us to a day, in a
// few kilobytes however many are added. One thread adds; histograms of threads are merged after.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace jostle::load {

class Histogram {
public:
    void add(std::int64_t us);  // below 0 counts as 0
    void merge(const Histogram& other);

    std::uint64_t count() const { return count_; }
    // The p-th percentile (0..100), us; 0 without counts. Of a bucket, its middle; never above the
    // largest.
    double percentile(double p) const;
    std::int64_t max() const { return max_; }

private:
    // Values below 2 * fine have a bucket each; above, each power of two has `fine` of them.
    static constexpr unsigned fine_bits = 5, value_bits = 37;
    static constexpr std::size_t fine = 1u << fine_bits;

    static std::size_t bucket_of(std::uint64_t value);
    static double bucket_center(std::size_t bucket);

    std::array<std::uint64_t, (value_bits - fine_bits + 1) * fine> counts_{};
    std::uint64_t count_ = 0;
    std::int64_t max_ = 0;
};

// What is told of a histogram, in ms.
struct Percentiles {
    std::uint64_t count = 0;  // 0: the others say nothing
    double p50 = 0, p90 = 0, p99 = 0, p99_9 = 0, max = 0;
};
Percentiles percentiles_of(const Histogram& histogram);

}  // namespace jostle::load
