// SPDX-License-Identifier: MIT
#include "server/world/attribute_bytes.h"

#include <bit>
#include <utility>
#include <variant>

namespace jostle::server {

namespace {

struct Write {
    ByteWriter& to;

    void operator()(bool value) const { to.number(value ? 1 : 0); }
    // Small magnitudes take few bytes.
    void operator()(std::int64_t value) const {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        to.number(bits << 1 ^ (value < 0 ? ~std::uint64_t{0} : 0));
    }
    void operator()(double value) const { to.real(value); }
    void operator()(const std::string& value) const { to.text(value); }
    void operator()(const physics::Vec3& v) const {
        for (int k = 0; k < 3; k++) to.real(v[k]);
    }
};

std::int64_t read_integer(ByteReader& from) {
    const std::uint64_t bits = from.number();
    return std::bit_cast<std::int64_t>(bits >> 1 ^ (bits & 1 ? ~std::uint64_t{0} : 0));
}

}  // namespace

void write_attribute_value(ByteWriter& to, const AttributeValue& value) {
    to.number(value.index());
    std::visit(Write{to}, value);
}

AttributeValue read_attribute_value(ByteReader& from) {
    switch (from.number()) {
        case 0:
            return from.number() != 0;
        case 1:
            return read_integer(from);
        case 2:
            return from.real();
        case 3:
            return std::string(from.text());
        case 4: {
            physics::Vec3 v;
            v.x = from.real(), v.y = from.real(), v.z = from.real();
            return v;
        }
        default:
            from.fail();
            return false;
    }
}

}  // namespace jostle::server
