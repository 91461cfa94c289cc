// Boost leaves it to its user to say what happens in place of a throw when exceptions are off. Alone in its file, so
// that a program that says so itself, too, links without a clash.
#include <boost/config.hpp>

#ifdef BOOST_NO_EXCEPTIONS

#include <cstdlib>

#include <boost/throw_exception.hpp>

namespace boost {

void throw_exception(const std::exception& /*error*/) { std::abort(); }
void throw_exception(const std::exception& /*error*/, const source_location& /*where*/) { std::abort(); }

}  // namespace boost

#endif
