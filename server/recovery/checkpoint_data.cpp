// SPDX-License-Identifier: MIT
#include "server/recovery/checkpoint_data.h"

#include <span>
#include <utility>
#include <vector>

#include "jostle/physics/serialization.h"
#include "server/storage/compression.h"
#include "server/util/bytes.h"

namespace jostle::server {
namespace {

constexpr std::uint64_t checkpoint_version = 1;
// Decompressed size of one world; 50,000 bodies take a fifth of it.
constexpr std::size_t checkpoint_bytes_max = std::size_t{1} << 30;

Error not_a_checkpoint(const std::string& why) {
    return {ErrorCode::corrupt_data, "corrupt checkpoint: " + why};
}

Error unsupported(const std::string& why) {
    return {ErrorCode::failed_precondition, "unsupported checkpoint: " + why};
}

}  // namespace

Result<CheckpointData> encode_checkpoint(const CheckpointCopy& checkpoint_copy) {
    const Result<physics::RestorePoint::Saved> saved = checkpoint_copy.bodies.save();
    if (!saved.ok()) return saved.error();
    ByteWriter head;
    head.number(checkpoint_version);
    head.text(encode_host_state(checkpoint_copy.host_state));
    head.number(saved->bytes.size());
    const std::string first = head.take();
    const std::string_view pieces[] = {
        first, {reinterpret_cast<const char*>(saved->bytes.data()), saved->bytes.size()}};
    return CheckpointData{saved->hash, compress(pieces)};
}

Result<Checkpoint> make_checkpoint(const HostedWorld& world, std::uint32_t tick,
                                   std::uint64_t sequence) {
    CheckpointCopy copy{.tick = tick, .bodies = {}, .host_state = world.host_state(tick)};
    copy.bodies.capture(world.world());
    Result<CheckpointData> data = encode_checkpoint(copy);
    if (!data.ok()) return data.error();
    return Checkpoint{.tick = tick,
                      .hash = data->hash,
                      .sequence = sequence,
                      .exact = std::move(data->bytes),
                      .portable = {}};
}

Result<DecodedCheckpoint> decode_checkpoint(std::string_view bytes, std::uint64_t hash) {
    const Result<std::string> decompressed = decompress(bytes, checkpoint_bytes_max);
    if (!decompressed.ok()) return decompressed.error();
    ByteReader from(*decompressed);
    if (const std::uint64_t version = from.number(); from.ok() && version != checkpoint_version)
        return unsupported("version " + std::to_string(version) + "; this server reads version " +
                           std::to_string(checkpoint_version));
    const std::string_view host_state_bytes = from.text(), saved = from.text();
    if (!from.ok()) return not_a_checkpoint("unexpected end of data");
    if (!from.at_end()) return not_a_checkpoint("data after the end");
    Result<SavedHostState> host_state = decode_host_state(host_state_bytes);
    if (!host_state.ok()) return host_state.error();
    const auto saved_world = std::as_bytes(std::span(saved));
    Result<physics::World> world = physics::load(saved_world);
    if (!world.ok() && physics::has_unsupported_version(saved_world))
        return unsupported(world.error().message);
    if (!world.ok()) return world.error();
    if (physics::state_hash(*world) != hash) return not_a_checkpoint("state hash mismatch");
    return DecodedCheckpoint{*std::move(world), *std::move(host_state)};
}

}  // namespace jostle::server
