// SPDX-License-Identifier: MIT
//
// Arrays without initialization. If 128 points may be needed and four are, zeroing all of them
// takes longer than computing the four.
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

    // Read an element only after writing it.
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
    // a byte array implicitly creates the objects stored in it (C++20).
    alignas(T) std::byte bytes_[N * sizeof(T)];
};

// The same with dynamic size. Pages that are never written take no physical memory.
template <class T>
class UninitializedVector {
public:
    static_assert(std::is_trivially_copyable_v<T> && std::is_aggregate_v<T>);
    static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

    // Discards the content.
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
