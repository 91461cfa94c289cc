#include "exact/gap.hpp"
