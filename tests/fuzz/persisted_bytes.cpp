// SPDX-License-Identifier: MIT
//
// What is kept of a hosted world: an image of what it is beside its bodies, a journal of commands,
// what it is made of, a checkpoint. What is read is the same when it is written and read again; all
// else is refused.
#include "server/recovery/checkpoint_data.h"
#include "server/recovery/journal_codec.h"
#include "server/recovery/world_definition.h"
#include "server/storage/compression.h"
#include "server/world/saved_host_state.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const std::string_view bytes(reinterpret_cast<const char*>(input.data()), input.size());
    if (const auto host_state = server::decode_host_state(bytes); host_state.ok()) {
        const std::string again = server::encode_host_state(*host_state);
        const auto read = server::decode_host_state(again);
        expect(read.ok(), "an image that was written is read");
        expect(server::encode_host_state(*read) == again, "and says the same");
    } else {
        expect(host_state.error().code == ErrorCode::corrupt_data, "it is said why");
    }
    if (const auto journal = server::decode_journal(bytes); journal.ok()) {
        const std::string again = server::encode_journal(*journal);
        const auto read = server::decode_journal(again);
        expect(read.ok(), "a journal that was written is read");
        expect(server::encode_journal(*read) == again, "and says the same");
    } else {
        expect(journal.error().code == ErrorCode::corrupt_data, "it is said why");
    }
    if (const auto record = server::decode_world_definition(bytes); record.ok())
        expect(server::decode_world_definition(server::encode_world_definition(*record)).ok(),
               "a record that was written is read");
    else
        expect(record.error().code == ErrorCode::corrupt_data, "it is said why");
    if (const auto unpacked = server::decompress(bytes, 1 << 20); unpacked.ok()) {
        expect(server::decompress(server::compress(*unpacked), 1 << 20).ok(), "it is packed again");
        expect(!server::decode_checkpoint(bytes, 0).ok(), "no world has that hash");
    }
}

}  // namespace jostle::fuzz
