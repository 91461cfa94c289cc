#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/waywright.hpp"

// Conversions between values of Python and of the library. Every source file of the module includes this header, so
// that all files convert a type in the same manner.

namespace waywright::python {

namespace py = pybind11;

/// Whether T is a class of the library that the module shows as a class of Python. The classes of the module itself
/// have a member type BoundToPython instead.
template <class T>
inline constexpr bool kIsBoundToPython = false;
template <>
inline constexpr bool kIsBoundToPython<Agent> = true;
template <>
inline constexpr bool kIsBoundToPython<BridgeList> = true;
template <>
inline constexpr bool kIsBoundToPython<Change> = true;
template <>
inline constexpr bool kIsBoundToPython<DiscFit> = true;
template <>
inline constexpr bool kIsBoundToPython<Location> = true;
template <>
inline constexpr bool kIsBoundToPython<MeshSnapshot> = true;
template <>
inline constexpr bool kIsBoundToPython<NearestFit> = true;
template <>
inline constexpr bool kIsBoundToPython<Path> = true;
template <>
inline constexpr bool kIsBoundToPython<PathChanges> = true;
template <>
inline constexpr bool kIsBoundToPython<PathPosition> = true;
template <>
inline constexpr bool kIsBoundToPython<RayHit> = true;
template <>
inline constexpr bool kIsBoundToPython<ReplayResult> = true;
template <>
inline constexpr bool kIsBoundToPython<Scene> = true;
template <>
inline constexpr bool kIsBoundToPython<Script> = true;
template <>
inline constexpr bool kIsBoundToPython<ScriptLine> = true;
template <>
inline constexpr bool kIsBoundToPython<Shape> = true;
template <>
inline constexpr bool kIsBoundToPython<WidestPath> = true;

template <class T>
concept BoundToPython = kIsBoundToPython<T> || requires {
  typename T::BoundToPython;
};

/// Reads a point from a pair of numbers, or from an object with `__geo_interface__`. Returns whether there is one.
[[nodiscard]] bool read_point(py::handle object, Point& point);
/// Reads a box from four numbers (the smallest x and y, the largest x and y), or from two points.
[[nodiscard]] bool read_box(py::handle object, Box& box);
/// Reads an id from an integer, or null from None.
[[nodiscard]] bool read_id(py::handle object, ItemId& id);
/// Reads the form of an item from a Shape, from an object with `__geo_interface__`, or from a GeoJSON object.
/// Exceptions: throws the exception of Python that says what is wrong.
[[nodiscard]] Shape read_shape(py::handle object);
/// The member __reduce_ex__ of classes without pickle. (By itself, Python would write objects without contents with its
/// old protocols.) Exceptions: always throws a TypeError.
[[noreturn]] py::object refuse_pickle(const py::object& self, int protocol);
/// Returns a new tuple of two numbers.
[[nodiscard]] py::handle new_pair(double x, double y);

/// An argument that is the form of an item. It refers to a Shape of Python, or contains one that was made from
/// another geometry.
struct ShapeArg {
  const Shape* shape = nullptr;
  Shape made;

  [[nodiscard]] const Shape& get() const { return shape != nullptr ? *shape : made; }
};

using DoubleArray =
    py::array_t<double, py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_>;

/// Exceptions: py::value_error, if `source` is a masked array that hides elements, or a list that contains one.
void refuse_masked(py::handle source);
/// Returns an array of doubles: `source` itself if it contains doubles in C order, otherwise a copy. `what` names the
/// argument in an error: "points must be numbers: an array of shape (N, 2)".
/// Exceptions: throws a TypeError, whose cause is the exception of NumPy, if the elements are no real numbers. Throws a
/// ValueError if a masked array hides elements.
[[nodiscard]] DoubleArray doubles_of(py::handle source, const char* what);
/// Returns the name of a file from text, bytes or an object with `__fspath__`.
/// Exceptions: py::value_error, if there is a zero byte in the name. The exception of os.fsencode.
[[nodiscard]] std::string file_name_of(py::handle source);

/// An argument that is a list of points: an array of shape (N, 2). It refers to the memory of the caller's array if
/// this array contains doubles in C order. Otherwise it contains a copy.
struct PointsArg {
  DoubleArray array;

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(array.size()) / 2; }
  [[nodiscard]] std::span<const Point> span() const;
};

