#pragma once

#include "snapshot_handle.hpp"
#include "world_handle.hpp"

// The functions that add classes and functions to the module. Those with a template parameter add members that worlds
// and snapshots have: `Class` is WorldClass or SnapshotClass.

namespace waywright::python {

void bind_errors(py::module_& module);
void bind_shapes(py::module_& module);
void bind_answers(py::module_& module);
void bind_path(py::module_& module);
void bind_mesh_snapshot(py::module_& module);
void bind_search(py::module_& module);
void bind_watch(py::module_& module);
void bind_scenes(py::module_& module, WorldClass& world);
void bind_replay(py::module_& module);

void bind_world(WorldClass& world);
void bind_loading(WorldClass& world);
void bind_world_items(WorldClass& world);
void bind_world_changes(py::module_& module, WorldClass& world);
void bind_snapshot(SnapshotClass& snapshot);

template <class Class>
void bind_facts(Class& world);
template <class Class>
void bind_saving(Class& world);
template <class Class>
void bind_reading_items(Class& world);
template <class Class>
void bind_changes_since(Class& world);
template <class Class>
void bind_world_queries(Class& world);
template <class Class>
void bind_world_paths(Class& world);
template <class Class>
void bind_batches(Class& world);
template <class Class>
void bind_path_batches(Class& world);
template <class Class>
void bind_mesh(Class& world);
template <class Class>
void bind_svg(Class& world);

}  // namespace waywright::python
