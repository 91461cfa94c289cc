// A lockstep game of two players with prediction and rollback: 3,200 agents, a building placed or destroyed in every
// tick, packets that are late or lost, and a machine that joins late. docs/guides/rollback.md explains it.
//
// usage: lockstep_game --host [OPTION...]          begins a game and prints its port
//        lockstep_game --join PORT [OPTION...]     the second player
//        lockstep_game --watch PORT [OPTION...]    a machine that joins in the middle of the game
//
// The results depend on the options of the host alone, whatever the network does. Exits with 1 if two machines have
// different states at a tick, and with 2 if no packets arrive from another machine.

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "machine.hpp"

namespace {

constexpr char kUsage[] = R"(usage: lockstep_game --host | --join PORT | --watch PORT [OPTION...]

  --ticks N     host: the length of the game (600)
  --agents N    host: the number of agents (3200)
  --rocks N     host: the number of rocks, of 12 triangles each (1500)
  --queries N   host: the largest number of path queries in a tick (16)
  --watchers N  host: in the middle of the game, waits until N machines watch (0)
  --threads N   threads for path queries (1)
  --rate N      frames in a second; 0 for as many as possible (60)
  --seed N      the seed of the random faults of the network (1)
  --loss SHARE  the share of the packets that never arrive (0.03)
  --late SHARE  the share of the packets that arrive later than the machines can predict (0.01)
  --delay N     the longest delay of the other packets in frames (6)
  --log FILE    writes a replay log, for `waywright replay`
  --damage N    damages the state at tick N, to show that the machines notice it
)";

/// Reads the options. Returns whether they are valid.
bool read_options(int argc, char** argv, lockstep::Options& options) {
  bool has_role = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view name = argv[i];
    if (name == "--host") {
      has_role = true;
      continue;
    }
    if (++i == argc) return false;
    const auto number = std::strtoul(argv[i], nullptr, 10);
    const auto count = static_cast<std::uint32_t>(number);
    if (name == "--join" || name == "--watch") {
      options.join = static_cast<std::uint16_t>(number);
      options.watches = name == "--watch";
      has_role = true;
    } else if (name == "--ticks") {
      options.ticks = count;
    } else if (name == "--agents") {
      options.settings.agents = count;
    } else if (name == "--rocks") {
      options.settings.rocks = count;
    } else if (name == "--queries") {
      options.settings.queries_per_tick = count;
    } else if (name == "--watchers") {
      options.watchers = count;
    } else if (name == "--threads") {
      options.threads = count == 0 ? 1 : count;
    } else if (name == "--rate") {
      options.rate = count;
    } else if (name == "--seed") {
      options.faults.seed = number;
    } else if (name == "--loss") {
      options.faults.lost = std::strtod(argv[i], nullptr);
    } else if (name == "--late") {
      options.faults.late = std::strtod(argv[i], nullptr);
    } else if (name == "--delay") {
      options.faults.longest_delay = count;
      options.faults.shortest_delay = count / 3;
    } else if (name == "--log") {
      options.log = argv[i];
    } else if (name == "--damage") {
      options.damage_at = count;
    } else {
      return false;
    }
  }
  return has_role;
}

}  // namespace

int main(int argc, char** argv) {
  lockstep::Options options;
  if (!read_options(argc, argv, options)) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  if (options.join == 0) return lockstep::Host(options).run();
  return lockstep::Guest(options).run();
}
