#pragma once

#include <stdexcept>
#include <string>

namespace waywright::command {

/// An error that ends the command with status 2. Its message is one line for standard error.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& line) : std::runtime_error(line) {}
};

}  // namespace waywright::command
