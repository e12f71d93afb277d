// SPDX-License-Identifier: MIT
#include "jostle/snapshot/entity_list.h"

#include <numeric>
#include <string>

#include "jostle/base/check.h"
#include "jostle/snapshot/bit_stream.h"

namespace jostle::snapshot {
namespace {

constexpr unsigned entity_count_order = 4, entity_gap_order = 0;

// Predicts the prototype of an entity: the one that last followed the prototype of the entity
// before it. Scenes create bodies in a repeating order.
class Successors {
public:
    explicit Successors(std::size_t prototypes) : after_(prototypes) {
        std::iota(after_.begin(), after_.end(), 0u);
    }
    std::uint32_t next() const { return after_[previous_]; }
    void add(std::uint32_t prototype) {
        after_[previous_] = prototype;
        previous_ = prototype;
    }

private:
    std::vector<std::uint32_t> after_;
    std::uint32_t previous_ = 0;
};

Error error_at(const std::string& what, const BitReader& in) {
    return {ErrorCode::corrupt_data, what + " (at bit " + std::to_string(in.bit_position()) + ")"};
}

}  // namespace

std::vector<std::byte> encode_entity_list(std::span<const ListedEntity> entities,
                                          std::size_t prototypes) {
    ASSERT(prototypes <= prototypes_max);
    BitWriter out;
    out.exp_golomb(entities.size(), entity_count_order);
    Successors successors(prototypes);
    const unsigned width = prototypes > 1 ? bit_width(prototypes - 1) : 0;
    std::uint32_t next_id = 1;
    for (const ListedEntity& entity : entities) {
        ASSERT(entity.id >= next_id && entity.prototype < prototypes);
        out.exp_golomb(entity.id - next_id, entity_gap_order);
        next_id = entity.id + 1;
        if (width == 0) continue;
        const bool expected = entity.prototype == successors.next();
        out.bits(expected ? 1 : 0, 1);
        if (!expected) out.bits(entity.prototype, width);
        successors.add(entity.prototype);
    }
    return out.finish();
}

Result<std::vector<ListedEntity>> decode_entity_list(std::span<const std::byte> packed,
                                                     std::size_t prototypes,
                                                     std::size_t max_entities) {
    BitReader in(packed);
    if (prototypes == 0 || prototypes > prototypes_max)
        return Error{ErrorCode::corrupt_data, std::to_string(prototypes) +
                                                  " prototypes; there must be 1 to " +
                                                  std::to_string(prototypes_max)};
    const std::uint64_t count = in.exp_golomb(entity_count_order);
    if (in.past_end()) return error_at("truncated data", in);
    // Each entity has at least one bit.
    if (count > max_entities || count > packed.size() * 8)
        return error_at("the number of entities exceeds the limit or the data", in);
    std::vector<ListedEntity> entities;
    entities.reserve(static_cast<std::size_t>(count));
    Successors successors(prototypes);
    const unsigned width = prototypes > 1 ? bit_width(prototypes - 1) : 0;
    std::uint64_t next_id = 1;
    for (std::uint64_t i = 0; i < count; i++) {
        const std::uint64_t id = next_id + in.exp_golomb(entity_gap_order);
        if (id > 0xffffffffull) return error_at("id exceeds 32 bits", in);
        next_id = id + 1;
        std::uint64_t prototype = 0;
        if (width != 0) {
            prototype = in.bits(1) != 0 ? successors.next() : in.bits(width);
            if (prototype >= prototypes) return error_at("unknown prototype", in);
            successors.add(static_cast<std::uint32_t>(prototype));
        }
        if (in.past_end()) return error_at("truncated data", in);
        entities.push_back({static_cast<std::uint32_t>(id), static_cast<std::uint32_t>(prototype)});
    }
    if (!in.at_clean_end()) return error_at("unexpected or missing bits at the end", in);
    return entities;
}

}  // namespace jostle::snapshot
