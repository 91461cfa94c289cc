#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/waywright.hpp"

#include "waywright.h"

/// The declarations that all sources of the C interface share: errors, structs with a size, lists, and the C++ objects
/// behind the opaque types.
namespace waywright::c {

/// A broken rule of the interface, or a missing feature. The functions below throw it, and guarded() catches it.
struct Refusal {
  ww_status status;
  const char* message;  ///< a literal
};

/// Throws a Refusal with WW_INVALID_ARGUMENT unless `condition` is true.
inline void require(bool condition, const char* message) {
  if (!condition) throw Refusal{WW_INVALID_ARGUMENT, message};
}

/// Records an error for ww_last_error() and returns its status.
ww_status fail(ww_status status, const char* message) noexcept;
ww_status fail(const Error& error);
/// Records the exception that is being handled, and returns its status.
ww_status fail_by_exception() noexcept;

/// Makes a call of the interface, and turns each exception into a status.
template <class Call>
ww_status guarded(Call&& call) noexcept {
  try {
    return call();
  } catch (...) {
    return fail_by_exception();
  }
}

/// Returns the status of a result, and records its error.
template <class T>
ww_status status_of(const Result<T>& result) {
  return result.ok() ? ww_status{WW_OK} : fail(result.error());
}

/// The data that a query keeps between calls: the context of the library, and answers.
struct Context {
  QueryContext query;
  std::vector<QueryContext> more;  ///< for the threads of ww_world_find_paths
  std::vector<ItemId> ids;
  std::vector<CrossedItem> crossed;
  Location location;
  RayHit hit;
  DiscFit fit;
  WidestPath widest;
  BridgeList bridges;
};

/// A search, and the world in which it began. The world may be gone.
struct Search {
  PathSearch search;
  const World* world = nullptr;
};

/// A path watch with the world for which it was made, and the answer of its last update. The world may be gone.
struct Watch {
  explicit Watch(const World& watched) : watch(watched), world(&watched) {}

  PathWatch watch;
  const World* world;
  PathChanges changes;
};

/// A replay log: its stream and its writer.
struct ReplayLog;

/// The C++ class of an opaque type. A pointer to the opaque type is a pointer to an object of this class.
template <class Opaque>
struct ObjectOf;
template <>
struct ObjectOf<ww_world> {
  using Type = World;
};
template <>
struct ObjectOf<ww_context> {
  using Type = Context;
};
template <>
struct ObjectOf<ww_items> {
  using Type = std::vector<Item>;
};
template <>
struct ObjectOf<ww_path> {
  using Type = Path;
};
template <>
struct ObjectOf<ww_paths> {
  using Type = std::vector<Path>;
};
template <>
struct ObjectOf<ww_search> {
  using Type = Search;
};
template <>
struct ObjectOf<ww_path_watch> {
  using Type = Watch;
};
template <>
struct ObjectOf<ww_snapshot> {
  using Type = WorldSnapshot;
};
template <>
struct ObjectOf<ww_mesh> {
  using Type = MeshSnapshot;
};
template <>
struct ObjectOf<ww_text> {
  using Type = std::string;
};
template <>
struct ObjectOf<ww_scene> {
  using Type = Scene;
};
template <>
struct ObjectOf<ww_script> {
  using Type = Script;
};
template <>
struct ObjectOf<ww_scenario> {
  using Type = std::vector<ScenarioQuery>;
};
template <>
struct ObjectOf<ww_replay_writer> {
  using Type = ReplayLog;
};
template <>
struct ObjectOf<ww_replay> {
  using Type = ReplayResult;
};
template <>
struct ObjectOf<ww_svg_overlay> {
  using Type = SvgOverlay;
};

/// A call of the calling thread that uses a world and runs a function of the caller. Calls of this function about the
/// same world are nested in it.
class RunningCall {
 public:
  enum class Use { reads, asks, changes };

  RunningCall(const World& world, Use use);
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;

  /// Returns whether a running call of the calling thread uses a world in one of these manners.
  [[nodiscard]] static bool uses(const World& world, std::initializer_list<Use> manners);

