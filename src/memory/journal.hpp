#pragma once

#include <cstddef>
#include <vector>

#include "waywright/memory_use.hpp"

#include "memory/count.hpp"

namespace waywright::memory {

/// The undo log of one operation: a record of each change, the oldest first. A record contains the data from which the
/// change can be undone. Call add() before the change, because memory may run out in add(). roll_back() allocates
/// nothing.
///
///     journal.begin();                            // the operation starts
///     journal.add({i, values[i]});                // before each change
///     journal.roll_back([&](const Undo& undo) { values[undo.i] = undo.value; });
template <class Undo>
class Journal {
 public:
  /// Starts an operation: drops all records.
  void begin() { records_.clear(); }
  void add(const Undo& undo) { records_.push_back(undo); }
  /// Calls undo(record) for each record since begin(), the newest first, and drops them.
  template <class Function>
  void roll_back(Function&& undo) {
    while (!records_.empty()) {
      const Undo record = records_.back();
      records_.pop_back();
      undo(record);
    }
  }
  /// Calls visit(record) for each record since begin(), the oldest first.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const Undo& record : records_) visit(record);
  }

  void count_memory(MemoryUse& use) const { count_spare(use, records_); }
  /// Drops all records and frees their memory.
  void release() noexcept { memory::release(records_); }

 private:
  std::vector<Undo> records_;
};

}  // namespace waywright::memory
