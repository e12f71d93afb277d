// SPDX-License-Identifier: MIT
//
// What players make of a file that says it is a recording: it is read and played, or refused with
// the byte, and each tick that can be reached from its keyframe is what it is from the beginning.
// Records and the index get the right CRC, which no fuzzer guesses.
#include <map>
#include <memory>
#include <sstream>

#include "clients/cpp/recording/src/recording_format.h"
#include "jostle/client/playback.h"
#include "jostle/client/recording_summary.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using namespace client;
using namespace client::recording;

void put_at(std::string& file, std::size_t at, std::uint32_t value) {
    std::string bytes;
    put(bytes, value);
    file.replace(at, bytes.size(), bytes);
}

// As far as records go; then an index, if there is one.
std::string with_crcs(std::string file) {
    std::size_t at = header_bytes;
    while (file.size() >= at + record_header_bytes) {
        const auto length = get<std::uint32_t>(file, at);
        if (length == 0 || length > file.size() - at - record_header_bytes) break;
        put_at(file, at + 4,
               crc_of(std::string_view(file).substr(at + crc_from,
                                                    record_header_bytes - crc_from + length)));
        at += record_header_bytes + length;
    }
    if (file.size() >= at + index_head_bytes + trailer_bytes && file.ends_with(end_magic))
        put_at(file, at + 4,
               crc_of(std::string_view(file).substr(
                   at + crc_from, file.size() - at - crc_from - end_magic.size())));
    return file;
}

Result<RecordingReader> reader_of(const std::string& file) {
    return RecordingReader::open(std::make_unique<std::istringstream>(file));
}

}  // namespace

void run(Bytes input) {
    const std::string file = with_crcs(std::string(text_of(input)));
    Result<RecordingReader> reader = reader_of(file);
    if (!reader.ok()) return expect(!reader.error().message.empty(), "a refusal has a reason");
    expect(reader->end() <= file.size(), "records are within the file");
    const RecordingSummary summary = summarize(*reader);
    expect(summary.message_bytes <= file.size(), "messages are within the file");
    const bool index_is_right = reader->rebuild_index() == reader->index();
    Playback all(*std::move(reader));
    const RecordingVerification found = check(all);
    if (!found.errors.empty() || !index_is_right) {
        static_cast<void>(all.seek(summary.first_tick));
        return static_cast<void>(all.seek(summary.last_tick));
    }
    // A server may name a base before a keyframe; then there is no way from there.
    Playback sequential(reader_of(file).value()), seeking(reader_of(file).value());
    for (int k = 0; k < 16 && sequential.next().value(); k++) {
        const std::uint32_t tick = sequential.view().frame().frame;
        static_cast<void>(seeking.seek(summary.last_tick));
        if (seeking.seek(tick).ok())
            expect(seeking.view().frame() == sequential.view().frame(),
                   "a tick is the same from its keyframe as from the beginning");
    }
}

}  // namespace jostle::fuzz
