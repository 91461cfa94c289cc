#include <cerrno>
#include <cstdio>
#include <istream>
#include <ostream>
#include <streambuf>
#include <string>

#include "waywright/save.hpp"

#include "io/input_file.hpp"
#include "io/replace_file.hpp"

namespace waywright {
namespace {

/// Makes a stream of a file. std::fstream does not report the system's reason for a failure.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(std::FILE* file) : file_(file) {}

 protected:
  std::streamsize xsgetn(char* bytes, std::streamsize count) override {
    return static_cast<std::streamsize>(std::fread(bytes, 1, static_cast<std::size_t>(count), file_));
  }
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    return static_cast<std::streamsize>(std::fwrite(bytes, 1, static_cast<std::size_t>(count), file_));
  }
  int sync() override { return std::fflush(file_) == 0 ? 0 : -1; }

 private:
  std::FILE* file_;
};

Error in_file(const std::string& file_name, Error error) {
  error.words = file_name + ": " + error.message();
  return error;
}

}  // namespace

Result<void> save_world_file(const World& world, const std::string& file_name) {
  io::FileReplacement file(file_name);
  if (file.stream() == nullptr) return file.error();
  FileBuffer buffer(file.stream());
  std::ostream stream(&buffer);
  errno = 0;
  if (!save_world(world, stream).ok()) {
    file.note_fault(errno);
    return file.error();
  }
  if (!file.commit()) return file.error();
  return {};
}

Result<World> load_world_file(const std::string& file_name, const BulkOptions& options) {
  const io::InputFile file = io::open_input_file(file_name);
  if (!file) return io::unreadable(file_name, errno);
  FileBuffer buffer(file.get());
  std::istream stream(&buffer);
  errno = 0;
  Result<World> world = load_world(stream, options);
  const int fault = errno;
  if (std::ferror(file.get()) != 0) return io::unreadable(file_name, fault);
  if (!world.ok()) return in_file(file_name, world.error());
  if (std::fgetc(file.get()) != EOF) {
    return in_file(file_name, {ErrorCode::malformed, "there are more bytes after the saved world", {}, 0});
  }
  return world;
}

}  // namespace waywright
