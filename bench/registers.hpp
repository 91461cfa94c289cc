#pragma once

namespace waywright::bench {

// Each function registers its benchmarks; main() calls them before it runs any.

void register_insertions();
void register_location();
void register_updates();
void register_degenerate();
void register_paths();
void register_disc_paths();
void register_many_paths();
void register_abstraction();
void register_maps();
void register_path_watch();
void register_snapshots();
void register_history();

void register_cgal_points();
void register_cgal_rounded();
void register_cgal_exact();

}  // namespace waywright::bench
