// SPDX-License-Identifier: MIT
//
// An array that begins with nothing in it: where 128 points may be needed and four are, zeroing all
// of them takes longer than finding the four.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace jostle::physics {

template <class T, std::size_t N>
class UninitializedArray {
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

// The same for as many as are asked for: what is never written takes no memory of the machine.
template <class T>
class UninitializedVector {
public:
    static_assert(std::is_trivially_copyable_v<T> && std::is_aggregate_v<T>);
    static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

    // Of what was there nothing is kept.
    void reserve_discarding(std::size_t count) {
        if (count <= count_) return;
        bytes_.reset();
        count_ = 2 * count;
        bytes_ = std::make_unique_for_overwrite<std::byte[]>(count_ * sizeof(T));
    }
    T& operator[](std::size_t k) { return std::launder(reinterpret_cast<T*>(bytes_.get()))[k]; }

private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t count_ = 0;
};

}  // namespace jostle::physics
