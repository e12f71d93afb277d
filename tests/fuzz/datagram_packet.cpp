// SPDX-License-Identifier: MIT
//
// What comes by datagrams, from strangers and from who has the key: packets that nobody sealed are
// refused, contents are read or refused, and parts put together in any order keep within their
// bound and give back what was cut.
#include "jostle/datagram/content.h"
#include "jostle/datagram/packet.h"
#include "jostle/datagram/reassembly.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using namespace datagram;

constexpr std::size_t reassembly_bytes_max =
    Reassembly::partial_messages_max * fragments_max * fragment_bytes;

Credentials ticket() {
    Credentials made{.id = 0x0807060504030201};
    made.key.fill(7);
    return made;
}

// The first half of the input as the contents of packets that arrive one after the other.
void receive(Bytes input) {
    Reassembly reassembly;
    for (Reader in(input); !in.done();) {
        const Record record = take_record(in);
        const auto content = decode_content(text_of(record.bytes));
        if (!content.ok()) {
            expect(!content.error().message.empty(), "a refusal says why");
            continue;
        }
        if (const auto* question = std::get_if<PathChallenge>(&*content))
            expect(encode(*question) == text_of(record.bytes), "a question has one form");
        if (const auto* answer = std::get_if<PathResponse>(&*content))
            expect(encode(*answer) == text_of(record.bytes), "an answer has one form");
        const auto* part = std::get_if<Fragment>(&*content);
        const auto whole = part ? reassembly.add(*part) : std::nullopt;
        if (whole)
            expect(whole->size() > (part->count - 1u) * fragment_bytes &&
                       whole->size() <= part->count * fragment_bytes,
                   "a message is as long as its parts");
        expect(reassembly.bytes_held() <= reassembly_bytes_max, "what waits is bounded");
    }
}

// As a message: cut, put together from the last part to the first, and the same again.
void split_and_reassemble(Bytes input) {
    Reader in(input);
    std::string message(in.number<std::uint16_t>(), 'x');
    const std::string_view rest = text_of(in.rest());
    message.replace(0, std::min(message.size(), rest.size()), rest.substr(0, message.size()));
    const std::string_view piece = message;
    const auto contents = encode_message(std::span(&piece, 1), 5);
    expect(!contents.empty(), "64 kB fit");
    Reassembly reassembly;
    std::optional<std::string> joined;
    for (auto at = contents.rbegin(); at != contents.rend(); ++at) {
        expect(at->size() <= content_bytes_max, "a content fits into a packet");
        const auto content = decode_content(*at);
        expect(content.ok(), "what was encoded is decoded");
        if (const auto* whole = std::get_if<Message>(&*content)) joined = whole->bytes;
        if (const auto* part = std::get_if<Fragment>(&*content)) joined = reassembly.add(*part);
    }
    expect(joined == message, "what was cut is whole again");
}

}  // namespace

void run(Bytes input) {
    static const std::unique_ptr<PacketCipher> server =
        PacketCipher::make(ticket(), Side::server).value();
    expect(!server->decrypt(text_of(input)), "what nobody sealed is not opened");
    receive(input);
    split_and_reassemble(input);
}

}  // namespace jostle::fuzz
