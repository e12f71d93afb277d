// SPDX-License-Identifier: MIT
//
// Packed frames from a stranger, each against those before it that could be read. What could be
// read says the same when it is written and read again.
#include "tests/fuzz/frames.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    Reader in(input);
    const snapshot::QuantSpec spec = take_spec(in);
    FrameRing ring;
    while (!in.done()) {
        const Record record = take_record(in);
        Reader head(record.bytes);
        // Mostly the next one, seldom so far ahead that it is refused.
        const std::uint32_t number = ring.newest() + 1 + head.number<std::uint8_t>();
        const snapshot::Baselines baselines = ring.baselines(record.kind);
        const snapshot::Codec codec = codec_of(record.kind);
        const auto frame = snapshot::decode_frame(number, bytes_of(head.rest()), baselines, spec,
                                                  snapshot::default_entities_max, codec);
        if (!frame.ok()) {
            expect(!frame.error().message.empty(), "a refusal has a reason");
            continue;
        }
        const auto packed = snapshot::encode_frame(*frame, baselines, spec, codec);
        const auto again = snapshot::decode_frame(number, packed, baselines, spec,
                                                  snapshot::default_entities_max, codec);
        expect(again.ok() && *again == *frame, "a frame is the same when it was sent on");
        expect(snapshot::frame_crc(*again) == snapshot::frame_crc(*frame), "and so is its CRC");
        ring.add(std::move(*frame));
    }
}

}  // namespace jostle::fuzz
