#include <iterator>
#include <optional>
#include <sstream>
#include <string>

#include "bind.hpp"

// Saving and loading worlds, and pickle.

namespace waywright::python {

namespace {

template <class Handle>
py::bytes to_bytes(const Handle& self) {
  const std::string bytes = self.read_long([](const World& world) {
    std::ostringstream out;
    save_world(world, out).value();
    return std::move(out).str();
  });
  return bytes;
}

WorldPointer from_bytes_of(const py::bytes& bytes, ThreadCount threads, const py::object& progress) {
  Reporter reporter(progress);
  const std::string text = bytes;
  const WithoutGil no_gil;
  std::istringstream in(text);
  auto world = load_world(in, {.threads = threads.value, .progress = reporter.function()}).value();
  if (in.peek() != std::char_traits<char>::eof()) {
    throw BadResult({ErrorCode::malformed, "the bytes contain more than a saved world", {}, 0});
  }
  return std::make_shared<WorldHandle>(std::move(world));
}

WorldPointer load(const std::string& file_name, ThreadCount threads, const py::object& progress) {
  Reporter reporter(progress);
  const WithoutGil no_gil;
  return std::make_shared<WorldHandle>(
      load_world_file(file_name, {.threads = threads.value, .progress = reporter.function()}).value());
}

}  // namespace

template <class Class>
void bind_saving(Class& world) {
  using Handle = typename Class::type;
  world
      .def(
          "save",
          [](const Handle& self, const py::object& file) {
            const std::string name = file_name_of(file);
            self.read_long([&](const World& w) { save_world_file(w, name).value(); });
          },
          py::arg("file"), "Saves the world to a file (.wwb). At every moment the file is the old one or the new one.")
      .def("to_bytes", &to_bytes<Handle>, R"(Returns the world as bytes in the format of saved worlds (.wwb).

>>> waywright.World.from_bytes(world.to_bytes()).items_hash == world.items_hash
True
)");
}

template void bind_saving(WorldClass& world);
template void bind_saving(SnapshotClass& snapshot);

void bind_loading(WorldClass& world) {
  world
      .def_static(
          "load",
          [](const py::object& file, ThreadCount threads, const py::object& progress) {
            return load(file_name_of(file), threads, progress);
          },
          py::arg("file"), py::kw_only(), py::arg("threads") = 1, py::arg("progress") = py::none(),
          "Loads a world from a file that save() has written.")
      .def_static("from_bytes", &from_bytes_of, py::arg("data"), py::kw_only(), py::arg("threads") = 1,
                  py::arg("progress") = py::none(), "Returns the world that to_bytes() has written.")
      .def(py::pickle(
          [](const WorldHandle& self) {
            return py::make_tuple(to_bytes(self), self.read([](const World& w) { return limit_of(w); }));
          },
          [](const py::tuple& state) {
            WorldPointer loaded = from_bytes_of(state[0].cast<py::bytes>(), {}, py::none());
            const auto limit = state[1].cast<std::optional<std::size_t>>();
            if (limit) loaded->write([&](World& w) { w.set_new_vertex_limit(*limit); });
            return loaded;
          }));
}

}  // namespace waywright::python