 private:
  const World* world_;
  Use use_;
  const RunningCall* outer_;
};

/// Throws a Refusal if a running call of this thread changes the world.
void require_unchanging(const World& world);
/// Throws a Refusal if a running call of this thread uses the world.
void require_unused(const World& world);
/// Throws a Refusal if this thread is asking a question of ww_world_attempt about the world.
void require_no_question(const World& world);

/// Returns the object behind a pointer of the caller.
template <class Opaque>
typename ObjectOf<Opaque>::Type& object(Opaque* pointer) {
  require(pointer != nullptr, "a pointer to an object is null");
  return *reinterpret_cast<typename ObjectOf<Opaque>::Type*>(pointer);
}
template <class Opaque>
const typename ObjectOf<Opaque>::Type& object(const Opaque* pointer) {
  require(pointer != nullptr, "a pointer to an object is null");
  return *reinterpret_cast<const typename ObjectOf<Opaque>::Type*>(pointer);
}
/// Returns the world of a call that reads it.
inline const World& object(const ww_world* pointer) {
  require(pointer != nullptr, "a pointer to an object is null");
  const World& world = *reinterpret_cast<const World*>(pointer);
  require_unchanging(world);
  return world;
}
template <class Opaque>
Opaque* opaque(typename ObjectOf<Opaque>::Type* object) {
  return reinterpret_cast<Opaque*>(object);
}
template <class Opaque>
const Opaque* opaque(const typename ObjectOf<Opaque>::Type* object) {
  return reinterpret_cast<const Opaque*>(object);
}

/// Returns the world of a call that changes it.
inline World& changing(ww_world* world) {
  World& changed = object(world);
  require_unused(changed);
  return changed;
}

/// Returns the variable behind a pointer for an answer.
template <class T>
T& answer(T* pointer) {
  require(pointer != nullptr, "a pointer for an answer is null");
  return *pointer;
}

/// Writes an answer that the caller may not want.
template <class T, class Value>
void write_if_wanted(T* pointer, const Value& value) {
  if (pointer != nullptr) *pointer = static_cast<T>(value);
}

/// The size that a struct had in the first version of the library that contained it. If a later version appends members
/// to a struct, it specialises this constant.
template <class Struct>
inline constexpr std::size_t kFirstSize = sizeof(Struct);

/// Throws a Refusal unless a version of the library knows a struct of this size.
template <class Struct>
void require_size(std::size_t size) {
  require(size >= kFirstSize<Struct>, "struct_size is too small: set it to the size of the struct");
  require(size <= sizeof(Struct), "struct_size is too large: the program was compiled for a later version");
}

/// Returns a copy of a struct of the caller. Members that the caller's version of the struct does not have are copied
/// from `defaults`.
template <class Struct>
Struct read_struct(const Struct* given, Struct defaults) {
  require(given != nullptr, "a pointer to a struct is null");
  require_size<Struct>(given->struct_size);
  std::memcpy(static_cast<void*>(&defaults), given, given->struct_size);
  return defaults;
}

/// A struct of the caller for an answer.
template <class Struct>
class StructOut {
 public:
  explicit StructOut(Struct* out) : out_(out) {
    require(out != nullptr, "a pointer for an answer is null");
    require_size<Struct>(out->struct_size);
  }
  void write(Struct value) const {
    value.struct_size = out_->struct_size;
    std::memcpy(static_cast<void*>(out_), &value, value.struct_size);
  }

 private:
  Struct* out_;
};

/// Sets a struct of the caller to its defaults.
template <class Struct>
ww_status init_struct(Struct* out, std::size_t size, Struct defaults) noexcept {
  return guarded([&] {
    require(out != nullptr, "a pointer to a struct is null");
    require_size<Struct>(size);
    defaults.struct_size = static_cast<std::uint32_t>(size);
    std::memcpy(static_cast<void*>(out), &defaults, size);
    return WW_OK;
  });
}

/// A buffer of the caller for a list.
template <class T>
class ListOut {
 public:
  ListOut(T* buffer, std::size_t capacity, std::size_t* count) : buffer_(buffer), capacity_(capacity), count_(count) {
    require(buffer != nullptr || capacity == 0, "a buffer is null, and its capacity is not 0");
  }
  /// Writes the values of a list, converted by `convert`.
  template <class List, class Convert>
  ww_status write(const List& values, Convert convert) const {
    const std::size_t total = values.size();
    if (count_ != nullptr) *count_ = total;
    const std::size_t written = std::min(total, capacity_);
    for (std::size_t i = 0; i < written; ++i) buffer_[i] = convert(values[i]);
    if (buffer_ == nullptr || total <= capacity_) return WW_OK;
    return fail(WW_BUFFER_TOO_SMALL, "a buffer is too small: its count says how many elements there are");
  }

