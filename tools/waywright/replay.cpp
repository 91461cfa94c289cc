#include "waywright/replay.hpp"

#include <fmt/format.h>

#include "commands.hpp"
#include "failure.hpp"
#include "input.hpp"
#include "json_lines.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace waywright::command {

namespace {

void print(const std::string& line) {
  StreamWriter output(StandardStream::output);
  output.write_line(line);
  output.flush();
}

ReplayResult replay_with_progress(const Script& log, const std::string& name) {
  Progress progress("replay");
  Result<ReplayResult> result =
      waywright::replay(log, [&](std::size_t done, std::size_t total) { progress.show(done, total); });
  if (!result.ok()) throw Failure(fmt::format("{}:{}: {}", name, log.domain_line, result.error().message()));
  return std::move(result).value();
}

}  // namespace

ExitStatus replay(const ReplayOptions& options) {
  if (options.log == "-" && options.other == "-") {
    throw Failure("waywright: LOG and OTHER_LOG cannot both be standard input");
  }
  const Script log = load_script(options.log);
  if (options.other.empty()) {
    const ReplayResult result = replay_with_progress(log, options.log);
    print(json_line(result));
    return result.is_same ? kDone : kRefused;
  }
  const std::optional<ReplayDifference> difference = find_difference(log, load_script(options.other));
  print(json_line(difference));
  return difference ? kRefused : kDone;
}

}  // namespace waywright::command
