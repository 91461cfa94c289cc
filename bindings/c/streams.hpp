#pragma once

#include <cstddef>
#include <limits>
#include <streambuf>

#include "internal.hpp"

/// C++ streams that read and write through functions of the caller. They have no buffer.
namespace waywright::c {

/// Makes an output stream of a ww_output.
class OutputBuffer final : public std::streambuf {
 public:
  explicit OutputBuffer(const ww_output* output) : output_(read_struct(output, {})) {
    require(output_.write != nullptr, "an output needs the function write");
  }

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    if (count <= 0) return 0;
    return is_set(output_.write(bytes, static_cast<std::size_t>(count), output_.user_data)) ? count : 0;
  }
  int_type overflow(int_type byte) override {
    if (traits_type::eq_int_type(byte, traits_type::eof())) return traits_type::not_eof(byte);
    const char written = traits_type::to_char_type(byte);
    return xsputn(&written, 1) == 1 ? byte : traits_type::eof();
  }
  int sync() override { return output_.flush == nullptr || is_set(output_.flush(output_.user_data)) ? 0 : -1; }

 private:
  ww_output output_;
};

/// Makes an input stream of a ww_input. Serves only reads of several bytes (std::istream::read).
class InputBuffer final : public std::streambuf {
 public:
  explicit InputBuffer(const ww_input* input) : input_(read_struct(input, {})) {
    require(input_.read != nullptr, "an input needs the function read");
  }

 protected:
  std::streamsize xsgetn(char* bytes, std::streamsize count) override {
    const auto wanted = static_cast<std::size_t>(count);
    std::size_t done = 0;
    while (done < wanted) {
      const std::size_t read = input_.read(bytes + done, wanted - done, input_.user_data);
      // The stream catches the exception, and counts as broken from then on.
      if (read > wanted - done) throw Refusal{WW_UNREADABLE, "an input cannot be read"};
      if (read == 0) break;
      done += read;
    }
    return static_cast<std::streamsize>(done);
  }

 private:
  ww_input input_;
};

/// Makes an input stream of bytes in memory.
class BytesBuffer final : public std::streambuf {
 public:
  BytesBuffer(const void* bytes, std::size_t size) {
    // A stream for reading never writes to its bytes.
    char* const begin = const_cast<char*>(static_cast<const char*>(bytes));
    setg(begin, begin, begin + size);
  }
  /// The number of bytes that have been read.
  [[nodiscard]] std::size_t position() const { return static_cast<std::size_t>(gptr() - eback()); }
  [[nodiscard]] bool is_at_end() const { return gptr() == egptr(); }
};

}  // namespace waywright::c
