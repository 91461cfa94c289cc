#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace waywright::exact {

/// An integer of arbitrary precision. It uses no expression templates, so `auto` and the operator ?: have the type
/// Integer.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

}  // namespace waywright::exact
