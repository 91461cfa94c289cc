// CMake compiles precompiled.hpp for the target to which this file belongs.
