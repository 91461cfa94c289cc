#include "convert.hpp"

#include <cstring>
#include <string>

namespace waywright::python {

static_assert(sizeof(Point) == 2 * sizeof(double) && sizeof(ItemId) == sizeof(std::uint64_t),
              "arrays of NumPy share the memory of points and ids");

namespace {

/// Forgets the exception of Python, if there is one. Passes on one such as KeyboardInterrupt.
void clear_error() {
  if (PyErr_Occurred() != nullptr && PyErr_ExceptionMatches(PyExc_Exception) == 0) throw py::error_already_set();
  PyErr_Clear();
}

/// Reads a number. Returns whether the object is one.
bool read_number(PyObject* object, double& number) {
  if (PyFloat_CheckExact(object)) {
    number = PyFloat_AS_DOUBLE(object);
    return true;
  }
  number = PyFloat_AsDouble(object);
  if (number != -1.0 || PyErr_Occurred() == nullptr) return true;
  clear_error();
  return false;
}

/// Reads `count` numbers from a sequence of this length that is neither a list nor a tuple.
bool read_other_numbers(PyObject* object, Py_ssize_t count, double* numbers) {
  if (PyUnicode_Check(object) || PyBytes_Check(object) || PySequence_Check(object) == 0) return false;
  const Py_ssize_t size = PySequence_Size(object);
  const auto iterator = size == count ? py::reinterpret_steal<py::object>(PyObject_GetIter(object)) : py::object();
  for (Py_ssize_t i = 0; iterator && i < count; ++i) {
    const auto item = py::reinterpret_steal<py::object>(PyIter_Next(iterator.ptr()));
    if (!item || !read_number(item.ptr(), numbers[i])) break;
    if (i == count - 1) return true;
  }
  clear_error();
  return false;
}

/// Reads `count` numbers from a sequence of this length. To read one can run code of Python, which can change the list.
bool read_numbers(PyObject* object, Py_ssize_t count, double* numbers) {
  if (!PyList_Check(object) && !PyTuple_Check(object)) return read_other_numbers(object, count, numbers);
  if (PySequence_Fast_GET_SIZE(object) != count) return false;
  for (Py_ssize_t i = 0; i < count; ++i) {
    if (i >= PySequence_Fast_GET_SIZE(object)) return false;
    const auto item = py::reinterpret_borrow<py::object>(PySequence_Fast_GET_ITEM(object, i));
    if (!read_number(item.ptr(), numbers[i])) return false;
  }
  return true;
}

/// Returns whether a masked array hides elements.
bool is_masked(py::handle array) {
  return py::module_::import("numpy").attr("ma").attr("is_masked")(array).cast<bool>();
}

/// Returns whether an array of objects contains text, which NumPy would read as numbers.
bool has_text(const py::array& objects) {
  for (const py::handle element : objects.attr("flat")) {
    if (PyUnicode_Check(element.ptr()) || PyBytes_Check(element.ptr())) return true;
  }
  return false;
}

}  // namespace

void refuse_masked(py::handle source) {
  const auto refuse = [](py::handle array) {
    const bool is_plain = Py_TYPE(array.ptr()) == py::detail::npy_api::get().PyArray_Type_;
    if (!is_plain && py::isinstance<py::array>(array) && is_masked(array))
      throw py::value_error("a masked array must not hide elements");
  };
  refuse(source);
  if (!PyList_Check(source.ptr()) && !PyTuple_Check(source.ptr())) return;
  for (const py::handle element : py::reinterpret_borrow<py::sequence>(source)) {
    if (!PyTuple_CheckExact(element.ptr()) && !PyList_CheckExact(element.ptr())) refuse(element);
  }
}

bool read_point(py::handle object, Point& point) {
  double numbers[2];
  if (read_numbers(object.ptr(), 2, numbers)) {
    point = {numbers[0], numbers[1]};
    return true;
  }
  if (!py::hasattr(object, "__geo_interface__")) return false;
  const py::object geometry = object.attr("__geo_interface__");
  if (!py::isinstance<py::dict>(geometry) || !geometry.contains("coordinates") || !geometry.contains("type")) {
    return false;
  }
  return py::object(geometry["type"]).equal(py::str("Point")) &&
         read_numbers(py::object(geometry["coordinates"]).ptr(), 2, numbers) &&
         (point = {numbers[0], numbers[1]}, true);
}

bool read_box(py::handle object, Box& box) {
  double numbers[4];
  if (read_numbers(object.ptr(), 4, numbers)) {
    box = {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
    return true;
  }
  if (PySequence_Check(object.ptr()) == 0 || PyUnicode_Check(object.ptr())) return false;
  if (PySequence_Size(object.ptr()) != 2) {
    clear_error();
    return false;
  }
  const py::list ends(py::reinterpret_borrow<py::object>(object));
  return ends.size() == 2 && read_point(ends[0], box.min) && read_point(ends[1], box.max);
}

bool read_id(py::handle object, ItemId& id) {
  if (object.is_none()) {
    id = {};
    return true;
  }
  const py::object number = py::reinterpret_steal<py::object>(PyNumber_Index(object.ptr()));
  if (!number) {
    PyErr_Clear();
    return false;
  }
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  // The library refuses each id above its largest one, so also this one for numbers that are too large or too small.
  id = overflow != 0 ? ItemId(-1) : ItemId(value);
  return true;
}

Shape read_shape(py::handle object) {
  if (py::isinstance<Shape>(object)) return object.cast<const Shape&>();
  return py::module_::import("waywright._geo").attr("shape_of")(object).cast<Shape>();
}

py::object refuse_pickle(const py::object& self, int /*protocol*/) {
  const auto name = py::type::handle_of(self).attr("__name__").cast<std::string>();
  throw py::type_error("an object of the class " + name + " cannot be pickled");
}

py::handle new_pair(double x, double y) {
  PyObject* const pair = PyTuple_New(2);
  PyObject* const first = PyFloat_FromDouble(x);
  PyObject* const second = PyFloat_FromDouble(y);
  if (pair == nullptr || first == nullptr || second == nullptr) throw py::error_already_set();
  PyTuple_SET_ITEM(pair, 0, first);
  PyTuple_SET_ITEM(pair, 1, second);
  return pair;
}

DoubleArray doubles_of(py::handle source, const char* what) {
  constexpr std::string_view kNumbers = "biufO";  // NumPy would also read text, dates and complex numbers as doubles
  refuse_masked(source);
  try {
    const auto array = py::array(py::reinterpret_borrow<py::object>(source));
    const char kind = array.dtype().kind();
    if (kNumbers.find(kind) == std::string_view::npos || (kind == 'O' && has_text(array))) throw py::type_error(what);
    return DoubleArray(array);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError)) throw;
    py::raise_from(error, PyExc_TypeError, what);
    throw py::error_already_set();
  }
}

