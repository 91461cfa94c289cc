#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "waywright/memory_use.hpp"

#include "memory/count.hpp"
#include "mesh/index.hpp"

namespace waywright::mesh {

/// What an edge carries for the layers above; the mesh only copies it. An edge with a label other than 0 is fixed: it
/// is never flipped.
using Label = std::uint32_t;

/// Labels by half-edge, in pages that come with the first label there: a million points have few fixed edges, and where
/// there are walls, most pages are in use. A page stays, so that what was once written can be written again without
/// memory.
class LabelPages {
 public:
  /// Makes this a place for the labels of half-edges below `count`.
  void cover(std::size_t count) {
    if (pages_.size() * kPageSize < count) pages_.resize((count + kPageSize - 1) / kPageSize);
  }
  void make_room(HalfEdge h) {
    if (pages_[number(h) / kPageSize] == nullptr) [[unlikely]]
      add_page(number(h) / kPageSize);
  }

  // Requires: there is room.
  [[nodiscard]] Label read(HalfEdge h) const { return (*pages_[number(h) / kPageSize])[number(h) % kPageSize]; }
  void write(HalfEdge h, Label label) { (*pages_[number(h) / kPageSize])[number(h) % kPageSize] = label; }

  void count_memory(MemoryUse& use) const {
    memory::count(use, &MemoryUse::walls, pages_);
    use.walls += page_count_ * sizeof(Page);
  }

 private:
  static constexpr std::size_t kPageSize = 1024;
  using Page = std::array<Label, kPageSize>;

  void add_page(std::size_t index);

  std::vector<std::unique_ptr<Page>> pages_;  ///< null where there never was a label
  std::size_t page_count_ = 0;
};

}  // namespace waywright::mesh