/// An argument that is one agent for all queries of a batch, or a list with one for each query.
struct AgentsArg {
  std::vector<Agent> agents;
  bool is_one = true;

  [[nodiscard]] const Agent& operator[](std::size_t i) const { return agents[is_one ? 0 : i]; }
  /// Exceptions: py::value_error, if it is a list that has not `count` elements.
  void check_count(std::size_t count) const;
};
/// Reads agents from an Agent, or from a sequence of them. Exceptions: py::type_error, if the object is neither.
void read_agents(py::handle object, AgentsArg& agents);

/// An argument that is a number of threads.
struct ThreadCount {
  std::size_t value = 1;
};

/// Returns an array of points that refers to `points`. `owner` is the object of Python that owns their memory. Nobody
/// can write to the array.
[[nodiscard]] py::array view_points(std::span<const Point> points, py::handle owner);
/// Returns a view of numbers in the memory of `owner`. `shape` and `strides` are as in NumPy, the strides in bytes.
template <class T>
[[nodiscard]] py::array view_numbers(const T* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                                     py::handle owner) {
  if (data == nullptr) return py::array_t<T>(std::move(shape));
  py::array_t<T> array(std::move(shape), std::move(strides), data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}
/// Returns an array that owns the elements of `values`, without a copy of them. Its elements are T, a number type.
template <class T>
[[nodiscard]] py::array own_numbers(std::vector<T> values) {
  auto* const kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* pointer) { delete static_cast<std::vector<T>*>(pointer); });
  return py::array_t<T>(static_cast<py::ssize_t>(kept->size()), kept->data(), owner);
}
/// Returns an array of shape (N, 2) that owns the points, without a copy of them.
[[nodiscard]] py::array own_points(std::vector<Point> points);
/// Returns the array of ids that owns the elements of `ids`, without a copy of them.
[[nodiscard]] py::array own_ids(std::vector<ItemId> ids);

/// Returns the bytes of an array of a trivial type, for pickle.
template <class T>
[[nodiscard]] py::bytes bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
/// Returns the array whose bytes bytes_of() has returned.
/// Exceptions: py::value_error, if the number of bytes is wrong.
template <class T>
[[nodiscard]] std::vector<T> from_bytes(const py::bytes& bytes) {
  const std::string_view text = bytes;
  if (text.size() % sizeof(T) != 0) throw py::value_error("the pickled object is damaged");
  std::vector<T> values(text.size() / sizeof(T));
  if (!text.empty()) std::memcpy(values.data(), text.data(), text.size());
  return values;
}

// The names of the values of each enumeration, as Python sees them. They are the names of world scripts.
inline constexpr std::array kPathAlgorithms = {PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal};
inline constexpr std::array kPathStatuses = {PathStatus::found, PathStatus::start_blocked, PathStatus::goal_blocked,
                                             PathStatus::no_path};
inline constexpr std::array kItemKinds = {ItemKind::point, ItemKind::segment, ItemKind::polyline, ItemKind::polygon};
inline constexpr std::array kFillRules = {FillRule::even_odd, FillRule::nonzero};
inline constexpr std::array kLocationKinds = {LocationKind::vertex, LocationKind::edge, LocationKind::face};
inline constexpr std::array kPrecisions = {Precision::float64, Precision::float32};
inline constexpr std::array kPieceKinds = {PathPiece::Kind::line, PathPiece::Kind::arc};
inline constexpr std::array kChangeKinds = {Change::Kind::insert, Change::Kind::remove, Change::Kind::replace};
inline constexpr std::array kThemes = {SvgTheme::automatic, SvgTheme::light, SvgTheme::dark};
inline constexpr std::array kDifferenceKinds = {ReplayDifference::Kind::domain, ReplayDifference::Kind::change,
                                                ReplayDifference::Kind::hash, ReplayDifference::Kind::length};

