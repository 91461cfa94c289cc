#pragma once

// Packets by UDP on this computer, and the simulated faults of a worse network.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include "protocol.hpp"

namespace lockstep {

using Address = boost::asio::ip::udp::endpoint;

/// The faults that a network adds to each packet that it sends. A generator with a seed chooses them.
struct Faults {
  double lost = 0.03;                ///< the share of packets that never arrive
  double late = 0.01;                ///< the share of packets that arrive after kLateDelay frames
  std::uint32_t shortest_delay = 2;  ///< of the other packets, in frames
  std::uint32_t longest_delay = 6;
  std::uint64_t seed = 1;
};
constexpr std::uint32_t kLateDelay = 14;  ///< more than a session can predict

class Network {
 public:
  struct Counts {
    std::size_t sent = 0;  ///< including the lost ones
    std::size_t lost = 0;
    std::size_t late = 0;
    std::size_t refused = 0;  ///< received packets that were malformed
  };

  /// Opens a port on 127.0.0.1. With 0, the system chooses one.
  Network(std::uint16_t port, const Faults& faults);

  /// Sends a packet with the faults of the network: in this frame, in a later one, or never.
  void send(const Address& to, Bytes bytes);
  /// Begins a frame: packets whose delay is over leave now.
  void begin_frame();
  /// Returns a packet that has arrived, and sets `from`. Returns nothing if there is none.
  [[nodiscard]] std::optional<Packet> receive(Address& from);
  /// Sends everything that is delayed at once.
  void flush();

  [[nodiscard]] std::uint16_t port() const { return socket_.local_endpoint().port(); }
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  struct Delayed {
    std::uint64_t frame = 0;
    Address to;
    Bytes bytes;
  };

  void transmit(const Delayed& packet);

  boost::asio::io_context context_;
  boost::asio::ip::udp::socket socket_;
  Faults faults_;
  std::uint64_t frame_ = 0;
  std::uint64_t random_;
  std::vector<Delayed> delayed_;
  Counts counts_;
};

/// The address of a port on this computer.
[[nodiscard]] Address local_address(std::uint16_t port);

}  // namespace lockstep
