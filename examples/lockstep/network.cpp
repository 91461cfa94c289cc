#include "network.hpp"

#include <array>
#include <optional>
#include <utility>

#include <boost/asio/buffer.hpp>

#include "numbers.hpp"

namespace lockstep {

namespace asio = boost::asio;

Address local_address(std::uint16_t port) { return {asio::ip::address_v4::loopback(), port}; }

Network::Network(std::uint16_t port, const Faults& faults)
    : socket_(context_, local_address(port)), faults_(faults), random_(mixed(faults.seed)) {
  socket_.non_blocking(true);
}

void Network::send(const Address& to, Bytes bytes) {
  ++counts_.sent;
  // Always three numbers for a packet, so that the faults of one packet do not depend on the faults of another.
  const double loss = share_of(random_++);
  const double lateness = share_of(random_++);
  const double delay = share_of(random_++);
  if (loss < faults_.lost) {
    ++counts_.lost;
    return;
  }
  const bool is_late = lateness < faults_.late;
  const auto range = static_cast<double>(faults_.longest_delay - faults_.shortest_delay + 1);
  const std::uint32_t frames =
      is_late ? kLateDelay : faults_.shortest_delay + static_cast<std::uint32_t>(range * delay);
  counts_.late += is_late ? 1 : 0;
  delayed_.push_back({frame_ + frames, to, std::move(bytes)});
  if (frames == 0) flush();
}

void Network::begin_frame() {
  ++frame_;
  std::vector<Delayed> later;
  for (Delayed& packet : delayed_) {
    if (packet.frame <= frame_) {
      transmit(packet);
    } else {
      later.push_back(std::move(packet));
    }
  }
  delayed_ = std::move(later);
}

void Network::flush() {
  for (const Delayed& packet : delayed_) transmit(packet);
  delayed_.clear();
}

/// A packet that the system refuses counts as lost: the receiver may not exist any more.
void Network::transmit(const Delayed& packet) {
  boost::system::error_code error;
  socket_.send_to(asio::buffer(packet.bytes), packet.to, 0, error);
}

std::optional<Packet> Network::receive(Address& from) {
  std::array<std::uint8_t, 2 * kLargestPacket> buffer{};
  for (;;) {
    boost::system::error_code error;
    const std::size_t size = socket_.receive_from(asio::buffer(buffer), from, 0, error);
    // Some systems report here that an earlier packet did not arrive.
    if (error == asio::error::connection_refused || error == asio::error::connection_reset) continue;
    if (error) return std::nullopt;
    if (auto packet = read_packet({buffer.data(), size})) return packet;
    ++counts_.refused;
  }
}

}  // namespace lockstep
