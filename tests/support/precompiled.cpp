// CMake compiles precompiled.hpp for the target that this file makes.
