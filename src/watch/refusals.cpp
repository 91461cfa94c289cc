#include "watch/refusals.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "watch/box_tests.hpp"

namespace waywright::watch {

void Refusals::add(std::uint32_t slot, const Refusal& refusal, double tolerance) {
  if (entries_.size() <= slot) entries_.resize(std::max<std::size_t>(slot + 1, 2 * entries_.size()));
  if (slots_.size() == slots_.capacity()) slots_.reserve(2 * slots_.size() + 4);
  if (listed_.capacity() < slots_.capacity()) listed_.reserve(slots_.capacity());
  Entry& entry = entries_[slot];
  entry.refusal = refusal;
  const double reach = std::min((tolerance + refusal.agent.radius) * (1.0 + 0x1p-30), 4.0 * kLargestCoordinate);
  const auto insert = [&](const Point& end, Index index) {
    const Box box = Box{end, end}.expanded(reach + slack_of(domain_.min, domain_.max));
    entry.boxes[index] = boxes_.insert(box, {slot, index});
  };
  // If the second insertion fails, remove() takes the first one back.
  entry.is_used = true;
  entry.is_decided = false;
  entry.index = static_cast<std::uint32_t>(slots_.size());
  slots_.push_back(slot);
  ++undecided_;
  insert(refusal.ends.start, kStart);
  insert(refusal.ends.goal, kGoal);
}

void Refusals::remove(std::uint32_t slot) noexcept {
  if (slot >= entries_.size() || !entries_[slot].is_used) return;
  forget_barrier(slot);
  Entry& entry = entries_[slot];
  for (std::optional<Boxes::Handle>& box : entry.boxes) {
    if (box) boxes_.remove(*box);
    box.reset();
  }
  --undecided_;
  entries_[slots_.back()].index = entry.index;
  slots_[entry.index] = slots_.back();
  slots_.pop_back();
  entry.is_used = false;
}

void Refusals::forget_barrier(std::uint32_t slot) noexcept {
  Entry& entry = entries_[slot];
  if (entry.boxes[kBarrier]) boxes_.remove(*entry.boxes[kBarrier]);
  entry.boxes[kBarrier].reset();
  if (entry.is_decided) ++undecided_;
  entry.is_decided = false;
  entry.did_fit = false;
}

void Refusals::set_barrier(std::uint32_t slot, const std::optional<Box>& box, bool fits) {
  forget_barrier(slot);
  Entry& entry = entries_[slot];
  if (box) {
    const Box larger = box->expanded(slack_of(domain_.min, domain_.max));
    entry.boxes[kBarrier] = boxes_.insert(larger, {slot, kBarrier});
  }
  entry.is_decided = true;
  entry.did_fit = fits;
  --undecided_;
}

void Refusals::put(std::uint32_t slot, bool is_changed) {
  Entry& entry = entries_[slot];
  entry.is_changed = is_changed || (entry.is_listed && entry.is_changed);
  if (std::exchange(entry.is_listed, true)) return;
  listed_.push_back(slot);
}

std::span<const std::uint32_t> Refusals::list(std::span<const ChangedBox> changes, bool all, bool all_points) {
  listed_.clear();
  for (const ChangedBox& changed : changes) {
    boxes_.for_each_overlapping(changed.box, [&](const BoxOfPath& box, const Box&) {
      if (box.index != kBarrier || changed.is_removal) put(box.slot, box.index != kBarrier);
    });
  }
  if (all || all_points || undecided_ != 0) {
    for (const std::uint32_t slot : slots_) {
      const Entry& entry = entries_[slot];
      if (all || !entry.is_decided || (all_points && entry.refusal.agent.radius == 0.0)) put(slot, all);
    }
  }
  for (const std::uint32_t slot : listed_) entries_[slot].is_listed = false;
  const auto key = [&](std::uint32_t slot) { return std::tuple(entries_[slot].refusal.agent.radius, slot); };
  std::sort(listed_.begin(), listed_.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  return listed_;
}

}  // namespace waywright::watch
