// If exceptions are off, Boost expects its user to define the function that it calls instead of a throw. The definition
// is alone in this file, so a program that contains its own definition links without a conflict.
#include <boost/config.hpp>

#ifdef BOOST_NO_EXCEPTIONS

#include <cstdlib>

#include <boost/throw_exception.hpp>

namespace boost {

void throw_exception(const std::exception& /*error*/) { std::abort(); }
void throw_exception(const std::exception& /*error*/, const source_location& /*where*/) { std::abort(); }

}  // namespace boost

#endif
