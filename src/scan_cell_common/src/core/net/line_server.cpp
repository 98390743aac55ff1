// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/net/line_server.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <list>
#include <optional>
#include <thread>

#include "net/line_session.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

struct LineServer::Implementation {
  Implementation(const Options& options, Answer answer, std::function<void()> on_client_lost) {
    service.options = options;
    service.answer = std::move(answer);
    service.on_client_lost = std::move(on_client_lost);
    try {
      listen();
    } catch (const boost::system::system_error& error) {
      throw ConnectionError(fmt::format("{} on {}:{}", options.name, options.address, options.port),
                            error.what(),
                            "give an address of this machine such as 127.0.0.1, and a free port");
    }
    accept();
    thread = std::thread([this] { service.context.run(); });
  }

  /// The context's thread ends when the last client has been dealt with.
  ~Implementation() {
    asio::post(service.context, [this] { stop(); });
    thread.join();
    service.answerer.join();
  }

  void listen() {
    const Options& options = service.options;
    if (!options.only_client.empty()) only_client = asio::ip::make_address(options.only_client);
    const tcp::endpoint endpoint(asio::ip::make_address(options.address), options.port);
    acceptor.open(endpoint.protocol());
    ::fcntl(acceptor.native_handle(), F_SETFD, FD_CLOEXEC);
    acceptor.set_option(tcp::acceptor::reuse_address(true));
    acceptor.bind(endpoint);
    acceptor.listen();
    port = acceptor.local_endpoint().port();
  }

  void accept() {
    acceptor.async_accept([this](error_code error, tcp::socket client) {
      if (!acceptor.is_open()) return;
      if (error) {
        constexpr std::chrono::milliseconds kPause(100);  // chosen; out of files, it would spin
        pause.expires_after(kPause);
        pause.async_wait([this](error_code stopped) {
          if (!stopped) accept();
        });
        return;
      }
      ::fcntl(client.native_handle(), F_SETFD, FD_CLOEXEC);
      error_code gone;
      if (only_client && client.remote_endpoint(gone).address() != *only_client) return accept();
      take(std::move(client));
    });
  }

  /// Serves a client, turns it away, or lets it wait until a client that has gone is cleaned up.
  void take(tcp::socket client) {
    if (sessions.size() < service.options.max_clients) {
      sessions.emplace_back();
      const auto session = std::prev(sessions.end());
      *session = std::make_shared<LineSession>(service, std::move(client),
                                               [this, session] { forget(session); });
      (*session)->begin();
    } else if (std::all_of(sessions.begin(), sessions.end(),
                           [](const auto& session) { return session->is_there(); })) {
      const std::string text =
          fmt::format(fmt::runtime(service.options.too_many_clients), sessions.front()->peer());
      error_code ignored;
      send_now(client, text + '\n', ignored);
    } else {
      waiting = std::move(client);
      return;
    }
    accept();
  }

  void forget(std::list<std::shared_ptr<LineSession>>::iterator session) {
    sessions.erase(session);
    if (!waiting) return;
    tcp::socket client = std::move(*waiting);
    waiting.reset();
    take(std::move(client));
  }

  void stop() {
    error_code ignored;
    acceptor.close(ignored);
    pause.cancel();
    waiting.reset();
    const auto left = sessions;
    for (const auto& session : left)
      session->stop();
  }

  LineService service;
  std::optional<asio::ip::address> only_client;
  tcp::acceptor acceptor{service.context};
  std::uint16_t port = 0;
  asio::steady_timer pause{service.context};
  std::list<std::shared_ptr<LineSession>> sessions;
  std::optional<tcp::socket> waiting;  // for its turn; no client is accepted meanwhile
  std::thread thread;
};

LineServer::LineServer(const Options& options, Answer answer, std::function<void()> on_client_lost)
    : implementation_(std::make_unique<Implementation>(options, std::move(answer),
                                                       std::move(on_client_lost))) {}

LineServer::~LineServer() = default;

std::uint16_t LineServer::port() const {
  return implementation_->port;
}

}  // namespace scan_cell_common
