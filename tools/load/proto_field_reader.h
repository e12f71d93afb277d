// SPDX-License-Identifier: MIT
//
// Iterates over the fields of a protobuf message in place, without parsing it: a passive client
// receives up to 60,000 messages per second and needs two numbers of each. Bytes are untrusted;
// truncated or invalid fields end the iteration as malformed.
#pragma once

#include <cstdint>
#include <span>

namespace jostle::load {

using Bytes = std::span<const std::uint8_t>;

struct Field {
    std::uint32_t number = 0;
    std::uint64_t value = 0;  // of a varint, a fixed32 or a fixed64
    Bytes bytes;              // of a length-delimited field
};

class ProtoFieldReader {
public:
    explicit ProtoFieldReader(Bytes message) : remaining_(message) {}

    // Returns false at the end, or if the message is malformed().
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
