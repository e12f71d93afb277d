// SPDX-License-Identifier: MIT
#include "jostle/datagram/packet.h"

#include <openssl/core_names.h>
#include <openssl/evp.h>
#include <openssl/kdf.h>
#include <openssl/params.h>

#include "jostle/datagram/little_endian.h"

namespace jostle::datagram {

namespace {

constexpr std::string_view to_server = "jostle datagrams to the server";
constexpr std::string_view to_client = "jostle datagrams to the client";
constexpr std::size_t nonce_bytes = 12;

using DirectionKey = std::array<unsigned char, 32>;
using Nonce = std::array<unsigned char, nonce_bytes>;

struct FreeKdf {
    void operator()(EVP_KDF* kdf) const { EVP_KDF_free(kdf); }
    void operator()(EVP_KDF_CTX* context) const { EVP_KDF_CTX_free(context); }
};

// HKDF-SHA-256 without a salt.
std::optional<DirectionKey> key_for(const Credentials& credentials, std::string_view direction) {
    const std::unique_ptr<EVP_KDF, FreeKdf> kdf(EVP_KDF_fetch(nullptr, "HKDF", nullptr));
    if (!kdf) return std::nullopt;
    const std::unique_ptr<EVP_KDF_CTX, FreeKdf> context(EVP_KDF_CTX_new(kdf.get()));
    if (!context) return std::nullopt;
    char digest[] = "SHA256";
    std::array<std::uint8_t, 32> secret = credentials.key;
    std::string info(direction);
    const OSSL_PARAM parameters[] = {
        OSSL_PARAM_construct_utf8_string(OSSL_KDF_PARAM_DIGEST, digest, 0),
        OSSL_PARAM_construct_octet_string(OSSL_KDF_PARAM_KEY, secret.data(), secret.size()),
        OSSL_PARAM_construct_octet_string(OSSL_KDF_PARAM_INFO, info.data(), info.size()),
        OSSL_PARAM_construct_end()};
    DirectionKey key;
    if (EVP_KDF_derive(context.get(), key.data(), key.size(), parameters) != 1) return std::nullopt;
    return key;
}

// The context has its key set, so a packet only has to set the nonce.
EVP_CIPHER_CTX* cipher_with(const DirectionKey& key, int encrypts) {
    EVP_CIPHER_CTX* const context = EVP_CIPHER_CTX_new();
    if (context && EVP_CipherInit_ex(context, EVP_chacha20_poly1305(), nullptr, key.data(), nullptr,
                                     encrypts) != 1) {
        EVP_CIPHER_CTX_free(context);
        return nullptr;
    }
    return context;
}

// Four zero bytes, then the packet number.
Nonce nonce_of(std::uint64_t number) {
    Nonce nonce{};
    for (std::size_t k = 0; k < sizeof number; k++)
        nonce[nonce_bytes - sizeof number + k] = static_cast<unsigned char>(number >> (8 * k));
    return nonce;
}

const unsigned char* raw(std::string_view bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}
unsigned char* raw(std::string& bytes, std::size_t offset) {
    return reinterpret_cast<unsigned char*>(bytes.data()) + offset;
}

}  // namespace

std::optional<std::uint64_t> session_id_of(std::string_view packet) {
    if (packet.size() < header_bytes + tag_bytes || packet.size() > packet_bytes_max)
        return std::nullopt;
    return number_at<std::uint64_t>(packet, 0);
}

Result<std::unique_ptr<PacketCipher>> PacketCipher::make(const Credentials& credentials,
                                                         Side side) {
    std::unique_ptr<PacketCipher> seal(new PacketCipher(credentials));
    const bool is_server = side == Side::server;
    const auto out = key_for(credentials, is_server ? to_client : to_server);
    const auto in = key_for(credentials, is_server ? to_server : to_client);
    if (out) seal->out_ = cipher_with(*out, 1);
    if (in) seal->in_ = cipher_with(*in, 0);
    if (!seal->out_ || !seal->in_)
        return Error{ErrorCode::internal, "OpenSSL failed to derive the datagram keys"};
    return seal;
}

PacketCipher::~PacketCipher() {
    EVP_CIPHER_CTX_free(out_);
    EVP_CIPHER_CTX_free(in_);
}

std::string PacketCipher::encrypt(std::string_view content) {
    std::string packet;
    if (content.size() > content_bytes_max) return packet;
    packet.reserve(header_bytes + content.size() + tag_bytes);
    put_number(packet, ticket_.id);
    put_number(packet, next_);
    packet.resize(header_bytes + content.size() + tag_bytes);
    const Nonce nonce = nonce_of(next_++);
    int size = 0;
    const bool done =
        EVP_EncryptInit_ex(out_, nullptr, nullptr, nullptr, nonce.data()) == 1 &&
        EVP_EncryptUpdate(out_, nullptr, &size, raw(packet), static_cast<int>(header_bytes)) == 1 &&
        EVP_EncryptUpdate(out_, raw(packet, header_bytes), &size, raw(content),
                          static_cast<int>(content.size())) == 1 &&
        EVP_EncryptFinal_ex(out_, raw(packet, header_bytes + content.size()), &size) == 1 &&
        EVP_CIPHER_CTX_ctrl(out_, EVP_CTRL_AEAD_GET_TAG, static_cast<int>(tag_bytes),
                            raw(packet, header_bytes + content.size())) == 1;
    if (!done) packet.clear();
    return packet;
}

std::optional<PacketCipher::DecryptedPacket> PacketCipher::decrypt(std::string_view packet) {
    const auto credentials = session_id_of(packet);
    if (!credentials || *credentials != ticket_.id) return std::nullopt;
    const auto number = number_at<std::uint64_t>(packet, sizeof ticket_.id);
    if (window_.seen(number)) return std::nullopt;
    const Nonce nonce = nonce_of(number);
    const std::size_t content_bytes = packet.size() - header_bytes - tag_bytes;
    DecryptedPacket opened;
    opened.content.resize(content_bytes);
    std::string tag(packet.substr(header_bytes + content_bytes));
    int size = 0;
    const bool authentic =
        EVP_DecryptInit_ex(in_, nullptr, nullptr, nullptr, nonce.data()) == 1 &&
        EVP_DecryptUpdate(in_, nullptr, &size, raw(packet), static_cast<int>(header_bytes)) == 1 &&
        EVP_DecryptUpdate(in_, raw(opened.content, 0), &size, raw(packet.substr(header_bytes)),
                          static_cast<int>(content_bytes)) == 1 &&
        EVP_CIPHER_CTX_ctrl(in_, EVP_CTRL_AEAD_SET_TAG, static_cast<int>(tag_bytes), raw(tag, 0)) ==
            1 &&
        EVP_DecryptFinal_ex(in_, raw(opened.content, 0) + content_bytes, &size) == 1;
    if (!authentic) return std::nullopt;
    opened.newest = window_.is_newest(number);
    window_.add(number);
    return opened;
}

}  // namespace jostle::datagram
