#pragma once

#include "world_handle.hpp"

// The functions that add classes and functions to the module, one for each source file.

namespace waywright::python {

void bind_errors(py::module_& module);
void bind_shapes(py::module_& module);
void bind_answers(py::module_& module);
void bind_path(py::module_& module);
void bind_world(WorldClass& world);
void bind_world_items(WorldClass& world);
void bind_world_changes(WorldClass& world);
void bind_world_queries(WorldClass& world);
void bind_world_paths(WorldClass& world);
void bind_batches(WorldClass& world);
void bind_path_batches(WorldClass& world);
void bind_mesh(py::module_& module, WorldClass& world);
void bind_search(py::module_& module);
void bind_watch(py::module_& module);
void bind_scenes(py::module_& module, WorldClass& world);
void bind_replay(py::module_& module);
void bind_svg(WorldClass& world);

}  // namespace waywright::python
