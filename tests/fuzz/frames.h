// SPDX-License-Identifier: MIT
//
// What both frame targets share: frames that were decoded or made, from which later ones take their
// bases, as a client keeps them.
#pragma once

#include <deque>

#include "jostle/snapshot/frame_codec.h"
#include "tests/fuzz/reader.h"

namespace jostle::fuzz {

class FrameRing {
public:
    void add(snapshot::QuantizedFrame frame) {
        frames_.push_back(std::move(frame));
        if (frames_.size() > ring) frames_.pop_front();
    }
    std::uint32_t newest() const { return frames_.empty() ? 0 : frames_.back().frame; }
    // Two bits each say how far back the next base lies; 0 ends the list.
    snapshot::Baselines baselines(std::uint8_t choice) const {
        snapshot::Baselines baselines;
        const snapshot::QuantizedFrame** slots[] = {&baselines.baseline, &baselines.baseline2,
                                                    &baselines.baseline3};
        std::size_t back = 0;
        for (const auto slot : slots) {
            const std::size_t step = choice & 3;
            choice >>= 2;
            back += step;
            if (step == 0 || back > frames_.size()) break;
            *slot = &frames_[frames_.size() - back];
        }
        return baselines;
    }

private:
    static constexpr std::size_t ring = 32;
    std::deque<snapshot::QuantizedFrame> frames_;
};

// One of both.
inline snapshot::Codec codec_of(std::uint8_t byte) {
    return (byte & 0x80) != 0 ? snapshot::Codec::range : snapshot::Codec::bits;
}

// Mostly what servers use, else anything.
inline snapshot::QuantSpec take_spec(Reader& in) {
    switch (in.number<std::uint8_t>() % 4) {
        case 0:
            return {};
        case 1:
            return {4096, 16383};
        case 2:
            return {snapshot::max_units_per_meter, snapshot::max_rotation_component};
        default: {
            const auto units = in.number<std::int32_t>();
            return {units, in.number<std::int32_t>()};
        }
    }
}

}  // namespace jostle::fuzz
