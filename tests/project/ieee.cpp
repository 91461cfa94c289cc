#include "base/ieee.hpp"
