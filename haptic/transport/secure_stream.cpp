// SPDX-License-Identifier: Apache-2.0
#include "haptic/transport/secure_stream.h"

#include <openssl/err.h>
#include <openssl/ssl.h>

#include <algorithm>
#include <asio/ssl/context.hpp>
#include <asio/ssl/error.hpp>
#include <asio/ssl/stream.hpp>
#include <asio/write.hpp>
#include <utility>

#include "geometry/system/assertion.h"

namespace hapticell::haptic {

namespace {

constexpr const char* kCipher = "TLS_AES_128_GCM_SHA256";  // Its hash is the one that an external key goes with.
constexpr unsigned char kCipherNumber[2] = {0x13, 0x01};

}  // namespace

struct SecureStreams::Context {
  Context(Side side, const PairingKey& key);

  asio::ssl::context tls;
  std::string identity;
  std::array<std::uint8_t, PairingKey::kSecretBytes> secret;

  SSL_SESSION* session(SSL* connection) const;
  static int slot();
  static const Context& of(const SSL* connection);
  static int find(SSL* connection, const unsigned char* identity, std::size_t length, SSL_SESSION** session);
  static int use(SSL* connection, const EVP_MD* hash, const unsigned char** identity, std::size_t* length,
                 SSL_SESSION** session);
};

SecureStreams::Context::Context(Side side, const PairingKey& key)
    : tls(side == Side::kServer ? asio::ssl::context::tls_server : asio::ssl::context::tls_client),
      identity(key.identity()),
      secret(key.secret()) {
  SSL_CTX* const native = tls.native_handle();
  // Without a certificate on either side, and with one demanded, nothing but the key opens a connection.
  SSL_CTX_set_verify(native, SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, nullptr);
  SSL_CTX_set_options(native, SSL_OP_NO_TICKET | SSL_OP_NO_RENEGOTIATION);
  const bool set = SSL_CTX_set_min_proto_version(native, TLS1_3_VERSION) == 1 &&
                   SSL_CTX_set_ciphersuites(native, kCipher) == 1 && SSL_CTX_set_num_tickets(native, 0) == 1 &&
                   SSL_CTX_set_max_early_data(native, 0) == 1 && SSL_CTX_set_ex_data(native, slot(), this) == 1;
  HAPTICELL_DEMAND(set);
  SSL_CTX_set_session_cache_mode(native, SSL_SESS_CACHE_OFF);
  if (side == Side::kServer) {
    constexpr std::array<unsigned char, 9> kName = {'h', 'a', 'p', 't', 'i', 'c', 'e', 'l', 'l'};
    SSL_CTX_set_session_id_context(native, kName.data(), kName.size());  // Else a key is an "internal error".
    SSL_CTX_set_psk_find_session_callback(native, &Context::find);
  } else {
    SSL_CTX_set_psk_use_session_callback(native, &Context::use);
  }
}

int SecureStreams::Context::slot() {
  static const int index = SSL_CTX_get_ex_new_index(0, nullptr, nullptr, nullptr, nullptr);
  return index;
}

const SecureStreams::Context& SecureStreams::Context::of(const SSL* connection) {
  return *static_cast<const Context*>(SSL_CTX_get_ex_data(SSL_get_SSL_CTX(connection), slot()));
}

/// The key in the shape that OpenSSL wants it; null when there is no memory for it.
SSL_SESSION* SecureStreams::Context::session(SSL* connection) const {
  const SSL_CIPHER* const cipher = SSL_CIPHER_find(connection, kCipherNumber);
  SSL_SESSION* const made = SSL_SESSION_new();
  if (made != nullptr && cipher != nullptr && SSL_SESSION_set1_master_key(made, secret.data(), secret.size()) == 1 &&
      SSL_SESSION_set_cipher(made, cipher) == 1 && SSL_SESSION_set_protocol_version(made, TLS1_3_VERSION) == 1) {
    return made;
  }
  SSL_SESSION_free(made);
  return nullptr;
}

int SecureStreams::Context::find(SSL* connection, const unsigned char* identity, std::size_t length,
                                 SSL_SESSION** session) {
  const Context& context = of(connection);
  *session = nullptr;
  const bool ours = length == context.identity.size() &&
                    std::equal(identity, identity + length, context.identity.begin(),
                               [](unsigned char a, char b) { return a == static_cast<unsigned char>(b); });
  if (!ours) return 1;  // Goes on to certificates, of which there are none: refused.
  *session = context.session(connection);
  return *session != nullptr;
}

int SecureStreams::Context::use(SSL* connection, const EVP_MD* hash, const unsigned char** identity,
                                std::size_t* length, SSL_SESSION** session) {
  const Context& context = of(connection);
  *session = nullptr;
  *identity = nullptr;
  *length = 0;
  if (hash != nullptr && !EVP_MD_is_a(hash, "SHA256")) return 1;
  *session = context.session(connection);
  if (*session == nullptr) return 0;
  *identity = reinterpret_cast<const unsigned char*>(context.identity.data());
  *length = context.identity.size();
  return 1;
}

namespace {

class SecureStream final : public ByteStream {
 public:
  SecureStream(asio::ip::tcp::socket socket, asio::ssl::context& tls, std::shared_ptr<const void> context,
               asio::ssl::stream_base::handshake_type side)
      : context_(std::move(context)), stream_(std::move(socket), tls), side_(side) {}

