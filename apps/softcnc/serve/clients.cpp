// SPDX-License-Identifier: MIT
#include "serve/clients.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace softcnc::app {
namespace {

constexpr std::size_t kMostUnsent = std::size_t{1} << 20U;  // bytes, to a client that reads nothing
constexpr std::size_t kMostClients = 64;

tl::unexpected<Diagnostic> not_open(const std::string& what, const std::string& why) {
  return tl::make_unexpected(Diagnostic{.code = Code::SC6019, .message = what + ": " + why});
}

bool set_nonblocking(int descriptor) noexcept {
  return ::fcntl(descriptor, F_SETFL, O_NONBLOCK) == 0 &&
         ::fcntl(descriptor, F_SETFD, FD_CLOEXEC) == 0;
}

/// Bytes as they are: no echo, no signals, no line editing.
void make_raw(const char* terminal) noexcept {
  const runtime::Descriptor slave(::open(terminal, O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios modes{};
  if (*slave < 0 || ::tcgetattr(*slave, &modes) != 0) return;
  ::cfmakeraw(&modes);
  ::tcsetattr(*slave, TCSANOW, &modes);
}

struct Addresses {
  explicit Addresses(addrinfo* found) noexcept : first(found) {}
  Addresses(const Addresses&) = delete;
  Addresses& operator=(const Addresses&) = delete;
  ~Addresses() {
    if (first != nullptr) ::freeaddrinfo(first);
  }
  addrinfo* first;
};

}  // namespace

Http looks_like_http(std::string_view text) noexcept {
  constexpr std::array<std::string_view, 9> kMethods{
      "GET ", "POST ", "HEAD ", "PUT ", "OPTIONS ", "DELETE ", "CONNECT ", "TRACE ", "PATCH "};
  constexpr char kHandshake = 0x16;  // of TLS
  if (!text.empty() && text.front() == kHandshake) return Http::yes;
  Http found = Http::no;
  for (const std::string_view method : kMethods) {
    if (text.starts_with(method)) return Http::yes;
    if (method.starts_with(text)) found = Http::maybe;
  }
  return found;
}

Result<std::unique_ptr<Clients>> Clients::open(const std::string& link,
                                               const std::string& address) {
  std::unique_ptr<Clients> clients(new Clients);
  if (!link.empty())
    if (Status made = clients->open_terminal(link); !made) return tl::make_unexpected(made.error());
  if (!address.empty())
    if (Status made = clients->listen(address); !made) return tl::make_unexpected(made.error());
  return clients;
}

/// The link of another server stays.
Clients::~Clients() {
  std::error_code error;
  if (!link_.empty() && std::filesystem::read_symlink(link_, error) == terminal_)
    ::unlink(link_.c_str());
}

/// A link that is there already is replaced; anything else stays.
Status Clients::open_terminal(const std::string& link) {
  runtime::Descriptor master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  if (*master < 0 || ::grantpt(*master) != 0 || ::unlockpt(*master) != 0 ||
      !set_nonblocking(*master))
    return not_open("no pseudo-terminal", std::strerror(errno));
  const std::string terminal = ::ptsname(*master);
  make_raw(terminal.c_str());
  struct stat info {};
  if (::lstat(link.c_str(), &info) == 0 && S_ISLNK(info.st_mode)) ::unlink(link.c_str());
  if (::symlink(terminal.c_str(), link.c_str()) != 0) return not_open(link, std::strerror(errno));
  link_ = link;
  terminal_ = terminal;
  places_ = link;
  clients_.push_back({next_++, std::move(master), true, false, {}, true, {}});
  return {};
}

Status Clients::listen(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  const std::string host = colon == std::string::npos ? "127.0.0.1" : address.substr(0, colon);
  const std::string port = colon == std::string::npos ? address : address.substr(colon + 1);
  if (host.empty() || port.empty() || port.size() > 5 || std::atoi(port.c_str()) > 65535)
    return not_open(address, "is not PORT or HOST:PORT, with a port up to 65535");
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* first = nullptr;
  if (const int error = ::getaddrinfo(host.c_str(), port.c_str(), &wanted, &first); error != 0)
    return not_open(address, ::gai_strerror(error));
  const Addresses found(first);
  runtime::Descriptor socket(::socket(found.first->ai_family, SOCK_STREAM, 0));
  constexpr int kOn = 1;
  ::setsockopt(*socket, SOL_SOCKET, SO_REUSEADDR, &kOn, sizeof kOn);
  if (*socket < 0 || ::bind(*socket, found.first->ai_addr, found.first->ai_addrlen) != 0 ||
      ::listen(*socket, 8) != 0 || !set_nonblocking(*socket))
    return not_open(address, std::strerror(errno));
  sockaddr_in bound{};
  socklen_t size = sizeof bound;
  const bool is_known = ::getsockname(*socket, reinterpret_cast<sockaddr*>(&bound), &size) == 0 &&
                        bound.sin_family == AF_INET;
  const std::string number = is_known ? std::to_string(ntohs(bound.sin_port)) : port;
  places_ += (places_.empty() ? "" : " and ") + host + ':' + number;
  listening_ = std::move(socket);
  return {};
}

void Clients::accept(std::vector<Event>& events) {
  runtime::Descriptor accepted(::accept(*listening_, nullptr, nullptr));
  if (*accepted < 0 || !set_nonblocking(*accepted) || clients_.size() >= kMostClients) return;
  constexpr int kOn = 1;
  constexpr unsigned kMostSilent = 10'000;  // ms: of a network that is lost
  ::setsockopt(*accepted, IPPROTO_TCP, TCP_NODELAY, &kOn, sizeof kOn);
  ::setsockopt(*accepted, SOL_SOCKET, SO_KEEPALIVE, &kOn, sizeof kOn);
  ::setsockopt(*accepted, IPPROTO_TCP, TCP_USER_TIMEOUT, &kMostSilent, sizeof kMostSilent);
  clients_.push_back({next_, std::move(accepted), false, true, {}, false, {}});
  events.push_back({Event::Kind::connected, next_++});
}

void Clients::drop(Client& client, std::vector<Event>& events) {
  if (client.is_there) events.push_back({Event::Kind::gone, client.number});
  client.is_there = false;
  client.to_send.clear();
}

void Clients::read(Client& client, std::vector<Event>& events) {
  std::array<char, 4096> bytes;
  const ssize_t size = ::read(*client.descriptor, bytes.data(), bytes.size());
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (size <= 0) return drop(client, events);
  client.is_there = true;
  std::string text(bytes.data(), static_cast<std::size_t>(size));
  if (!client.is_greeted) {
    client.greeting += text;
    const Http found = looks_like_http(client.greeting);
    if (found == Http::yes) return drop(client, events);
    if (found == Http::maybe) return;
    client.is_greeted = true;
    text = std::exchange(client.greeting, {});
  }
  events.push_back({Event::Kind::bytes, client.number, std::move(text)});
}

void Clients::write(Client& client) {
  if (client.to_send.empty()) return;
  const ssize_t size =
      client.is_terminal
          ? ::write(*client.descriptor, client.to_send.data(), client.to_send.size())
          : ::send(*client.descriptor, client.to_send.data(), client.to_send.size(), MSG_NOSIGNAL);
  if (size > 0) client.to_send.erase(0, static_cast<std::size_t>(size));
}

void Clients::send(int number, std::string_view text) {
  for (Client& client : clients_)
    if (client.number == number && client.is_there) {
      client.to_send += text;
      write(client);
    }
}

std::vector<Clients::Event> Clients::wait(double seconds) {
  std::vector<pollfd> sources{{*listening_, POLLIN, 0}};
  for (const Client& client : clients_) {
    const int wanted = POLLIN | (client.to_send.empty() ? 0 : POLLOUT);
    // A terminal that nobody has open would end every wait at once.
    const bool is_closed = client.is_terminal && !client.is_there;
    sources.push_back({is_closed ? -1 : *client.descriptor, static_cast<short>(wanted), 0});
  }
  std::vector<Event> events;
  ::poll(sources.data(), sources.size(), static_cast<int>(std::ceil(1000 * seconds)));
  for (std::size_t i = 0; i + 1 < sources.size(); ++i) {
    Client& client = clients_[i];
    const short came = sources[i + 1].revents;
    if ((came & POLLOUT) != 0) write(client);
    const bool is_closed = sources[i + 1].fd < 0;
    if (is_closed || (came & (POLLIN | POLLHUP | POLLERR)) != 0) read(client, events);
    if (client.to_send.size() > kMostUnsent) drop(client, events);
  }
  std::erase_if(clients_, [](const Client& one) { return !one.is_terminal && !one.is_there; });
  if ((sources.front().revents & POLLIN) != 0) accept(events);
  return events;
}

}  // namespace softcnc::app
