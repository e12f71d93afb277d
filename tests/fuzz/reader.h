// SPDX-License-Identifier: MIT
//
// Takes an input apart: numbers and records. Past the end it gives zeros and nothing, so that every
// input means something.
#pragma once

#include <algorithm>
#include <cstring>

#include "tests/fuzz/target.h"

namespace jostle::fuzz {

class Reader {
public:
    explicit Reader(Bytes input) : left_(input) {}

    bool done() const { return left_.empty(); }
    Bytes rest() const { return left_; }
    Bytes take(std::size_t size) {
        const Bytes taken = left_.first(std::min(size, left_.size()));
        left_ = left_.subspan(taken.size());
        return taken;
    }
    // Little-endian.
    template <class T>
    T number() {
        T value{};
        const Bytes bytes = take(sizeof value);
        if (!bytes.empty()) std::memcpy(&value, bytes.data(), bytes.size());
        return value;
    }

private:
    Bytes left_;
};

// Conversations are records: what happens, and the bytes that go with it.
struct Record {
    std::uint8_t kind = 0;
    Bytes bytes;
};

inline constexpr std::size_t record_head_bytes = 3;  // u8 kind, u16 size

inline Record take_record(Reader& in) {
    Record record;
    record.kind = in.number<std::uint8_t>();
    record.bytes = in.take(in.number<std::uint16_t>());
    return record;
}

}  // namespace jostle::fuzz