  asio::ip::tcp::socket& socket() override { return stream_.next_layer(); }
  const asio::ip::tcp::socket& socket() const override { return stream_.next_layer(); }

  void handshake(Done done) override {
    stream_.async_handshake(side_, [this, done = std::move(done)](std::error_code failed) {
      // A handshake that did not use the key must not count, whatever else it used.
      const bool keyed = !failed && SSL_session_reused(stream_.native_handle()) == 1;
      done(failed || keyed ? failed : std::make_error_code(std::errc::permission_denied));
    });
  }
  void read(asio::mutable_buffer into, Received received) override {
    stream_.async_read_some(into, std::move(received));
  }
  void write(asio::const_buffer bytes, Done done) override {
    asio::async_write(stream_, bytes, [done = std::move(done)](std::error_code failed, std::size_t) { done(failed); });
  }

 private:
  std::shared_ptr<const void> context_;
  asio::ssl::stream<asio::ip::tcp::socket> stream_;
  asio::ssl::stream_base::handshake_type side_;
};

}  // namespace

SecureStreams::SecureStreams(Side side, const PairingKey& key)
    : side_(side), context_(std::make_shared<Context>(side, key)) {}

SecureStreams::~SecureStreams() = default;

std::unique_ptr<ByteStream> SecureStreams::make(asio::ip::tcp::socket socket) const {
  return std::make_unique<SecureStream>(
      std::move(socket), context_->tls, context_,
      side_ == Side::kServer ? asio::ssl::stream_base::server : asio::ssl::stream_base::client);
}

HandshakeFailure handshakeFailure(const std::error_code& failed) {
  if (failed == std::errc::permission_denied) return HandshakeFailure::kOtherKey;
  if (failed.category() != asio::error::get_ssl_category()) return HandshakeFailure::kEnded;
  switch (ERR_GET_REASON(static_cast<unsigned long>(failed.value()))) {
    case SSL_R_WRONG_VERSION_NUMBER:
    case SSL_R_HTTP_REQUEST:
    case SSL_R_PACKET_LENGTH_TOO_LONG:
    case SSL_R_UNSUPPORTED_PROTOCOL:
      return HandshakeFailure::kOtherSpeech;
    case SSL_R_UNEXPECTED_EOF_WHILE_READING:
      return HandshakeFailure::kEnded;
    default:
      return HandshakeFailure::kOtherKey;
  }
}

Text handshakeProblem(const std::error_code& failed) {
  if (failed == std::errc::permission_denied) return Text("the other side did not use the pairing key");
  switch (handshakeFailure(failed)) {
    case HandshakeFailure::kEnded:
      return Text("the connection ended before the keys were checked");
    case HandshakeFailure::kOtherSpeech:
      return Text("it does not speak TLS 1.3");
    case HandshakeFailure::kOtherKey:
      break;
  }
  switch (ERR_GET_REASON(static_cast<unsigned long>(failed.value()))) {
    case SSL_R_BINDER_DOES_NOT_VERIFY:
    case SSL_R_NO_SUITABLE_SIGNATURE_ALGORITHM:
    case SSL_R_NO_SHARED_CIPHER:
    case SSL_R_SSLV3_ALERT_HANDSHAKE_FAILURE:
    case SSL_R_SSLV3_ALERT_ILLEGAL_PARAMETER:
    case SSL_R_TLSV1_ALERT_DECRYPT_ERROR:
      return Text("the other side has a different pairing key");
    default:
      return failed.message();
  }
}

}  // namespace hapticell::haptic