std::string file_name_of(py::handle source) {
  auto name = py::module_::import("os").attr("fsencode")(source).cast<std::string>();
  if (name.find('\0') != std::string::npos) throw py::value_error("the name of a file must not contain a zero byte");
  return name;
}

void AgentsArg::check_count(std::size_t count) const {
  if (!is_one && agents.size() != count) throw py::value_error("agent must be one agent, or one for each query");
}

void read_agents(py::handle object, AgentsArg& agents) {
  agents.is_one = py::isinstance<Agent>(object);
  if (agents.is_one) {
    agents.agents = {object.cast<const Agent&>()};
    return;
  }
  constexpr const char* kWhat = "agent must be an Agent, or a list with one for each query";
  if (PySequence_Check(object.ptr()) == 0) throw py::type_error(kWhat);
  const py::list list(py::reinterpret_borrow<py::object>(object));
  agents.agents.reserve(list.size());
  for (const py::handle each : list) {
    if (!py::isinstance<Agent>(each)) throw py::type_error(kWhat);
    agents.agents.push_back(each.cast<const Agent&>());
  }
}

std::span<const Point> PointsArg::span() const { return {reinterpret_cast<const Point*>(array.data()), size()}; }

py::array view_points(std::span<const Point> points, py::handle owner) {
  const auto count = static_cast<py::ssize_t>(points.size());
  if (points.empty()) return py::array_t<double>(std::vector<py::ssize_t>{0, 2});
  return view_numbers(&points.data()->x, {count, 2}, {sizeof(Point), sizeof(double)}, owner);
}

py::array own_points(std::vector<Point> points) {
  auto* const kept = new std::vector<Point>(std::move(points));
  const py::capsule owner(kept, [](void* pointer) { delete static_cast<std::vector<Point>*>(pointer); });
  const auto count = static_cast<py::ssize_t>(kept->size());
  return py::array_t<double>(std::vector<py::ssize_t>{count, 2}, reinterpret_cast<const double*>(kept->data()), owner);
}

py::array own_ids(std::vector<ItemId> ids) {
  auto* const kept = new std::vector<ItemId>(std::move(ids));
  const py::capsule owner(kept, [](void* pointer) { delete static_cast<std::vector<ItemId>*>(pointer); });
  const auto count = static_cast<py::ssize_t>(kept->size());
  return py::array_t<std::uint64_t>(count, reinterpret_cast<const std::uint64_t*>(kept->data()), owner);
}

void refuse_name(std::string_view name, const std::vector<std::string_view>& names) {
  std::string text = "'" + std::string(name) + "' is none of ";
  for (const std::string_view each : names) {
    text += (each == names.front() ? "'" : ", '") + std::string(each) + "'";
  }
  throw py::value_error(text);
}

}  // namespace waywright::python
