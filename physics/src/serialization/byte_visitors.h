// SPDX-License-Identifier: MIT
//
// Field list visitors that write and read bytes. Untrusted bytes are checked field by field; the
// first error is recorded with its path and byte position.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "jostle/physics/defs.h"
#include "jostle/physics/scalar.h"
#include "physics/src/foundation/byte_stream.h"
#include "physics/src/serialization/path.h"
#include "physics/src/serialization/shared_geometry.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

inline constexpr std::uint32_t saved_world_version = 20;

struct Saver {
    static constexpr bool kLoading = false;
    ByteWriter out;
    SharedGeometry table;

    void enter(std::string_view) {}
    void enter(std::size_t) {}
    void leave() {}
    template <class T>
    [[gnu::always_inline]] void field(std::string_view, T& value) {
        out.write(value);
    }
    template <class T>
    void optional(std::string_view name, T& value, std::uint32_t) {
        field(name, value);
    }
    template <class T>
    void unhashed(std::string_view name, T& value, std::uint32_t) {
        field(name, value);
    }
    std::size_t count(std::string_view, std::size_t size) {
        out.write(static_cast<std::uint64_t>(size));
        return size;
    }
    template <class Data>
    void shared(std::string_view, std::shared_ptr<const Data>& data) {
        out.write(table.index_of(data));
    }
};

template <class T>
constexpr std::uint64_t largest_value() {
    if constexpr (std::is_same_v<T, Combine>) return 4;
    if constexpr (std::is_same_v<T, SolverTier>) return static_cast<int>(SolverTier::direct);
    return 2;  // BodyType, BodySet, JointSolver
}

struct Loader {
    static constexpr bool kLoading = true;
    ByteReader in;
    std::uint32_t version;         // of the bytes
    std::size_t header_bytes = 0;  // number of bytes before `in`, for messages
    SharedGeometry table = {};
    Path path = {};
    std::string error = {};

    void enter(std::string_view name) { path.enter(name); }
    void enter(std::size_t index) { path.enter(index); }
    void leave() { path.leave(); }
    [[gnu::noinline, gnu::cold]] void fail(std::string_view field, std::string_view what) {
        if (error.empty())
            error = path.text(field) + " " + std::string(what) + " (at byte " +
                    std::to_string(header_bytes + in.at()) + ")";
    }

    template <class T>
    [[gnu::always_inline]] void field(std::string_view name, T& value) {
        if (!error.empty()) return;
        const auto bits = in.read_bits<T>();
        if (in.failed()) return fail(name, "is missing: the data ends before it");
        if constexpr (std::is_same_v<T, bool>) {
            if (bits > 1) return fail(name, "is neither 0 nor 1");
            value = bits == 1;
        } else if constexpr (std::is_enum_v<T>) {
            // Enumerators start at 0.
            if (bits > largest_value<T>()) return fail(name, "is not one of its values");
            value = static_cast<T>(bits);
        } else if constexpr (std::is_floating_point_v<T>) {
            value = std::bit_cast<T>(bits);
            if (!is_finite(double{value})) fail(name, "is not finite");
        } else {
            value = static_cast<T>(bits);
        }
    }
    template <class T>
    void optional(std::string_view name, T& value, std::uint32_t since) {
        if (version >= since) field(name, value);
    }
    template <class T>
    void unhashed(std::string_view name, T& value, std::uint32_t since) {
        if (version >= since) field(name, value);
    }
    template <class Data>
    void shared(std::string_view name, std::shared_ptr<const Data>& data) {
        std::uint32_t index = 0;
        field(name, index);
        if (!error.empty()) return;
        data = table.at<Data>(index);
        if (!data) fail(name, "does not refer to a shared geometry of its kind");
    }
    // An array cannot be longer than the remaining bytes, so untrusted data cannot cause an
    // allocation larger than itself.
    std::size_t count(std::string_view name, std::size_t) {
        if (!error.empty()) return 0;
        const std::uint64_t size = in.read_bits<std::uint64_t>();
        if (in.failed()) {
            fail(name, "is missing: the data ends before it");
            return 0;
        }
        if (size > in.left()) {
            fail(name, "is larger than the data that follows");
            return 0;
        }
        return static_cast<std::size_t>(size);
    }
};

}  // namespace jostle::physics
