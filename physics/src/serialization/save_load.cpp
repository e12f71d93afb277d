// SPDX-License-Identifier: MIT
//
// Conversion of a world to bytes and back: a header (magic, version, length, checksum of the rest),
// then the field list.
#include "jostle/physics/serialization.h"
#include "jostle/physics/world.h"
#include "physics/src/serialization/byte_visitors.h"
#include "physics/src/serialization/checksum.h"
#include "physics/src/serialization/derive.h"
#include "physics/src/serialization/field_list.h"
#include "physics/src/serialization/saved_world.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"

namespace jostle::physics {
namespace {

constexpr std::uint64_t magic = 0x31444c524f574a00ull;  // "\0JWORLD1"
// docs/design/format_changes.md has one line per version. Older versions lack optional fields of
// the field list.
constexpr std::uint32_t version = saved_world_version, oldest_version = 8;
constexpr std::size_t length_at = 8 + 4, checksum_at = length_at + 8,
                      header_bytes = checksum_at + 8;

bool is_supported(std::uint32_t found_version) {
    return oldest_version <= found_version && found_version <= version;
}

// Estimated size of a saved world. Numerous records take fewer bytes than in memory.
std::size_t expected_bytes(const WorldStores& world) {
    std::size_t lanes = 0;
    for (const ColourSet& set : world.graph.sets) lanes += static_cast<std::size_t>(set.contacts);
    return 4096 + world.bodies.cold.size() * (sizeof(BodyCold) + sizeof(BodyWarm)) +
           world.shapes.shapes.size() * sizeof(ShapeRecord) +
           world.joints.joints.size() * sizeof(Joint) +
           world.contacts.contacts.size() * sizeof(Contact) +
           world.contacts.bounds.size() * sizeof(SeparationBound) + lanes * sizeof(SavedContact);
}

Error corrupt(std::string message) {
    return {ErrorCode::corrupt_data, "saved world: " + std::move(message)};
}

}  // namespace

void begin_saved_world(Saver& saver, const WorldStores& stores) {
    ByteWriter& out = saver.out;
    out.reserve(expected_bytes(stores));
    out.write(magic);
    out.write(version);
    out.write(std::uint64_t{0});  // length and checksum, known at the end
    out.write(std::uint64_t{0});
    saver.table.collect(stores.shapes);
    saver.table.write(out);
}

std::vector<std::byte> end_saved_world(Saver& saver) {
    ByteWriter& out = saver.out;
    const std::span<const std::byte> rest = out.bytes().subspan(header_bytes);
    out.write_at(length_at, static_cast<std::uint64_t>(rest.size()));
    out.write_at(checksum_at, checksum(rest));
    return out.take();
}

std::vector<std::byte> save(const World& world) {
    // The field list takes non-const references because loading uses it too; saving changes
    // nothing.
    auto& state = const_cast<WorldState&>(state_of(world));
    Saver saver;
    begin_saved_world(saver, state);
    visit_world(saver, state);
    return end_saved_world(saver);
}

std::uint32_t saved_format_version() {
    return version;
}

bool has_unsupported_version(std::span<const std::byte> bytes) {
    ByteReader header(bytes);
    const auto found_magic = header.read_bits<std::uint64_t>();
    const auto found_version = header.read_bits<std::uint32_t>();
    return !header.failed() && found_magic == magic && !is_supported(found_version);
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
    if (found_magic != magic)
        return corrupt("it does not begin with the magic number of a saved world");
    if (!is_supported(found_version))
        return corrupt("it has format version " + std::to_string(found_version) +
                       "; this library reads versions " + std::to_string(oldest_version) + " to " +
                       std::to_string(version));
    if (length != header.left())
        return corrupt("its header states that " + std::to_string(length) +
                       " bytes follow, but there are " + std::to_string(header.left()));
    const std::span<const std::byte> rest = bytes.subspan(header_bytes);
    if (checksum_of_version(found_version, rest) != expected)
        return corrupt("its checksum does not match: the data is damaged");

    auto state = std::make_unique<WorldState>();
    Loader loader{.in = ByteReader(rest), .version = found_version, .header_bytes = header_bytes};
    if (const auto fault = loader.table.read(loader.in))
        return corrupt(*fault + " (at byte " + std::to_string(header_bytes + loader.in.at()) + ")");
    visit_world(loader, *state);
    if (!loader.error.empty()) return corrupt(loader.error);
    if (loader.in.left() != 0)
        return corrupt(std::to_string(loader.in.left()) + " bytes remain after the last field");
    if (const auto fault = find_fault(*state)) return corrupt(*fault);
    derive_all(*state);
    state->thread_pool = std::make_unique<ThreadPool>(1);
    World world(std::move(state));
    for (const std::unique_ptr<Module>& module : state_of(world).listeners.modules)
        module->restored(world);
    return world;
}

}  // namespace jostle::physics
