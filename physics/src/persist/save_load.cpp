// SPDX-License-Identifier: MIT
//
// World to bytes and back: a header (magic, version, length, hash of the rest), then the field
// list.
#include "foundation/hash.h"
#include "jostle/physics/snapshot.h"
#include "jostle/physics/world.h"
#include "persist/byte_visitors.h"
#include "persist/derive.h"
#include "persist/field_list.h"
#include "state/validate.h"
#include "state/world_access.h"

namespace jostle::physics {
namespace {

constexpr std::uint64_t magic = 0x31444c524f574a00ull;  // "\0JWORLD1"
// docs/format_changes.md has one line for each. Older ones lack what is optional in the field list.
constexpr std::uint32_t version = saved_world_version, oldest_version = 8;
constexpr std::size_t header_bytes = 8 + 4 + 8 + 8;

std::uint64_t checksum(std::span<const std::byte> bytes) {
    Hasher hasher;
    hasher.add(bytes.size());
    const std::size_t whole = bytes.size() / 8 * 8;
    for (std::size_t at = 0; at < whole; at += 8)
        hasher.add(load_little_endian<std::uint64_t>(&bytes[at]));
    if (whole < bytes.size()) {
        std::uint64_t word = 0;
        for (std::size_t k = 0; whole + k < bytes.size(); k++)
            word |= std::to_integer<std::uint64_t>(bytes[whole + k]) << (8 * k);
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
    body.out.write(magic);
    body.out.write(version);
    for (int k = 0; k < 2; k++) body.out.write(std::uint64_t{0});  // length and checksum: below
    // The list is shared with loading, so it takes references; saving changes nothing.
    auto& state = const_cast<WorldState&>(state_of(world));
    body.table.collect(state.shapes);
    body.table.write(body.out);
    visit_world(body, state);
    std::vector<std::byte>& bytes = body.out.bytes();
    const std::span<const std::byte> rest = std::span(bytes).subspan(header_bytes);
    store_little_endian(&bytes[12], static_cast<std::uint64_t>(rest.size()));
    store_little_endian(&bytes[20], checksum(rest));
    return std::move(bytes);
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
    Loader loader{.in = ByteReader(rest), .version = found_version, .header_bytes = header_bytes};
    if (const auto fault = loader.table.read(loader.in))
        return corrupt(*fault + " (at byte " + std::to_string(header_bytes + loader.in.at()) + ")");
    visit_world(loader, *state);
    if (!loader.error.empty()) return corrupt(loader.error);
    if (loader.in.left() != 0)
        return corrupt(std::to_string(loader.in.left()) + " bytes are left after the last field");
    if (const auto fault = find_fault(*state)) return corrupt(*fault);
    derive_all(*state);
    state->team = std::make_unique<TaskTeam>(1);
    World world(std::move(state));
    for (const std::unique_ptr<Module>& module : state_of(world).listeners.modules)
        module->restored(world);
    return world;
}

}  // namespace jostle::physics
