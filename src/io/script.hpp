#pragma once

#include <string>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright::io {

/// Appends the first lines of a world script: its header and its domain.
void append_header(std::string& out, const Box& domain);

/// Appends the line that inserts an item: `point 3 1 2`.
void append_item(std::string& out, ItemId id, const Shape& shape);

}  // namespace waywright::io
