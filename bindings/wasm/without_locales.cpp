// The library writes and reads saved worlds through streams, as bytes. A stream contains a locale, and a locale refers
// to all the code for dates, money and wide characters: 30 kB of the compressed module. Bytes need no locale. So the
// linker replaces the functions of std::locale that streams call by the functions below (--wrap). A stream that would
// write a number or pad a text needs a facet, and throws std::bad_cast: the library writes such texts itself.
//
// The names are those of libc++. In WebAssembly, constructors and destructors return their object.

#include <typeinfo>

// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {

void* __wrap__ZNSt3__26localeC1Ev(void* self) {
  *static_cast<void**>(self) = nullptr;
  return self;
}
void* __wrap__ZNSt3__26localeC1ERKS0_(void* self, const void* /*other*/) {
  *static_cast<void**>(self) = nullptr;
  return self;
}
void* __wrap__ZNSt3__26localeaSERKS0_(void* self, const void* /*other*/) { return self; }
void* __wrap__ZNSt3__26localeD1Ev(void* self) { return self; }
const void* __wrap__ZNKSt3__26locale9use_facetERNS0_2idE(const void* /*self*/, void* /*id*/) { throw std::bad_cast(); }
}
// NOLINTEND(bugprone-reserved-identifier)
