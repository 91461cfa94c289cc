#include <ostream>
#include <string>

#include "waywright/replay.hpp"

#include "base/float_environment.hpp"
#include "io/write_script.hpp"
#include "text/text.hpp"

namespace waywright {

ReplayWriter::ReplayWriter(std::ostream& out, const World& world, std::uint64_t ticks_per_hash)
    : out_(&out), ticks_per_hash_(ticks_per_hash) {
  const base::FloatEnvironment environment;
  WAYWRIGHT_ASSERT(ticks_per_hash >= 1, "ReplayWriter: `ticks_per_hash` is 0");
  io::append_header(text_, world.domain());
  Shape shape;
  for (const ItemId id : world.item_ids()) {
    if (world.shape(id, shape).ok()) io::append_item(text_, id, shape);
  }
  static_cast<void>(write());  // the next call reports a failure
}

Result<void> ReplayWriter::record(const Change& change) { return record({&change, 1}, {&change.id, 1}); }

Result<void> ReplayWriter::record(std::span<const Change> changes, std::span<const ItemId> ids) {
  const base::FloatEnvironment environment;
  WAYWRIGHT_ASSERT(changes.size() == ids.size(), "ReplayWriter::record: there must be one id for each change");
  text_.clear();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (ids[i].is_null() || ids[i].value > ItemId::kLargest) return Error{ErrorCode::bad_id, {}, ids[i], i};
    if (changes[i].kind == Change::Kind::remove) {
      text_ += text::with_number("remove ", ids[i].value, "\n");
      continue;
    }
    if (changes[i].kind == Change::Kind::replace) text_ += "replace ";
    io::append_item(text_, ids[i], changes[i].shape);
  }
  return write();
}

Result<void> ReplayWriter::tick(const World& world) { return tick(world.items_hash()); }

Result<void> ReplayWriter::tick(const ItemsHash& hash) {
  const std::uint64_t tick = tick_ + 1;
  text_ = text::with_number("tick ", tick, "");
  const bool has_hash = tick % ticks_per_hash_ == 0;
  if (has_hash) text_ += " " + to_string(hash);
  text_ += '\n';
  tick_ = tick;  // no memory is needed from here on
  auto written = write();
  if (has_hash) out_->flush();
  return written.ok() && !out_->good() ? write() : written;
}

Result<void> ReplayWriter::write() {
  out_->write(text_.data(), static_cast<std::streamsize>(text_.size()));
  text_.clear();
  if (out_->good()) return {};
  return Error{ErrorCode::unwritable, "the replay log cannot be written: the stream accepts no more bytes", {}, 0};
}

}  // namespace waywright
