#include "thesis/triangulated_over.hpp"
