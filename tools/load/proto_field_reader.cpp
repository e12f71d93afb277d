// SPDX-License-Identifier: MIT
#include "tools/load/proto_field_reader.h"

namespace jostle::load {

bool ProtoFieldReader::next(Field& field) {
    if (remaining_.empty() || malformed_) return false;
    std::uint64_t tag = 0;
    malformed_ = !read_varint(tag) || tag > 0xffff'ffff || tag >> 3 == 0;
    if (malformed_) return false;
    field = {.number = static_cast<std::uint32_t>(tag >> 3)};
    malformed_ = !read_value(field, static_cast<unsigned>(tag & 7));
    return !malformed_;
}

bool ProtoFieldReader::read_value(Field& field, unsigned wire_type) {
    switch (wire_type) {
        case 0:
            return read_varint(field.value);
        case 1:
            return read_fixed(field.value, 8);
        case 2: {
            std::uint64_t size = 0;
            if (!read_varint(size) || size > remaining_.size()) return false;
            field.bytes = remaining_.first(static_cast<std::size_t>(size));
            remaining_ = remaining_.subspan(static_cast<std::size_t>(size));
            return true;
        }
        case 5:
            return read_fixed(field.value, 4);
        default:
            return false;  // groups, which proto3 does not have
    }
}

bool ProtoFieldReader::read_varint(std::uint64_t& value) {
    value = 0;
    for (unsigned k = 0; k < 10 && k < remaining_.size(); k++) {
        value |= std::uint64_t{remaining_[k] & 0x7fu} << (7 * k);
        if ((remaining_[k] & 0x80) != 0) continue;
        remaining_ = remaining_.subspan(k + 1);
        return true;
    }
    return false;
}

bool ProtoFieldReader::read_fixed(std::uint64_t& value, std::size_t size) {
    if (remaining_.size() < size) return false;
    value = 0;
    for (std::size_t k = 0; k < size; k++) value |= std::uint64_t{remaining_[k]} << (8 * k);
    remaining_ = remaining_.subspan(size);
    return true;
}

}  // namespace jostle::load
