// SPDX-License-Identifier: MIT
//
// What a client sends: decoded, and each input admitted or refused with a reason.
#include "jostle/v1/play.pb.h"
#include "server/limits/admission.h"
#include "server/messages/client_message.h"
#include "tests/fuzz/mutate_message.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const auto message = server::decode_client_message(text_of(input));
    if (!message.ok()) return expect(!message.error().message.empty(), "a refusal has a reason");
    const auto* batch = std::get_if<server::InputBatch>(&*message);
    if (!batch) return;
    for (const auto& action : batch->inputs) {
        if (!action.ok()) {
            expect(!action.error().message.empty(), "a refusal has a reason");
            continue;
        }
        const Status admitted = server::check_numbers(*action);
        expect(admitted.ok() || !admitted.error().message.empty(), "a refusal has a reason");
    }
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    static jostle::v1::ClientMessage message;
    return jostle::fuzz::mutate_message(message, data, size, size_max, seed);
}