 private:
  T* buffer_;
  std::size_t capacity_;
  std::size_t* count_;
};

/// Writes a text and its zero byte.
ww_status write_text(std::string_view text, char* buffer, std::size_t capacity, std::size_t* count);

inline Point to_cpp(const ww_point& point) { return {point.x, point.y}; }
inline Box to_cpp(const ww_box& box) { return {to_cpp(box.min), to_cpp(box.max)}; }
inline ww_point to_c(const Point& point) { return {point.x, point.y}; }
inline ww_box to_c(const Box& box) { return {to_c(box.min), to_c(box.max)}; }
inline ItemId to_id(ww_id id) { return ItemId{id}; }
inline ww_id to_c(ItemId id) { return id.value; }
inline ww_bool to_c(bool value) { return value ? 1 : 0; }
inline ww_items_hash to_c(const ItemsHash& hash) { return {{hash.words[0], hash.words[1]}}; }
/// Reads a member of the type ww_bool.
inline bool is_set(ww_bool value) { return value != 0; }
/// Reads a number of triangles: UINT64_MAX stands for no limit.
inline std::size_t to_expansions(std::uint64_t given) {
  return static_cast<std::size_t>(std::min<std::uint64_t>(given, PathBudget::kNoLimit));
}

inline ww_status write_points(std::span<const Point> points, const ListOut<ww_point>& out) {
  return out.write(points, [](const Point& point) { return to_c(point); });
}
inline ww_status write_ids(std::span<const ItemId> ids, const ListOut<ww_id>& out) {
  return out.write(ids, [](ItemId id) { return to_c(id); });
}

/// Returns an enumerator of the caller. Throws a Refusal if the number is no enumerator: the enumerators count from 0
/// to `last`.
template <class Enum>
Enum to_enum(std::int32_t value, Enum last) {
  require(value >= 0 && value <= static_cast<std::int32_t>(last), "an argument is no enumerator of its type");
  return static_cast<Enum>(value);
}

static_assert(sizeof(ww_point) == sizeof(Point) && alignof(ww_point) == alignof(Point) &&
              offsetof(ww_point, y) == offsetof(Point, y));

/// Returns a view of an array of the caller.
template <class T>
std::span<const T> to_span(const T* values, std::size_t count) {
  require(values != nullptr || count == 0, "an array is null, and its count is not 0");
  return {values, count};
}
inline PointSpan to_points(const ww_point* points, std::size_t count) {
  return std::span(reinterpret_cast<const Point*>(to_span(points, count).data()), count);
}
inline std::string_view to_view(const char* text, std::size_t length) {
  require(text != nullptr || length == 0, "a text is null, and its length is not 0");
  return {text, length};
}
inline std::string_view to_view(const char* text) {
  require(text != nullptr, "a text is null");
  return text;
}
inline std::string_view text_or_empty(const char* text) { return text != nullptr ? text : ""; }

Shape to_shape(const ww_shape* shape);
std::vector<Change> to_changes(const ww_change* changes, std::size_t count);
PathQuery to_query(const ww_path_query* query);
SvgOptions to_options(const ww_svg_options* options);

/// Makes an object for the caller.
template <class Opaque, class... Arguments>
ww_status make_object(Opaque** out, Arguments&&... arguments) {
  Opaque*& pointer = answer(out);
  pointer = opaque<Opaque>(new typename ObjectOf<Opaque>::Type(std::forward<Arguments>(arguments)...));
  return WW_OK;
}
template <class Opaque>
void destroy_object(Opaque* pointer) noexcept {
  if (pointer != nullptr) delete &object(pointer);
}

/// A job system of the caller.
class Jobs final : public JobSystem {
 public:
  /// `jobs` may be null: then get() returns null.
  explicit Jobs(const ww_job_system* jobs);

  void run(std::size_t count, const std::function<void(std::size_t)>& job) override;
  [[nodiscard]] JobSystem* get() { return jobs_.run != nullptr ? this : nullptr; }

 private:
  ww_job_system jobs_{};
};

/// The options of a bulk load, with the job system to which they point. `given` may be null.
struct Bulk {
  explicit Bulk(const ww_bulk_options* given);
  Bulk(const Bulk&) = delete;
  Bulk& operator=(const Bulk&) = delete;

  Jobs jobs;
  BulkOptions options;

 private:
  explicit Bulk(const ww_bulk_options& given);
};

}  // namespace waywright::c
