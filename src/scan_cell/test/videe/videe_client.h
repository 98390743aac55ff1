// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <poll.h>

#include <boost/asio.hpp>
#include <string>

#include "videe/videe_server.h"

namespace videe_test {

using boost::asio::ip::tcp;
using ClientThere = scan_cell::VideeServer::ClientThere;

inline std::string nothing(const scan_cell::VideeCommand&, const ClientThere&) {
  return "";
}

inline scan_cell::VideeServer::Options at_any_port() {
  scan_cell::VideeServer::Options options;
  options.port = 0;
  return options;
}

class Client {
 public:
  /// @param from the client's own address
  /// @param room [bytes] for answers not yet received; 0: the system's
  explicit Client(std::uint16_t port, const std::string& from = "127.0.0.1", int room = 0) {
    socket_.open(tcp::v4());
    if (room > 0) socket_.set_option(boost::asio::socket_base::receive_buffer_size(room));
    socket_.bind({boost::asio::ip::make_address(from), 0});
    socket_.connect({boost::asio::ip::make_address("127.0.0.1"), port});
  }
  void send(const std::string& text) { boost::asio::write(socket_, boost::asio::buffer(text)); }
  /// Sends as much as the server accepts before it is silent for half a second or disconnects.
  void send_what_fits(const std::string& text) {
    std::size_t sent = 0;
    pollfd writable{socket_.native_handle(), POLLOUT, 0};
    while (sent < text.size() && poll(&writable, 1, 500) == 1) {
      const ssize_t size = ::send(socket_.native_handle(), text.data() + sent, text.size() - sent,
                                  MSG_DONTWAIT | MSG_NOSIGNAL);
      if (size <= 0) return;
      sent += static_cast<std::size_t>(size);
    }
  }
  void close_sending() { socket_.shutdown(tcp::socket::shutdown_send); }
  void reset_at_the_end() { socket_.set_option(boost::asio::socket_base::linger(true, 0)); }
  std::string receive() {
    boost::asio::read_until(socket_, buffer_, '\n');
    std::istream stream(&buffer_);
    std::string line;
    std::getline(stream, line);
    return line;
  }
  /// Waits until the server disconnects, after any lines that receive() did not take, and returns
  /// whether it has.
  bool hung_up() {
    boost::system::error_code error;
    while (!error)
      boost::asio::read(socket_, buffer_, boost::asio::transfer_at_least(1), error);
    return error == boost::asio::error::eof || error == boost::asio::error::connection_reset;
  }

 private:
  boost::asio::io_context context_;
  tcp::socket socket_{context_};
  boost::asio::streambuf buffer_;
};

}  // namespace videe_test
