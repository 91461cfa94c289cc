#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "bind.hpp"

// Replay logs.

namespace waywright::python {

namespace {

/// A log that is written to a file.
struct LogHandle {
  using BoundToPython = void;

  LogHandle(const std::string& file_name, const WorldHandle& world, std::uint64_t ticks_per_hash)
      : name(file_name), out(name, std::ios::binary) {
    if (!out) throw BadResult({ErrorCode::unwritable, name + ": cannot be opened for writing", {}, 0});
    writer.emplace(world.read([&](const World& w) { return ReplayWriter(out, w, ticks_per_hash); }));
  }

  std::string name;
  std::ofstream out;
  std::optional<ReplayWriter> writer;
};

ReplayWriter& writer_of(LogHandle& self) {
  if (!self.writer) throw py::value_error("the log is closed");
  return *self.writer;
}

void close(LogHandle& self) {
  self.writer.reset();
  if (!self.out.is_open()) return;
  self.out.close();
  if (!self.out) throw BadResult({ErrorCode::unwritable, self.name + ": cannot be written", {}, 0});
}

void bind_writer(py::module_& module) {
  py::class_<LogHandle>(module, "ReplayWriter", R"(
Writes a replay log: the items of a world, every change, and the hash of the items every few ticks.

A log is a world script: ``waywright run`` reads it, too. Use it in a ``with`` statement, or call close().
)")
      .def(py::init([](const py::object& file, const WorldHandle& world, std::uint64_t ticks_per_hash) {
             if (ticks_per_hash < 1) throw py::value_error("ticks_per_hash must be 1 or more");
             world.refuse_in_attempt();
             const std::string name = file_name_of(file);
             return std::make_unique<LogHandle>(name, world, ticks_per_hash);
           }),
           py::arg("file"), py::arg("world"), py::arg("ticks_per_hash") = 1)
      .def(
          "record",
          [](LogHandle& self, const std::vector<Change>& changes, const std::vector<ItemId>& ids) {
            if (changes.size() != ids.size()) throw py::value_error("there must be an id for each change");
            writer_of(self).record(changes, ids).value();
          },
          py::arg("changes"), py::arg("ids"), "Records the changes that World.apply() has made, and its answer.")
      .def(
          "tick",
          [](LogHandle& self, const WorldHandle& world) {
            world.refuse_in_attempt();
            world.read([&](const World& w) { writer_of(self).tick(w).value(); });
          },
          py::arg("world"), "Ends a tick. Ticks count from 1.")
      .def_property_readonly(
          "last_tick", [](LogHandle& self) { return writer_of(self).last_tick(); },
          "The number of the last tick, 0 before the first.")
      .def("close", &close, "Closes the file.")
      .def("__reduce_ex__", &refuse_pickle, py::arg("protocol"))
      .def("__enter__", [](const py::object& self) { return self; })
      .def("__exit__", [](LogHandle& self, const py::args&) { close(self); });
}

void bind_result(py::module_& module) {
  py::class_<ReplayResult>(module, "ReplayResult", "The answer of replay().")
      .def_property_readonly(
          "is_same", [](const ReplayResult& self) { return self.is_same; },
          "Whether all changes were made and all hashes are equal.")
      .def_property_readonly(
          "ticks", [](const ReplayResult& self) { return self.ticks; }, "The number of ticks that were replayed.")
      .def_property_readonly(
          "tick", [](const ReplayResult& self) { return self.tick; },
          "The first tick whose hash differs, or during which a change was refused.")
      .def_property_readonly(
          "last_same", [](const ReplayResult& self) { return self.last_same; },
          "The last tick before ``tick`` whose hash is equal, or 0.")
      .def_property_readonly(
          "line", [](const ReplayResult& self) { return self.line; }, "The line in the log.")
      .def_property_readonly(
          "expected", [](const ReplayResult& self) { return self.expected; }, "The hash in the log.")
      .def_property_readonly(
          "computed", [](const ReplayResult& self) { return self.computed; }, "The hash of the replayed world.")
      .def_property_readonly(
          "refusal",
          [](const ReplayResult& self) -> py::object {
            if (!self.refusal) return py::none();
            return py::str(self.refusal->message());
          },
          "Why the world refused a change, or None.")
      .def_property_readonly(
          "changed", [](const ReplayResult& self) { return self.changed; },
          "The ids of the items that were changed after tick ``last_same``.")
      .def("__bool__", [](const ReplayResult& self) { return self.is_same; })
      .def("__reduce_ex__", &refuse_pickle, py::arg("protocol"))
      .def("__repr__", [](const ReplayResult& self) {
        if (self.is_same) return "<waywright.ReplayResult same, " + std::to_string(self.ticks) + " ticks>";
        return "<waywright.ReplayResult differs at tick " + std::to_string(self.tick) + ", line " +
               std::to_string(self.line) + ">";
      });
}

}  // namespace

void bind_replay(py::module_& module) {
  bind_writer(module);
  bind_result(module);
  module.def(
      "replay",
      [](const Script& log, const py::object& progress) {
        Reporter reporter(progress);
        const WithoutGil no_gil;
        return replay(log, reporter.function()).value();
      },
      py::arg("log"), py::kw_only(), py::arg("progress") = py::none(),
      R"(Makes the changes of a log in a new world, and compares the hash of its items with each hash in the log.

>>> log = waywright.parse_script("waywright 1\ndomain 0 0 9 9\npoint 1 2 2\npoint 1 3 3\ntick 1\n", "log")
>>> waywright.replay(log)
<waywright.ReplayResult differs at tick 1, line 4>
)");
  module.def(
      "find_difference",
      [](const Script& log, const Script& other) -> py::object {
        const auto difference = find_difference(log, other);
        if (!difference) return py::none();
        py::dict result;
        result["kind"] = difference->kind;
        result["tick"] = difference->tick;
        result["line"] = difference->line;
        result["other_line"] = difference->other_line;
        result["item"] = difference->item;
        result["other_item"] = difference->other_item;
        result["changed"] = difference->changed;
        return result;
      },
      py::arg("log"), py::arg("other"), "Returns the first difference between two logs as a dict, or None.");
}

}  // namespace waywright::python
