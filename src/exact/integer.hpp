#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace waywright::exact {

/// Arbitrary precision; no expression templates, so that `auto` and ternaries mean what they say.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

}  // namespace waywright::exact
