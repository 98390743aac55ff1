// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/videe_server.h"

#include <atomic>
#include <boost/asio.hpp>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "scan_cell_common/errors.h"
#include "videe/videe_connection.h"

namespace scan_cell {

namespace asio = boost::asio;
using asio::ip::tcp;
using scan_cell_common::ConnectionError;

struct VideeServer::Implementation {
  Implementation(const Options& o, Handler h, std::function<void()> lost)
      : options(o), handler(std::move(h)), on_client_lost(std::move(lost)) {
    const std::string name = options.address + ":" + std::to_string(options.port);
    try {
      if (!options.client.empty()) only_client = asio::ip::make_address(options.client);
      const tcp::endpoint endpoint(asio::ip::make_address(options.address), options.port);
      acceptor.open(endpoint.protocol());
      acceptor.set_option(tcp::acceptor::reuse_address(true));
      acceptor.bind(endpoint);
      acceptor.listen();
    } catch (const boost::system::system_error& error) {
      throw ConnectionError("ViDeE on " + name + " for '" + options.client + "'", error.what(),
                            "give addresses such as 127.0.0.1, and a free port");
    }
    acceptor_thread = std::thread([this] { accept(); });
    server_thread = std::thread([this] { serve(); });
  }

  ~Implementation() {
    {
      // shutdown() wakes a thread blocked in accept or read; closing alone would not.
      const std::lock_guard<std::mutex> lock(mutex);
      stopping = true;
      boost::system::error_code ignored;
      ::shutdown(acceptor.native_handle(), SHUT_RDWR);
      if (connection) socket.shutdown(tcp::socket::shutdown_both, ignored);
    }
    changed.notify_all();
    acceptor_thread.join();
    server_thread.join();
  }

  void accept() {
    while (!stopping) {
      boost::system::error_code error;
      tcp::endpoint peer;
      tcp::socket client(context);
      acceptor.accept(client, peer, error);
      if (error) {
        constexpr std::chrono::milliseconds kPause(100);  // out of files: it would spin
        if (!stopping) std::this_thread::sleep_for(kPause);
      } else if (!only_client || peer.address() == *only_client) {
        take(std::move(client));
      }
    }
  }

  /// Hands a client over to the server, as soon as the one before, if gone, is done with.
  void take(tcp::socket client) {
    std::unique_lock<std::mutex> lock(mutex);
    if (connection && connection->is_there()) {
      boost::system::error_code unknown;
      const std::string other = socket.remote_endpoint(unknown).address().to_string();
      turn_away(client.native_handle(),
                "ERROR another client is connected, from " + other + "; try again later");
      return;
    }
    changed.wait(lock, [this] { return stopping || !connection; });
    if (stopping) return;
    socket = std::move(client);
    connection = std::make_unique<VideeConnection>(socket.native_handle(), options.idle_time);
    changed.notify_all();
  }

  void serve() {
    while (true) {
      {
        std::unique_lock<std::mutex> lock(mutex);
        changed.wait(lock, [this] { return stopping || connection; });
        if (stopping) return;
      }
      converse();
      on_client_lost();
      boost::system::error_code ignored;
      const std::lock_guard<std::mutex> lock(mutex);
      connection.reset();
      socket.close(ignored);
      changed.notify_all();
    }
  }

  void converse() const {
    while (!stopping) {
      const auto line = connection->next_line();
      if (!line || !connection->send_line(answer(*line))) return;
    }
  }

  std::string answer(const std::string& line) const {
    try {
      const std::string result =
          handler(parse_videe(line), [this] { return connection->is_there(); });
      return result.empty() ? "OK" : "OK " + result;
    } catch (const std::exception& error) {  // of OpenCV, too: a command must not end the node
      return "ERROR " + std::string(error.what());
    }
  }

  const Options options;
  const Handler handler;
  const std::function<void()> on_client_lost;
  std::optional<asio::ip::address> only_client;
  asio::io_context context;
  tcp::acceptor acceptor{context};
  std::mutex mutex;  // of socket and connection: opened by the acceptor, closed by the server
  std::condition_variable changed;
  tcp::socket socket{context};
  std::unique_ptr<VideeConnection> connection;  // of the socket; none: no client
  std::atomic<bool> stopping{false};
  std::thread acceptor_thread;
  std::thread server_thread;
};

VideeServer::VideeServer(const Options& options, Handler handler,
                         std::function<void()> on_client_lost)
    : implementation_(std::make_unique<Implementation>(options, std::move(handler),
                                                       std::move(on_client_lost))) {}

VideeServer::~VideeServer() = default;

std::uint16_t VideeServer::port() const {
  return implementation_->acceptor.local_endpoint().port();
}

}  // namespace scan_cell
