// SPDX-License-Identifier: MIT
//
// A vector of trivially copyable records whose copy assignment bypasses the caches. A copy of a
// world is larger than the caches of a core, and an ordinary store first reads the cache line that
// it overwrites. Takes 0.6 of the time of std::vector's assignment (docs/records/lab_diary.md,
// "Keeping and restoring 5000 bodies").
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace jostle::physics {

// Same as memcpy with non-temporal stores. `to` is aligned to 16 bytes.
inline void copy_past_caches(void* to, const void* from, std::size_t bytes) {
    std::size_t done = 0;
#if defined(__SSE2__)
    auto* target = static_cast<std::byte*>(to);
    const auto* source = static_cast<const std::byte*>(from);
    for (; done + 64 <= bytes; done += 64) {
        // The hardware prefetches within a page only.
        _mm_prefetch(reinterpret_cast<const char*>(source + done + 1024), _MM_HINT_T0);
        __m128i part[4];
        for (int k = 0; k < 4; k++)
            part[k] = _mm_loadu_si128(reinterpret_cast<const __m128i*>(source + done) + k);
        for (int k = 0; k < 4; k++)
            _mm_stream_si128(reinterpret_cast<__m128i*>(target + done) + k, part[k]);
    }
    _mm_sfence();  // non-temporal stores are not ordered by later release operations
#endif
    if (done < bytes)
        std::memcpy(static_cast<std::byte*>(to) + done, static_cast<const std::byte*>(from) + done,
                    bytes - done);
}

template <class T>
class FlatArray : public std::vector<T> {
public:
    using std::vector<T>::vector;
    FlatArray(const FlatArray&) = default;
    FlatArray(FlatArray&&) noexcept = default;
    FlatArray& operator=(FlatArray&&) noexcept = default;
    ~FlatArray() = default;

    FlatArray& operator=(const FlatArray& other) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (this == &other) return *this;
        const std::size_t bytes = other.size() * sizeof(T);
        // Small arrays should remain in the core's cache.
        if (bytes < 128 * 1024 || this->capacity() < other.size()) {
            std::vector<T>::operator=(other);
            return *this;
        }
        this->resize(other.size());
        copy_past_caches(this->data(), other.data(), bytes);
        return *this;
    }
};

}  // namespace jostle::physics
