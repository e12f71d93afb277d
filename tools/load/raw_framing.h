// SPDX-License-Identifier: MIT
//
// Messages with nothing but their length before them, four bytes, little end first: the least that
// a stream over TCP needs. Only servers of benchmarks speak it: it is the floor under the others.
#pragma once

#include "tools/load/framing.h"

namespace jostle::load {

class RawFraming : public Framing {
public:
    Status take(Bytes bytes, Reader& reader) override;
    void send(std::string_view message) override;
    void consume(std::size_t) override {}

private:
    std::string partial_;  // of a message that is not complete
};

}  // namespace jostle::load
