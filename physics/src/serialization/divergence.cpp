// SPDX-License-Identifier: MIT
//
// Converts the first world to a list of bits, then compares the second world with it, and stops at
// the first difference.
#include <cstdio>

#include "jostle/physics/serialization.h"
#include "jostle/physics/world.h"
#include "physics/src/foundation/byte_stream.h"
#include "physics/src/serialization/field_list.h"
#include "physics/src/serialization/path.h"
#include "physics/src/serialization/shared_geometry.h"
#include "physics/src/state/world_access.h"

namespace jostle::physics {
namespace {

struct Recorder {
    static constexpr bool kLoading = false;
    std::vector<std::uint64_t> bits;

    void enter(std::string_view) {}
    void enter(std::size_t) {}
    void leave() {}
    template <class T>
    void field(std::string_view, T& value) {
        bits.push_back(bits_of(value));
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
        bits.push_back(size);
        return size;
    }
    template <class Data>
    void shared(std::string_view, std::shared_ptr<const Data>& data) {
        bits.push_back(data->content_hash);
    }
};

template <class T>
std::string text_of(T value) {
    if constexpr (std::is_floating_point_v<T>) {
        char buffer[40];
        std::snprintf(buffer, sizeof buffer, "%.17g", static_cast<double>(value));
        return buffer;
    } else {
        return std::to_string(bits_of(value));
    }
}

template <class T>
T from_bits(std::uint64_t bits) {
    if constexpr (std::is_floating_point_v<T>)
        return std::bit_cast<T>(static_cast<decltype(bits_of(T{}))>(bits));
    else
        return static_cast<T>(bits);
}

struct Comparer {
    static constexpr bool kLoading = false;
    const std::vector<std::uint64_t>& first;
    std::size_t at = 0;
    Path path;
    std::optional<std::string> difference;

    void enter(std::string_view name) { path.enter(name); }
    void enter(std::size_t index) { path.enter(index); }
    void leave() { path.leave(); }
    template <class T>
    void field(std::string_view name, T& value) {
        if (difference) return;
        if (at >= first.size()) {
            difference = path.text(name) + ": only the second world has it";
        } else if (first[at] != bits_of(value)) {
            difference = path.text(name) + ": " + text_of(from_bits<T>(first[at])) + " against " +
                         text_of(value);
        }
        at++;
    }
    template <class Data>
    void shared(std::string_view name, std::shared_ptr<const Data>& data) {
        auto hash = data->content_hash;
        field(name, hash);
    }
    template <class T>
    void optional(std::string_view name, T& value, std::uint32_t) {
        field(name, value);
    }
    template <class T>
    void unhashed(std::string_view name, T& value, std::uint32_t) {
        field(name, value);
    }
    std::size_t count(std::string_view name, std::size_t size) {
        auto wide = static_cast<std::uint64_t>(size);
        field(name, wide);
        return size;
    }
};

}  // namespace

std::optional<std::string> first_difference(const World& a, const World& b) {
    Recorder recorder;
    visit_world(recorder, const_cast<WorldState&>(state_of(a)));
    Comparer comparer{.first = recorder.bits, .at = 0, .path = {}, .difference = {}};
    visit_world(comparer, const_cast<WorldState&>(state_of(b)));
    return comparer.difference;
}

}  // namespace jostle::physics
