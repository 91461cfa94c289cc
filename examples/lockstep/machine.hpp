#pragma once

// A process of the game: the loop of frames, and what the host and its guests do in a frame.

#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "network.hpp"
#include "session.hpp"

namespace lockstep {

struct Options {
  Settings settings;
  Tick ticks = 600;            ///< the length of the game
  std::uint16_t join = 0;      ///< the port of the host; 0 for the host itself
  bool watches = false;        ///< joins in the middle of the game and gives no commands
  std::uint32_t watchers = 0;  ///< of the host: at half time it waits for so many machines that join late
  std::size_t threads = 1;     ///< for path queries
  std::uint32_t rate = 60;     ///< frames in a second; 0 for as many as possible
  Faults faults;
  std::string log;  ///< the file for a replay log
  std::optional<Tick> damage_at;
};

/// The times of the frames of a process.
class FrameTimes {
 public:
  void begin();
  void end();
  /// Prints the median, the 99th percentile and the largest time.
  void print() const;

 private:
  std::chrono::steady_clock::time_point clock_begin_;
  std::clock_t cpu_begin_ = 0;
  std::vector<double> elapsed_;  ///< milliseconds
  std::vector<double> cpu_;      ///< milliseconds, of all threads
};

/// A machine at the other end of the network.
struct Remote {
  Address address;
  Peer peer;
  std::chrono::steady_clock::time_point heard;  ///< when its last packet arrived
  bool has_game = false;                        ///< it sends updates
  bool plays = false;
  Bytes saved;  ///< the game that it fetches
  Tick saved_tick = 0;
};

class Machine {
 public:
  explicit Machine(const Options& options);
  virtual ~Machine() = default;
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  /// Plays the whole game and prints a report. Returns the exit status of the process.
  int run();

 protected:
  virtual void handle(const Address& from, const Packet& packet) = 0;
  /// Sends what the other machines need, after the session has played.
  virtual void send() = 0;
  [[nodiscard]] virtual bool is_over() = 0;
  /// The player at this machine; nothing if it only watches.
  [[nodiscard]] virtual std::optional<std::size_t> player() const = 0;
  /// Whether the session must wait in this frame for somebody who joins.
  [[nodiscard]] virtual bool must_wait() const { return false; }
  /// The machine whose speed this machine adapts to. Null if there is none.
  [[nodiscard]] virtual const Remote* partner() const = 0;
  /// Says where the states differ.
  virtual void explain_desync(const Desync& desync);

  void start(Simulation simulation, Tick end);
  void send_update(const Remote& remote);
  [[nodiscard]] bool is_silent(const Remote& remote, double seconds) const;
  [[nodiscard]] bool has_finished(const Remote& remote) const;

  Options options_;
  Network network_;
  std::optional<Session> session_;

 private:
  void play();
  void play_tick();
  [[nodiscard]] bool is_too_fast();
  void print_report();

  FrameTimes times_;
  std::ofstream log_file_;
  std::unique_ptr<waywright::ReplayWriter> log_;
  double lead_ = 0.0;             ///< by how many ticks this machine is ahead of the partner's commands, on average
  std::uint32_t since_wait_ = 0;  ///< frames
};

/// The machine that begins the game. It plays as player 0, and gives the game and all commands to those who join.
class Host : public Machine {
 public:
  explicit Host(const Options& options);

 private:
  void handle(const Address& from, const Packet& packet) override;
  void send() override;
  bool is_over() override;
  [[nodiscard]] std::optional<std::size_t> player() const override { return 0; }
  [[nodiscard]] bool must_wait() const override;
  [[nodiscard]] const Remote* partner() const override;
  void welcome(Remote& guest, const Hello& hello);
  void send_chunks(const Remote& guest, const Want& want);
  [[nodiscard]] Remote* find(const Address& address);

  std::vector<Remote> guests_;
  std::optional<std::chrono::steady_clock::time_point> desync_seen_;
};

/// A machine that joins: player 1 before the game begins, or one that watches later.
class Guest : public Machine {
 public:
  explicit Guest(const Options& options);

 private:
  void handle(const Address& from, const Packet& packet) override;
  void send() override;
  bool is_over() override;
  [[nodiscard]] std::optional<std::size_t> player() const override;
  [[nodiscard]] const Remote* partner() const override { return options_.watches ? nullptr : &host_; }
  void explain_desync(const Desync& desync) override;
  void take(const Chunk& chunk);
  void ask();

  Remote host_;
  Tick wanted_ = Hello::kLatest;
  std::optional<Welcome> welcome_;
  Bytes saved_;
  std::vector<bool> has_chunk_;
  std::vector<std::uint32_t> patience_;  ///< frames until a piece that has not arrived is asked for again
  std::optional<Simulation> fetched_;
};

}  // namespace lockstep
