// SPDX-License-Identifier: MIT
//
// World to bytes and back: a header (magic, version, length, hash of the rest), then the field
// list.
#include <cstring>

#include "foundation/byte_stream.h"
#include "foundation/hash.h"
#include "jostle/physics/snapshot.h"
#include "jostle/physics/world.h"
#include "persist/derive.h"
#include "persist/field_list.h"
#include "persist/path.h"
#include "persist/shared_geometry.h"
#include "state/validate.h"
#include "state/world_access.h"

namespace jostle::physics {
namespace {

constexpr std::uint64_t magic = 0x31444c524f574a00ull;  // "\0JWORLD1"
// docs/format_changes.md has one line for each. Version 8 lacks what is optional in the field list.
constexpr std::uint32_t version = 9, oldest_version = 8;
constexpr std::size_t header_bytes = 8 + 4 + 8 + 8;

struct Saver {
    static constexpr bool kLoading = false;
    ByteWriter out;
    SharedGeometry table;

    void enter(std::string_view) {}
    void enter(std::size_t) {}
    void leave() {}
    template <class T>
    void field(std::string_view, T& value) {
        out.write(value);
    }
    template <class T>
    void optional(std::string_view name, T& value) {
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
    if constexpr (std::is_same_v<T, SolverTier>) return tier_count;  // asleep
    return 2;                                                        // BodyType, BodySet
}

struct Loader {
    static constexpr bool kLoading = true;
    ByteReader in;
    bool has_optional;
    SharedGeometry table = {};
    Path path = {};
    std::string error = {};

    void enter(std::string_view name) { path.enter(name); }
    void enter(std::size_t index) { path.enter(index); }
    void leave() { path.leave(); }
    void fail(std::string_view field, std::string_view what) {
        if (error.empty())
            error = path.text(field) + " " + std::string(what) + " (at byte " +
                    std::to_string(header_bytes + in.at()) + ")";
    }

    template <class T>
    void field(std::string_view name, T& value) {
        if (!error.empty()) return;
        const auto bits = in.read_bits<T>();
        if (in.failed()) return fail(name, "is missing: the data ends before it");
        if constexpr (std::is_same_v<T, bool>) {
            if (bits > 1) return fail(name, "is neither 0 nor 1");
            value = bits == 1;
        } else if constexpr (std::is_enum_v<T>) {
            // Enumerations count from 0.
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
    void optional(std::string_view name, T& value) {
        if (has_optional) field(name, value);
    }
    template <class Data>
    void shared(std::string_view name, std::shared_ptr<const Data>& data) {
        std::uint32_t index = 0;
        field(name, index);
        if (!error.empty()) return;
        data = table.at<Data>(index);
        if (!data) fail(name, "names no shared geometry of its kind");
    }
    // No array is longer than the bytes that are left: what a file can make us allocate is bounded
    // by its own size.
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

std::uint64_t checksum(std::span<const std::byte> bytes) {
    Hasher hasher;
    hasher.add(bytes.size());
    for (std::size_t at = 0; at < bytes.size(); at += 8) {
        std::uint64_t word = 0;
        for (std::size_t k = 0; k < 8 && at + k < bytes.size(); k++)
            word |= std::to_integer<std::uint64_t>(bytes[at + k]) << (8 * k);
        hasher.add(word);
    }
    return hasher.value;
}

Error corrupt(std::string message) {
    return {ErrorCode::corrupt_data, "saved world: " + std::move(message)};
}

}  // namespace

std::vector<std::byte> save(const World& world) {
    Saver body;
    // The list is shared with loading, so it takes references; saving changes nothing.
    auto& state = const_cast<WorldState&>(state_of(world));
    body.table.collect(state);
    body.table.write(body.out);
    visit_world(body, state);
    ByteWriter out;
    out.write(magic);
    out.write(version);
    out.write(static_cast<std::uint64_t>(body.out.bytes().size()));
    out.write(checksum(body.out.bytes()));
    out.bytes().insert(out.bytes().end(), body.out.bytes().begin(), body.out.bytes().end());
    return std::move(out.bytes());
}

Result<World> load(std::span<const std::byte> bytes) {
    ByteReader header(bytes);
    const auto found_magic = header.read_bits<std::uint64_t>();
    const auto found_version = header.read_bits<std::uint32_t>();
    const auto length = header.read_bits<std::uint64_t>();
    const auto expected = header.read_bits<std::uint64_t>();
    if (header.failed())
        return corrupt("it has " + std::to_string(bytes.size()) +
                       " bytes, fewer than the header's " + std::to_string(header_bytes));
    if (found_magic != magic) return corrupt("it does not begin with the mark of a Jostle world");
    if (found_version < oldest_version || found_version > version)
        return corrupt("it has format version " + std::to_string(found_version) +
                       "; this library reads versions " + std::to_string(oldest_version) + " to " +
                       std::to_string(version));
    if (length != header.left())
        return corrupt("its header says " + std::to_string(length) + " bytes follow, there are " +
                       std::to_string(header.left()));
    const std::span<const std::byte> rest = bytes.subspan(header_bytes);
    if (checksum(rest) != expected)
        return corrupt("its checksum does not match: bytes were changed");

    auto state = std::make_unique<WorldState>();
    Loader loader{.in = ByteReader(rest), .has_optional = found_version > 8};
    if (const auto fault = loader.table.read(loader.in))
        return corrupt(*fault + " (at byte " + std::to_string(header_bytes + loader.in.at()) + ")");
    visit_world(loader, *state);
    if (!loader.error.empty()) return corrupt(loader.error);
    if (loader.in.left() != 0)
        return corrupt(std::to_string(loader.in.left()) + " bytes are left after the last field");
    if (const auto fault = find_fault(*state)) return corrupt(*fault);
    derive_all(*state);
    state->team = std::make_unique<TaskTeam>(1);
    return World(std::move(state));
}

}  // namespace jostle::physics
