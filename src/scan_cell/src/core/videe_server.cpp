// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/videe_server.h"

#include <netinet/tcp.h>
#include <poll.h>

#include <algorithm>
#include <atomic>
#include <boost/asio.hpp>
#include <mutex>
#include <thread>

#include "scan_cell_common/errors.h"

namespace scan_cell {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

void set_option(int socket, int level, int name, int value) {
  ::setsockopt(socket, level, name, &value, sizeof(value));
}

/// Lets a client whose cable was pulled be noticed within five seconds.
void watch_line(int socket) {
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, 2);         // [s] of silence before the first probe
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, 1);        // [s]
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);          // probes without answer
  set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, 5000);  // [ms] for what was sent
}

/// Also where commands that were not read yet hide the end of the connection.
bool is_there(int socket) {
  pollfd look{socket, POLLRDHUP, 0};
  return ::poll(&look, 1, 0) == 0;
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text + "\n";
}

}  // namespace

struct VideeServer::Implementation {
  Implementation(const std::string& address, std::uint16_t port, Handler h,
                 std::function<void()> lost)
      : handler(std::move(h)), on_client_lost(std::move(lost)) {
    try {
      const tcp::endpoint endpoint(asio::ip::make_address(address), port);
      acceptor.open(endpoint.protocol());
      acceptor.set_option(tcp::acceptor::reuse_address(true));
      acceptor.bind(endpoint);
      acceptor.listen();
    } catch (const boost::system::system_error& error) {
      throw scan_cell_common::ConnectionError("ViDeE on " + address + ":" + std::to_string(port),
                                              error.what(), "choose a free port");
    }
    thread = std::thread([this] { accept(); });
  }

  ~Implementation() {
    stopping = true;
    {
      // shutdown() wakes a thread blocked in accept or read; closing alone would not.
      const std::lock_guard<std::mutex> lock(mutex);
      boost::system::error_code ignored;
      ::shutdown(acceptor.native_handle(), SHUT_RDWR);
      if (socket.is_open()) socket.shutdown(tcp::socket::shutdown_both, ignored);
    }
    thread.join();
  }

  void accept() {
    while (!stopping) {
      boost::system::error_code error;
      tcp::socket client(context);
      acceptor.accept(client, error);
      if (error) continue;
      watch_line(client.native_handle());
      {
        const std::lock_guard<std::mutex> lock(mutex);
        socket = std::move(client);
        if (stopping) return;
      }
      serve();
      on_client_lost();
      const std::lock_guard<std::mutex> lock(mutex);
      socket.close(error);
    }
  }

  void serve() {
    constexpr std::size_t kLongestLine = 1024;
    asio::streambuf buffer(kLongestLine);
    while (!stopping) {
      boost::system::error_code error;
      asio::read_until(socket, buffer, '\n', error);
      if (error == asio::error::not_found) {
        asio::write(socket, asio::buffer(std::string("ERROR line too long\n")), error);
        return;
      }
      if (error) return;
      std::istream stream(&buffer);
      std::string line;
      std::getline(stream, line);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      asio::write(socket, asio::buffer(answer(line)), error);
      if (error) return;
    }
  }

  std::string answer(const std::string& line) {
    const auto client_there = [this] { return is_there(socket.native_handle()); };
    try {
      const std::string result = handler(parse_videe(line), client_there);
      return one_line(result.empty() ? "OK" : "OK " + result);
    } catch (const std::exception& error) {  // of OpenCV, too: a command must not end the node
      return one_line("ERROR " + std::string(error.what()));
    }
  }

  Handler handler;
  std::function<void()> on_client_lost;
  asio::io_context context;
  tcp::acceptor acceptor{context};
  std::mutex mutex;  // of socket, between serving and stopping
  tcp::socket socket{context};
  std::atomic<bool> stopping{false};
  std::thread thread;
};

VideeServer::VideeServer(const std::string& address, std::uint16_t port, Handler handler,
                         std::function<void()> on_client_lost)
    : implementation_(std::make_unique<Implementation>(address, port, std::move(handler),
                                                       std::move(on_client_lost))) {}

VideeServer::~VideeServer() = default;

std::uint16_t VideeServer::port() const {
  return implementation_->acceptor.local_endpoint().port();
}

}  // namespace scan_cell
