#include <cstring>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>

#include "bind.hpp"

// Worlds: making, copying, saving, and facts about the whole world.

namespace waywright::python {

namespace {

WorldPointer handle_of(World world) { return std::make_shared<WorldHandle>(std::move(world)); }

WorldPointer create(const Box& domain, bool keep_abstraction, bool keep_bridges, std::optional<std::size_t> limit) {
  return handle_of(World::create(domain, {.keep_abstraction = keep_abstraction,
                                          .keep_bridges = keep_bridges,
                                          .new_vertex_limit = limit.value_or(kNoVertexLimit)})
                       .value());
}

std::optional<std::size_t> limit_of(const World& world) {
  const std::size_t limit = world.new_vertex_limit();
  return limit == kNoVertexLimit ? std::nullopt : std::optional(limit);
}

py::dict options_of(const WorldHandle& self) {
  const auto [options, limit] =
      self.read([](const World& world) { return std::pair(world.options(), limit_of(world)); });
  py::dict result;
  result["keep_abstraction"] = options.keep_abstraction;
  result["keep_bridges"] = options.keep_bridges;
  result["new_vertex_limit"] = limit;
  return result;
}

WorldPointer clone(const WorldHandle& self) {
  self.refuse_in_attempt();
  auto copy = self.read_long([](const World& world) { return handle_of(world.clone()); });
  copy->keeps_history = self.keeps_history;
  return copy;
}

py::bytes to_bytes(const WorldHandle& self) {
  const std::string bytes = self.read_long([](const World& world) {
    std::ostringstream out;
    save_world(world, out).value();
    return std::move(out).str();
  });
  return bytes;
}

WorldPointer from_bytes_of(const py::bytes& bytes, std::size_t threads, const py::object& progress) {
  if (threads < 1) throw py::value_error("threads must be 1 or more");
  Reporter reporter(progress);
  const std::string text = bytes;
  const WithoutGil no_gil;
  std::istringstream in(text);
  auto world = load_world(in, {.threads = threads, .progress = reporter.function()}).value();
  if (in.peek() != std::char_traits<char>::eof()) {
    throw BadResult({ErrorCode::malformed, "the bytes contain more than a saved world", {}, 0});
  }
  return handle_of(std::move(world));
}

WorldPointer load(const std::string& file_name, std::size_t threads, const py::object& progress) {
  if (threads < 1) throw py::value_error("threads must be 1 or more");
  Reporter reporter(progress);
  const WithoutGil no_gil;
  return handle_of(load_world_file(file_name, {.threads = threads, .progress = reporter.function()}).value());
}

py::dict memory_of(const WorldHandle& self) {
  const MemoryUse use = self.read([](const World& world) { return world.memory(); });
  py::dict result;
  result["vertices"] = use.vertices;
  result["crossings"] = use.crossings;
  result["faces"] = use.faces;
  result["walls"] = use.walls;
  result["items"] = use.items;
  result["sectors"] = use.sectors;
  result["abstraction"] = use.abstraction;
  result["bridges"] = use.bridges;
  result["history"] = use.history;
  result["spare"] = use.spare;
  result["total"] = use.total();
  return result;
}

std::string repr_of(const WorldHandle& self) {
  return self.read([](const World& world) {
    const Box& box = world.domain();
    return "<waywright.World " + to_string(box.min) + " to " + to_string(box.max) + ", " +
           std::to_string(world.item_count()) + " items, " + std::to_string(world.vertex_count()) + " vertices>";
  });
}

void bind_saving(WorldClass& world) {
  world
      .def(
          "save",
          [](const WorldHandle& self, const py::object& file) {
            const auto name = py::module_::import("os").attr("fspath")(file).cast<std::string>();
            self.read_long([&](const World& w) { save_world_file(w, name).value(); });
          },
          py::arg("file"), "Saves the world to a file (.wwb). At every moment the file is the old one or the new one.")
      .def_static(
          "load",
          [](const py::object& file, std::size_t threads, const py::object& progress) {
            return load(py::module_::import("os").attr("fspath")(file).cast<std::string>(), threads, progress);
          },
          py::arg("file"), py::kw_only(), py::arg("threads") = 1, py::arg("progress") = py::none(),
          "Loads a world from a file that save() has written.")
      .def("to_bytes", &to_bytes, R"(Returns the world as bytes in the format of saved worlds (.wwb).

>>> waywright.World.from_bytes(world.to_bytes()).items_hash == world.items_hash
True
)")
      .def_static("from_bytes", &from_bytes_of, py::arg("data"), py::kw_only(), py::arg("threads") = 1,
                  py::arg("progress") = py::none(), "Returns the world that to_bytes() has written.")
      .def(py::pickle(
          [](const WorldHandle& self) {
            return py::make_tuple(to_bytes(self), self.read([](const World& w) { return limit_of(w); }));
          },
          [](const py::tuple& state) {
            WorldPointer loaded = from_bytes_of(state[0].cast<py::bytes>(), 1, py::none());
            const auto limit = state[1].cast<std::optional<std::size_t>>();
            if (limit) loaded->write([&](World& w) { w.set_new_vertex_limit(*limit); });
            return loaded;
          }));
}

void bind_facts(WorldClass& world) {
  const auto fact = [&world](const char* name, auto read, const char* doc) {
    world.def_property_readonly(
        name, [read](const WorldHandle& self) { return self.read(read); }, doc);
  };
  fact(
      "domain", [](const World& w) { return w.domain(); }, "The smallest x and y and the largest x and y.");
  fact(
      "item_count", [](const World& w) { return w.item_count(); }, "The number of items.");
  fact(
      "vertex_count", [](const World& w) { return w.vertex_count(); }, "The number of vertices of the mesh.");
  fact(
      "triangle_count", [](const World& w) { return w.triangle_count(); }, "The number of triangles of the mesh.");
  fact(
      "version", [](const World& w) { return w.version(); },
      "The number of operations that the world has carried out.");
  fact(
      "items_hash", [](const World& w) { return w.items_hash(); },
      "The hash of the domain and the items, as 32 hexadecimal digits. It is equal for equal items on every machine.");
  fact(
      "largest_id_seen", [](const World& w) { return w.largest_id_seen(); }, "The largest id that the world has seen.");
  fact(
      "default_end_tolerance", [](const World& w) { return w.default_end_tolerance(); },
      "The default of ``end_tolerance`` in path queries.");
  world.def_property_readonly("options", &options_of, R"(The options, as World() takes them.

>>> waywright.World((0, 0, 1, 1), **world.options).options["keep_bridges"]
True
)");
  world.def_property(
      "new_vertex_limit", [](const WorldHandle& self) { return self.read([](const World& w) { return limit_of(w); }); },
      [](WorldHandle& self, std::optional<std::size_t> limit) {
        self.write([&](World& w) { w.set_new_vertex_limit(limit.value_or(kNoVertexLimit)); });
      },
      "The largest number of vertices that one operation may make; None for no limit.");
}

}  // namespace

void bind_world(WorldClass& world) {
  world
      .def(py::init(&create), py::arg("domain"), py::kw_only(), py::arg("keep_abstraction") = true,
           py::arg("keep_bridges") = false, py::arg("new_vertex_limit") = py::none())
      .def("clone", &clone, R"(Returns an independent copy, with the same answers and the same ids for later items.

>>> copy = world.clone()
>>> copy.remove(1)
>>> 1 in world, 1 in copy
(True, False)
)")
      .def("__copy__", &clone)
      .def(
          "__deepcopy__", [](const WorldHandle& self, const py::dict&) { return clone(self); }, py::arg("memo"))
      .def("memory", &memory_of, "Returns the bytes that the world takes, by purpose, and their sum as 'total'.")
      .def(
          "shrink_to_fit",
          [](WorldHandle& self) {
            self.write([](World& w) { w.shrink_to_fit(); });
            self.contexts().clear();
          },
          "Frees most of the spare memory.")
      .def("__repr__", &repr_of);
  bind_saving(world);
  bind_facts(world);
}

}  // namespace waywright::python
