#include "formats/polygon_rings.hpp"

#include "formats/reader.hpp"

namespace waywright::formats {

void open_ring(std::vector<Point>& ring, const std::string& name, std::size_t offset) {
  if (ring.size() < 4) {
    refuse(offset, "at least 4 positions in " + name + ", the last like the first", std::to_string(ring.size()));
  }
  if (ring.front() != ring.back()) {
    refuse(offset, name + " to end where it starts, at " + to_string(ring.front()),
           to_string(ring.back()) + "; repeat its first position at its end");
  }
  ring.pop_back();
}

void check_line(const std::vector<Point>& line, const std::string& name, std::size_t offset) {
  if (line.size() < 2) refuse(offset, "at least 2 positions in " + name, std::to_string(line.size()));
}

}  // namespace waywright::formats
