#include <string>

#include "bind.hpp"
#include "structs.hpp"

// Scenes, world scripts and scenarios.

namespace waywright::python {

namespace {

py::list pairs_of(const std::vector<Item>& items) {
  py::list list;
  for (const Item& item : items) list.append(py::make_tuple(item.id, item.shape));
  return list;
}

void bind_scene(py::module_& module, WorldClass& world) {
  py::class_<Scene>(module, "Scene", "A domain and its items, as a file gives them.")
      .def_property_readonly(
          "domain", [](const Scene& self) { return self.domain; }, "The box that contains everything.")
      .def_property_readonly(
          "items", [](const Scene& self) { return pairs_of(self.items); }, "Pairs (id, shape).")
      .def_property_readonly(
          "y_down", [](const Scene& self) { return self.y_down; }, "Whether the y axis of the file points down.")
      .def("__reduce_ex__", &refuse_pickle, py::arg("protocol"))
      .def("__repr__",
           [](const Scene& self) { return "<waywright.Scene of " + std::to_string(self.items.size()) + " items>"; });
  world.def_static(
      "from_scene",
      [](const Scene& scene, WAYWRIGHT_WORLD_OPTIONS_PARAMETERS, ThreadCount threads, const py::object& progress) {
        Reporter reporter(progress);
        const WithoutGil no_gil;
        World made = World::create(scene.domain, to_world_options(WAYWRIGHT_WORLD_OPTIONS_NAMES)).value();
        made.insert_all(scene.items, {.threads = threads.value, .progress = reporter.function()}).value();
        return std::make_shared<WorldHandle>(std::move(made));
      },
      py::arg("scene"), WAYWRIGHT_WORLD_OPTIONS_ARGUMENTS, py::arg("threads") = 1, py::arg("progress") = py::none(),
      R"(Returns a world with the domain and the items of a scene.

>>> scene = waywright.parse_movingai_map("type octile\nheight 2\nwidth 3\nmap\n..@\n..@\n")
>>> waywright.World.from_scene(scene)
<waywright.World (0, 0) to (3, 2), 1 items, 6 vertices>
)");
}

void bind_script_line(py::module_& module) {
  py::class_<ScriptLine>(module, "ScriptLine", "One line of a world script.")
      .def_property_readonly(
          "word", [](const ScriptLine& self) { return std::string(to_string(self)); },
          "The first word of the line: 'point', 'remove', 'path' and others.")
      .def_property_readonly(
          "is_insertion", [](const ScriptLine& self) { return self.kind == ScriptLineKind::insert; },
          "Whether the line inserts an item.")
      .def_property_readonly(
          "line", [](const ScriptLine& self) { return self.line; }, "The number of the line, from 1.")
      .def_property_readonly(
          "id", [](const ScriptLine& self) { return self.item.id; }, "The id of the item.")
      .def_property_readonly(
          "shape", [](const ScriptLine& self) { return self.item.shape; },
          "The shape of the item; for 'clear', a shape that has the points.")
      .def_property_readonly(
          "start", [](const ScriptLine& self) { return self.from; }, "The first point of a query.")
      .def_property_readonly(
          "end", [](const ScriptLine& self) { return self.to; }, "The second point of a query.")
      .def_property_readonly(
          "agent", [](const ScriptLine& self) { return self.agent; },
          "The agent of a query, with the radius of the line.")
      .def_property_readonly(
          "has_radius", [](const ScriptLine& self) { return self.has_radius; },
          "Of a 'ray': whether the line gives a radius.")
      .def_property_readonly(
          "has_goal", [](const ScriptLine& self) { return self.has_goal; },
          "Of 'nearest': whether the line gives a goal.")
      .def_property_readonly(
          "algorithm", [](const ScriptLine& self) { return self.algorithm; }, "The algorithm of a 'path', or None.")
      .def_property_readonly(
          "end_tolerance", [](const ScriptLine& self) { return self.end_tolerance; },
          "The tolerance of a 'path', or None.")
      .def_property_readonly(
          "tick", [](const ScriptLine& self) { return self.tick; }, "The number of a 'tick', 'mark' or 'rewind'.")
      .def_property_readonly(
          "items_hash", [](const ScriptLine& self) { return self.items_hash; }, "The hash of a 'tick', or None.")
      .def("__reduce_ex__", &refuse_pickle, py::arg("protocol"))
      .def("__repr__", [](const ScriptLine& self) {
        return "<waywright.ScriptLine " + std::to_string(self.line) + ": " + std::string(to_string(self)) + ">";
      });
}

void bind_script(py::module_& module) {
  bind_script_line(module);
  py::class_<Script>(module, "Script", "A world script, see docs/formats.md.")
      .def_property_readonly(
          "domain", [](const Script& self) { return self.domain; }, "The domain of the world.")
      .def_property_readonly(
          "lines", [](const Script& self) { return self.lines; }, "A list of the lines.")
      .def(
          "scene", [](const Script& self) { return scene_of(self); },
          "Returns the items that are left after all insertions, replacements and removals.")
      .def("__reduce_ex__", &refuse_pickle, py::arg("protocol"))
      .def("__repr__",
           [](const Script& self) { return "<waywright.Script of " + std::to_string(self.lines.size()) + " lines>"; });
  module.def(
      "parse_script", [](const std::string& text, const std::string& name) { return parse_script(text, name).value(); },
      py::arg("text"), py::arg("name") = "script", R"(Reads a world script.

>>> script = waywright.parse_script("waywright 1\ndomain 0 0 10 10\nsegment 1 4 0 4 7\npath 1 1 7 1 0\n")
>>> [line.word for line in script.lines]
['segment', 'path']
)");
}

}  // namespace

void bind_scenes(py::module_& module, WorldClass& world) {
  bind_scene(module, world);
  bind_script(module);
  module.def(
      "read_scene",
      [](const py::object& file) {
        const std::string name = file_name_of(file);
        const WithoutGil no_gil;
        return read_scene(name).value();
      },
      py::arg("file"),
      "Reads a scene from a file: a world script, a map of Moving AI, a file of Triangle, a saved world.");
  module.def(
      "parse_movingai_map",
      [](const std::string& text, const std::string& name) { return parse_movingai_map(text, name).value(); },
      py::arg("text"), py::arg("name") = "map", "Reads a map of Moving AI.");
  module.def(
      "to_script", [](const Scene& scene) { return to_script(scene); }, py::arg("scene"),
      "Returns a scene as a world script.");
  module.def(
      "parse_movingai_scenario",
      [](const std::string& text, const std::string& name) {
        const auto queries = parse_movingai_scenario(text, name).value();
        std::vector<Point> starts, goals;
        std::vector<double> lengths;
        for (const ScenarioQuery& query : queries) {
          starts.push_back(query.start);
          goals.push_back(query.goal);
          lengths.push_back(query.length);
        }
        return py::make_tuple(own_points(std::move(starts)), own_points(std::move(goals)),
                              own_numbers(std::move(lengths)));
      },
      py::arg("text"), py::arg("name") = "scenario",
      "Reads a scenario of Moving AI. Returns arrays of the starts, the goals and the lengths.");
}

}  // namespace waywright::python
