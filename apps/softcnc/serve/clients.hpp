// SPDX-License-Identifier: MIT
// The clients of a server: one on a pseudo-terminal, others by TCP.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "motion/core/result.hpp"
#include "runtime/program/descriptor.hpp"

namespace softcnc::app {

/// Bytes from clients and to them; nothing waits for a client that does not read.
class Clients {
 public:
  struct Event {
    enum class Kind : std::uint8_t { connected, bytes, gone };
    Kind kind;
    int client;  // a number that no other one ever has
    std::string bytes = {};
  };

  /// Makes a pseudo-terminal, of which `link` becomes the name in the file system, and listens on
  /// `address`: a port of this computer, "PORT", or "HOST:PORT". Empty ones are left out. Errors:
  /// SC6019.
  static Result<std::unique_ptr<Clients>> open(const std::string& link, const std::string& address);
  Clients(const Clients&) = delete;
  Clients& operator=(const Clients&) = delete;
  ~Clients();

  /// Waits at most `seconds` for something to happen, and returns what has.
  std::vector<Event> wait(double seconds);
  void send(int client, std::string_view text);

  /// Returns what clients can connect to, for a person.
  const std::string& places() const noexcept { return places_; }

 private:
  struct Client {
    int number;
    runtime::Descriptor descriptor;
    bool is_terminal = false;
    bool is_there = true;  // of the terminal: somebody has it open
    std::string greeting;  // of TCP: what may be the beginning of HTTP
    bool is_greeted = false;
    std::string to_send;
  };

  Clients() = default;
  Status open_terminal(const std::string& link);
  Status listen(const std::string& address);
  void accept(std::vector<Event>& events);
  void read(Client& client, std::vector<Event>& events);
  void write(Client& client);
  void drop(Client& client, std::vector<Event>& events);

  std::string link_, terminal_, places_;
  runtime::Descriptor listening_{-1};
  std::vector<Client> clients_;
  int next_ = 0;
};

/// Whether a text is the beginning of a request of HTTP, is none, or is too short to tell.
enum class Http : std::uint8_t { no, maybe, yes };
Http looks_like_http(std::string_view text) noexcept;

}  // namespace softcnc::app
