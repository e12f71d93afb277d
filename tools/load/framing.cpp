// SPDX-License-Identifier: MIT
#include "tools/load/framing.h"

namespace jostle::load {

namespace {

constexpr std::size_t length_size = 4;

std::size_t length_of(Bytes bytes) {
    return bytes[0] | std::size_t{bytes[1]} << 8 | std::size_t{bytes[2]} << 16 |
           std::size_t{bytes[3]} << 24;
}

}  // namespace

Status RawFraming::take(Bytes bytes, Reader& reader) {
    std::string all;
    if (!partial_.empty()) {
        all = std::move(partial_);
        partial_.clear();
        all.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        bytes = {reinterpret_cast<const std::uint8_t*>(all.data()), all.size()};
    }
    while (bytes.size() >= length_size) {
        const std::size_t size = length_of(bytes);
        if (size > message_bytes_max)
            return Error{ErrorCode::corrupt_data,
                         "received a message of " + std::to_string(size) + " bytes"};
        if (bytes.size() - length_size < size) break;
        reader.on_message(bytes.subspan(length_size, size));
        bytes = bytes.subspan(length_size + size);
    }
    partial_.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return {};
}

void RawFraming::send(std::string_view message) {
    for (unsigned k = 0; k < length_size; k++)
        out_.push_back(static_cast<char>(message.size() >> (8 * k)));
    out_ += message;
}

}  // namespace jostle::load
