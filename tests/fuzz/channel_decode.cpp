// SPDX-License-Identifier: MIT
//
// Packed channels from a stranger, each against those before them that could be read. What could be
// read says the same when it is packed and read again. The CRC of most is put right, or nothing
// would come past it.
#include <deque>

#include "jostle/snapshot/channel_codec.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"
#include "tests/proto/snapshot/channel_motion.h"

namespace jostle::fuzz {

void run(Bytes input) {
    Reader in(input);
    std::deque<snapshot::Channels> ring{{}};
    while (!in.done()) {
        const Record record = take_record(in);
        const snapshot::Channels& baseline = ring[record.kind % ring.size()];
        const auto bytes = bytes_of(record.bytes);
        const auto told = snapshot::read_channels(bytes, baseline);
        if (!told.ok()) {
            expect(!told.error().message.empty(), "a refusal has a reason");
            continue;
        }
        const auto checked = snapshot::decode_channels(bytes, told->crc, baseline);
        expect(checked.ok(), "what can be read is taken with its CRC");
        const auto packed = snapshot::encode_channels(told->channels, baseline, ~std::uint64_t{0});
        const auto again = snapshot::decode_channels(packed.bytes, packed.crc, baseline);
        expect(again.ok() && snapshot::same_channels(*again, told->channels),
               "channels are the same when they were sent on");
        ring.push_back(told->channels);
        if (ring.size() > 8) ring.pop_front();
    }
}

}  // namespace jostle::fuzz
