// SPDX-License-Identifier: MIT
//
// Field list visitor that computes state_hash().
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "physics/src/foundation/byte_stream.h"
#include "physics/src/foundation/hash.h"
#include "physics/src/serialization/shared_geometry.h"

namespace jostle::physics {

struct HashVisitor {
    static constexpr bool kLoading = false;
    Hasher hasher;

    void enter(std::string_view) {}
    void enter(std::size_t) {}
    void leave() {}
    template <class T>
    void field(std::string_view, T& value) {
        hasher.add(bits_of(value));
    }
    template <class T>
    void optional(std::string_view name, T& value, std::uint32_t) {
        if (value != T{}) field(name, value);
    }
    template <class T>
    void unhashed(std::string_view, T&, std::uint32_t) {}
    std::size_t count(std::string_view, std::size_t size) {
        hasher.add(size);
        return size;
    }
    template <class Data>
    void shared(std::string_view, std::shared_ptr<const Data>& data) {
        hasher.add(data->content_hash);
    }
};

}  // namespace jostle::physics
