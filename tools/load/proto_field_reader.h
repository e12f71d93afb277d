// SPDX-License-Identifier: MIT
//
// Walks over the fields of a protobuf message where it lies, without making anything of it: a sink
// that gets sixty thousand messages a second wants two numbers of each. Bytes are foreign; what is
// cut off or no field ends the walk as broken.
#pragma once

#include <cstdint>
#include <span>

namespace jostle::load {

using Bytes = std::span<const std::uint8_t>;

struct Field {
    std::uint32_t number = 0;
    std::uint64_t value = 0;  // of a varint, a fixed32 or a fixed64
    Bytes bytes;              // of what has a length
};

class ProtoFieldReader {
public:
    explicit ProtoFieldReader(Bytes message) : remaining_(message) {}

    // False: that was all, or broken().
    bool next(Field& field);
    bool malformed() const { return malformed_; }

private:
    bool read_varint(std::uint64_t& value);
    bool read_fixed(std::uint64_t& value, std::size_t size);
    bool read_value(Field& field, unsigned wire_type);

    Bytes remaining_;
    bool malformed_ = false;
};

}  // namespace jostle::load
