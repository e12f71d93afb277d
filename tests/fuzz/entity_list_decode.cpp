// SPDX-License-Identifier: MIT
//
// Packed entity lists from a stranger. What could be read says the same when it is packed and read
// again.
#include "jostle/snapshot/entity_list.h"

#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    Reader in(input);
    while (!in.done()) {
        const Record record = take_record(in);
        const std::size_t prototypes = record.kind;
        const auto told = snapshot::decode_entity_list(bytes_of(record.bytes), prototypes, 10'000);
        if (!told.ok()) {
            expect(!told.error().message.empty(), "a refusal has a reason");
            continue;
        }
        std::uint32_t last = 0;
        for (const snapshot::ListedEntity& entity : *told) {
            expect(entity.id > last && entity.prototype < prototypes,
                   "ids ascend, and prototypes exist");
            last = entity.id;
        }
        const auto again = snapshot::decode_entity_list(
            snapshot::encode_entity_list(*told, prototypes), prototypes, 10'000);
        expect(again.ok() && *again == *told, "a list is the same when it was sent on");
    }
}

}  // namespace jostle::fuzz
