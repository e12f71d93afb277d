// SPDX-License-Identifier: MIT
//
// An array that begins with nothing in it: where 128 points may be needed and four are, zeroing all
// of them takes longer than finding the four.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

namespace jostle::physics {

template <class T, std::size_t N>
class Room {
public:
    static_assert(std::is_trivially_copyable_v<T> && std::is_aggregate_v<T>);

    // An element is read after it was written, not before.
    template <class Index>
    T& operator[](Index k) {
        return data()[k];
    }
    template <class Index>
    const T& operator[](Index k) const {
        return data()[k];
    }
    T* data() { return std::launder(reinterpret_cast<T*>(bytes_)); }
    const T* data() const { return std::launder(reinterpret_cast<const T*>(bytes_)); }

private:
    alignas(T) std::byte bytes_[N * sizeof(T)];  // arrays of bytes create what is put there (C++20)
};

}  // namespace jostle::physics
