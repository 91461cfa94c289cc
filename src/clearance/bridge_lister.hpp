#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "waywright/clearance.hpp"

#include "clearance/bridge_finder.hpp"
#include "clearance/bridges.hpp"
#include "clearance/cells.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "constraint/cover_finder.hpp"
#include "memory/scratch.hpp"

namespace waywright::clearance {

/// Lists bridges for a program. The list depends only on the positions of the walls. Use one object for many queries,
/// because it keeps its memory.
class BridgeLister {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Lists the bridges that have a position in common with the closed box, without those in the interior of polygons.
  /// `cover_finder` finds the polygons. Requires: `bridges` belongs to the triangulation. Cost: linear in the faces
  /// that meet the box and in the bridges that cross them, n log n in the list, and a search for the first face.
  void list(const Triangulation& triangulation, const Bridges& bridges, constraint::CoverFinder& cover_finder,
            const Box& box, BridgeList& result);

 private:
  /// What a query knows about a face. The member marks_ stores a sum of these values.
  enum Mark : std::uint32_t {
    kMeets = 1,     ///< the face is in faces_
    kSearched = 2,  ///< a search beyond the box has looked for foot bridges that start in the face
    kOpen = 4,      ///< the face is in faces_, and no polygon covers it
    kCovered = 8,   ///< the face is in faces_, and a polygon covers it
    kMarks = 16,    ///< the step of the query numbers: larger than the sum of all marks
  };

  /// A bridge of the list.
  struct Listed {
    CellEdge gate;
    exact::Gap gap;
    Point to;
  };

  /// What one call of list() needs.
  struct Query;

  [[nodiscard]] bool has(mesh::Face f, Mark mark) const {
    const std::uint32_t marks = marks_[number(f)];
    return marks >= stamp_.value() && ((marks - stamp_.value()) & mark) != 0;
  }
  void add(mesh::Face f, Mark mark) {
    std::uint32_t& marks = marks_[number(f)];
    marks = std::max(marks, stamp_.value()) | mark;
  }

  void collect_faces(const Query& query, const Box& near);
  void search_beyond(const Query& query, BridgeFinder& finder, const Box& near, mesh::HalfEdge border);
  void offer_feet(const Query& query, mesh::Face f, mesh::Face connected);
  void offer(const Query& query, const CellEdge& gate, mesh::Face connected);
  [[nodiscard]] bool is_open(const Query& query, mesh::Face f);
  void sort_listed();
  [[nodiscard]] static Bridge append_items(const Triangulation& triangulation, const Bridges& bridges,
                                           const Listed& listed, std::vector<ItemId>& ids);

  memory::ZeroedArray<std::uint32_t> marks_;  ///< by face: the number of the last query, plus its marks
  memory::Stamp stamp_;
  std::vector<mesh::Face> faces_;  ///< the faces that meet the box
  std::vector<mesh::HalfEdge> to_visit_;
  std::vector<mesh::Face> connected_;
  BridgeScratch scratch_;
  std::vector<Listed> listed_;
};

}  // namespace waywright::clearance
