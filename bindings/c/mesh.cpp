#include "internal.hpp"
#include "structs.hpp"

using namespace waywright;
using namespace waywright::c;

ww_status ww_world_vertex_count(const ww_world* world, size_t* vertex_count) {
  return guarded([&] {
    answer(vertex_count) = object(world).vertex_count();
    return WW_OK;
  });
}

ww_status ww_world_triangle_count(const ww_world* world, size_t* triangle_count) {
  return guarded([&] {
    answer(triangle_count) = object(world).triangle_count();
    return WW_OK;
  });
}

ww_status ww_world_snapshot(const ww_world* world, ww_context* context, ww_mesh* mesh) {
  return guarded([&] {
    object(world).snapshot(object(context).query, object(mesh));
    return WW_OK;
  });
}

ww_status ww_mesh_vertices(const ww_mesh* mesh, ww_point* vertices, size_t capacity, size_t* count) {
  return guarded([&] { return write_points(object(mesh).vertices, ListOut<ww_point>(vertices, capacity, count)); });
}

ww_status ww_mesh_triangles(const ww_mesh* mesh, ww_triangle* triangles, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_triangle> list(triangles, capacity, count);
    return list.write(object(mesh).triangles, [](const std::array<std::uint32_t, 3>& triangle) {
      return ww_triangle{{triangle[0], triangle[1], triangle[2]}};
    });
  });
}

ww_status ww_mesh_constrained_edges(const ww_mesh* mesh, ww_constrained_edge* edges, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_constrained_edge> list(edges, capacity, count);
    return list.write(object(mesh).constraints, [](const MeshSnapshot::ConstrainedEdge& edge) {
      return ww_constrained_edge{{edge.vertices[0], edge.vertices[1]}, edge.first_id, edge.id_count};
    });
  });
}

ww_status ww_mesh_ids(const ww_mesh* mesh, ww_id* ids, size_t capacity, size_t* count) {
  return guarded([&] { return write_ids(object(mesh).ids, ListOut<ww_id>(ids, capacity, count)); });
}

ww_status ww_world_dump(const ww_world* world, ww_text* text) {
  return guarded([&] {
    object(text) = object(world).dump();
    return WW_OK;
  });
}

ww_status ww_world_items_hash(const ww_world* world, ww_items_hash* hash) {
  return guarded([&] {
    answer(hash) = to_c(object(world).items_hash());
    return WW_OK;
  });
}

ww_status ww_world_mesh_hash(const ww_world* world, ww_mesh_hash* hash) {
  return guarded([&] {
    ww_mesh_hash& out = answer(hash);
    const MeshHash found = object(world).mesh_hash();
    std::copy(found.bytes.begin(), found.bytes.end(), out.bytes);
    return WW_OK;
  });
}

ww_status ww_items_hash_text(const ww_items_hash* hash, char* buffer, size_t capacity, size_t* count) {
  return guarded([&] {
    require(hash != nullptr, "a pointer to a hash is null");
    return write_text(to_string(ItemsHash{{hash->words[0], hash->words[1]}}), buffer, capacity, count);
  });
}

ww_status ww_mesh_hash_text(const ww_mesh_hash* hash, char* buffer, size_t capacity, size_t* count) {
  return guarded([&] {
    require(hash != nullptr, "a pointer to a hash is null");
    MeshHash copy;
    std::copy_n(hash->bytes, copy.bytes.size(), copy.bytes.begin());
    return write_text(to_string(copy), buffer, capacity, count);
  });
}

ww_status ww_world_validate(const ww_world* world, ww_bool* is_valid, ww_text* fault) {
  return guarded([&] {
    ww_bool& out = answer(is_valid);
    Validation validation = object(world).validate();
    out = to_c(validation.ok);
    if (fault != nullptr) object(fault) = std::move(validation.fault);
    return WW_OK;
  });
}

ww_status ww_world_memory(const ww_world* world, ww_memory_use* use) {
  return guarded([&] {
    const StructOut out(use);
    out.write(to_c(object(world).memory()));
    return WW_OK;
  });
}

ww_status ww_world_shrink_to_fit(ww_world* world) {
  return guarded([&] {
    changing(world).shrink_to_fit();
    return WW_OK;
  });
}

ww_status ww_get_predicate_counts(ww_predicate_counts* counts) {
  return guarded([&] {
    const StructOut out(counts);
    const PredicateCounts found = predicate_counts();
    const auto stages = [](const StageCounts& stage) {
      return ww_stage_counts{stage.doubles, stage.lattice, stage.integers};
    };
    out.write({0, stages(found.orientation), stages(found.in_circle), stages(found.order), stages(found.crossing)});
    return WW_OK;
  });
}