[[nodiscard]] inline std::string_view name_of(PathAlgorithm value) { return to_string(value); }
[[nodiscard]] inline std::string_view name_of(PathStatus value) { return to_string(value); }
[[nodiscard]] inline std::string_view name_of(ItemKind value) { return to_string(value); }
[[nodiscard]] inline std::string_view name_of(FillRule value) { return to_string(value); }
[[nodiscard]] inline std::string_view name_of(LocationKind value) { return to_string(value); }
[[nodiscard]] inline std::string_view name_of(Precision value) {
  return value == Precision::float64 ? "float64" : "float32";
}
[[nodiscard]] inline std::string_view name_of(PathPiece::Kind value) {
  return value == PathPiece::Kind::line ? "line" : "arc";
}
[[nodiscard]] inline std::string_view name_of(Change::Kind value) {
  constexpr std::array<std::string_view, 3> kNames = {"insert", "remove", "replace"};
  return kNames[static_cast<std::size_t>(value)];
}
[[nodiscard]] inline std::string_view name_of(SvgTheme value) {
  constexpr std::array<std::string_view, 3> kNames = {"automatic", "light", "dark"};
  return kNames[static_cast<std::size_t>(value)];
}
[[nodiscard]] inline std::string_view name_of(ReplayDifference::Kind value) {
  constexpr std::array<std::string_view, 4> kNames = {"domain", "change", "hash", "length"};
  return kNames[static_cast<std::size_t>(value)];
}

/// Throws a ValueError that lists the permitted names.
[[noreturn]] void refuse_name(std::string_view name, const std::vector<std::string_view>& names);

/// Reads a value from its name. Returns false if the object is no text.
/// Exceptions: py::value_error, if no value has this name.
template <class Enum, std::size_t N>
[[nodiscard]] bool read_name(py::handle object, const std::array<Enum, N>& all, Enum& value) {
  if (!PyUnicode_Check(object.ptr())) return false;
  Py_ssize_t size = 0;
  const char* const data = PyUnicode_AsUTF8AndSize(object.ptr(), &size);
  if (data == nullptr) throw py::error_already_set();
  const std::string_view name(data, static_cast<std::size_t>(size));
  for (const Enum each : all) {
    if (name_of(each) != name) continue;
    value = each;
    return true;
  }
  std::vector<std::string_view> names;
  for (const Enum each : all) names.push_back(name_of(each));
  refuse_name(name, names);
}

}  // namespace waywright::python

