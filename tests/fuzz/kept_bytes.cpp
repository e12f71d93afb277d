// SPDX-License-Identifier: MIT
//
// What is kept of a hosted world beside its bodies: an image, or a journal of commands. What is
// read is the same when it is written and read again; all else is refused. What is compressed comes
// back, and nothing else does.
#include "fuzz/target.h"
#include "host/host_image.h"
#include "persistence/compressed.h"
#include "protocol/journal_codec.h"

namespace jostle::fuzz {

namespace {

constexpr std::size_t decompressed_bytes_max = 1 << 20;

void decompress_or_say_why(std::string_view bytes) {
    const auto opened = server::decompress(bytes, decompressed_bytes_max);
    if (!opened.ok()) {
        expect(opened.error().code == ErrorCode::corrupt_data, "it is said why");
        return;
    }
    expect(opened->size() <= decompressed_bytes_max, "no more than is allowed");
    const auto again = server::decompress(server::compress(*opened), opened->size());
    expect(again.ok() && *again == *opened, "what was opened can be closed and opened");
}

}  // namespace

void run(Bytes input) {
    const std::string_view bytes(reinterpret_cast<const char*>(input.data()), input.size());
    decompress_or_say_why(bytes);
    if (const auto image = server::decode_host_image(bytes); image.ok()) {
        const std::string again = server::encode_host_image(*image);
        const auto read = server::decode_host_image(again);
        expect(read.ok(), "an image that was written is read");
        expect(server::encode_host_image(*read) == again, "and says the same");
    } else {
        expect(image.error().code == ErrorCode::corrupt_data, "it is said why");
    }
    if (const auto journal = server::decode_journal(bytes); journal.ok()) {
        const std::string again = server::encode_journal(*journal);
        const auto read = server::decode_journal(again);
        expect(read.ok(), "a journal that was written is read");
        expect(server::encode_journal(*read) == again, "and says the same");
    } else {
        expect(journal.error().code == ErrorCode::corrupt_data, "it is said why");
    }
}

}  // namespace jostle::fuzz
