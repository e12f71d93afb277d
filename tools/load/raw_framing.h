// SPDX-License-Identifier: MIT
//
// Messages with a four-byte little-endian length prefix: the minimum for a stream over TCP. Only
// benchmark servers use it, as a lower bound for the other transports.
#pragma once

#include "tools/load/framing.h"

namespace jostle::load {

class RawFraming : public Framing {
public:
    Status take(Bytes bytes, Reader& reader) override;
    void send(std::string_view message) override;
    void consume(std::size_t) override {}

private:
    std::string partial_;  // of an incomplete message
};

}  // namespace jostle::load