namespace pybind11::detail {

/// Refuses an object whose __init__ nobody has called, for example the result of World.__new__(World). pybind11 would
/// give the functions of the module memory without an object in it.
template <class T>
class type_caster<T, enable_if_t<waywright::python::BoundToPython<T>>> : public type_caster_base<T> {
 public:
  bool load(handle source, bool convert) { return this->template load_impl<type_caster>(source, convert); }
  /// pybind11 calls this.
  void load_value(value_and_holder&& object) {
    if (!object.holder_constructed()) throw type_error("an object is used whose __init__ has not been called");
    this->value = object.value_ptr();
  }
};

#define WAYWRIGHT_PYTHON_NAMES(Enum, all)                                                       \
  template <>                                                                                   \
  struct type_caster<Enum> {                                                                    \
    PYBIND11_TYPE_CASTER(Enum, const_name("str"));                                              \
    bool load(handle source, bool) { return waywright::python::read_name(source, all, value); } \
    static handle cast(Enum source, return_value_policy, handle) {                              \
      const std::string_view text = waywright::python::name_of(source);                         \
      return PyUnicode_FromStringAndSize(text.data(), static_cast<Py_ssize_t>(text.size()));    \
    }                                                                                           \
  }

WAYWRIGHT_PYTHON_NAMES(waywright::PathAlgorithm, waywright::python::kPathAlgorithms);
WAYWRIGHT_PYTHON_NAMES(waywright::PathStatus, waywright::python::kPathStatuses);
WAYWRIGHT_PYTHON_NAMES(waywright::ItemKind, waywright::python::kItemKinds);
WAYWRIGHT_PYTHON_NAMES(waywright::FillRule, waywright::python::kFillRules);
WAYWRIGHT_PYTHON_NAMES(waywright::LocationKind, waywright::python::kLocationKinds);
WAYWRIGHT_PYTHON_NAMES(waywright::Precision, waywright::python::kPrecisions);
WAYWRIGHT_PYTHON_NAMES(waywright::PathPiece::Kind, waywright::python::kPieceKinds);
WAYWRIGHT_PYTHON_NAMES(waywright::Change::Kind, waywright::python::kChangeKinds);
WAYWRIGHT_PYTHON_NAMES(waywright::SvgTheme, waywright::python::kThemes);
WAYWRIGHT_PYTHON_NAMES(waywright::ReplayDifference::Kind, waywright::python::kDifferenceKinds);
#undef WAYWRIGHT_PYTHON_NAMES

template <>
struct type_caster<waywright::Point> {
  PYBIND11_TYPE_CASTER(waywright::Point, const_name("tuple[float, float]"));
  bool load(handle source, bool) { return waywright::python::read_point(source, value); }
  static handle cast(const waywright::Point& point, return_value_policy, handle) {
    return waywright::python::new_pair(point.x, point.y);
  }
};

template <>
struct type_caster<waywright::Box> {
  PYBIND11_TYPE_CASTER(waywright::Box, const_name("tuple[float, float, float, float]"));
  bool load(handle source, bool) { return waywright::python::read_box(source, value); }
  static handle cast(const waywright::Box& box, return_value_policy, handle) {
    return make_tuple(box.min.x, box.min.y, box.max.x, box.max.y).release();
  }
};

template <>
struct type_caster<waywright::ItemId> {
  PYBIND11_TYPE_CASTER(waywright::ItemId, const_name("int"));
  bool load(handle source, bool) { return waywright::python::read_id(source, value); }
  static handle cast(waywright::ItemId id, return_value_policy, handle) {
    return PyLong_FromUnsignedLongLong(id.value);
  }
};

template <>
struct type_caster<waywright::python::PointsArg> {
  PYBIND11_TYPE_CASTER(waywright::python::PointsArg, const_name("points"));
  bool load(handle source, bool) {
    value.array = waywright::python::doubles_of(source, "points must be numbers: an array of shape (N, 2)");
    if (value.array.ndim() == 2 && value.array.shape(1) == 2) return true;
    if (value.array.ndim() == 1 && value.array.size() == 0) return true;  // an empty list
    throw value_error("points must be an array of shape (N, 2), not " +
                      std::string(str(static_cast<object>(value.array.attr("shape")))));
  }
};

template <>
struct type_caster<waywright::python::AgentsArg> {
  PYBIND11_TYPE_CASTER(waywright::python::AgentsArg, const_name("agent"));
  bool load(handle source, bool) {
    waywright::python::read_agents(source, value);
    return true;
  }
};

template <>
struct type_caster<waywright::python::ThreadCount> {
  PYBIND11_TYPE_CASTER(waywright::python::ThreadCount, const_name("int"));
  bool load(handle source, bool) {
    const auto number = reinterpret_steal<object>(PyNumber_Index(source.ptr()));
    if (!number) throw error_already_set();
    if (number < int_(1)) throw value_error("threads must be 1 or more");
    value.value = PyLong_AsSize_t(number.ptr());
    if (PyErr_Occurred() != nullptr) throw error_already_set();
    return true;
  }
};

template <>
struct type_caster<waywright::python::ShapeArg> {
  PYBIND11_TYPE_CASTER(waywright::python::ShapeArg, const_name("shape"));
  bool load(handle source, bool) {
    make_caster<waywright::Shape> shape;
    if (shape.load(source, false)) {
      value.shape = static_cast<waywright::Shape*>(shape);
    } else {
      value.made = waywright::python::read_shape(source);
    }
    return true;
  }
};

template <>
struct type_caster<waywright::ItemsHash> {
  PYBIND11_TYPE_CASTER(waywright::ItemsHash, const_name("str"));
  static handle cast(const waywright::ItemsHash& hash, return_value_policy, handle) {
    return str(waywright::to_string(hash)).release();
  }
  bool load(handle, bool) { return false; }
};

}  // namespace pybind11::detail
