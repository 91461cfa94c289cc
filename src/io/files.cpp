#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "waywright/error.hpp"
#include "waywright/save.hpp"
#include "waywright/scene.hpp"
#include "waywright/script.hpp"

#include "base/number_text.hpp"
#include "base/system.hpp"
#include "io/triangle.hpp"
#include "text/file_types.hpp"
#include "text/text.hpp"

// Files by name: scenes of every format, and saved worlds.

namespace waywright {

namespace {

namespace fs = std::filesystem;

struct FileCloser {
  void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};
using InputFile = std::unique_ptr<std::FILE, FileCloser>;

/// Opens a file to read its bytes. Returns null if this is not possible; errno then says why.
InputFile open_input_file(const std::string& file_name) { return InputFile(std::fopen(file_name.c_str(), "rb")); }

/// The error for a file that the system does not read. `fault` is the system's reason, as errno gives it.
Error unreadable(const std::string& file_name, int fault) {
  return {ErrorCode::unreadable, file_name + ": cannot be read: " + std::generic_category().message(fault), {}, 0};
}

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

/// A file that gets its new contents in one step, or not at all: the caller writes the contents to a temporary file in
/// the same folder, and commit() renames this file. The destructor removes the temporary file unless commit() has
/// succeeded.
class FileReplacement {
 public:
  /// Opens the temporary file. If this is not possible, stream() is null, and error() says why.
  explicit FileReplacement(const std::string& file_name);
  ~FileReplacement();
  FileReplacement(const FileReplacement&) = delete;
  FileReplacement& operator=(const FileReplacement&) = delete;

  /// The temporary file, or null.
  [[nodiscard]] std::FILE* stream() const { return file_; }
  /// Waits until the temporary file is on the disk, and gives it the name of the file. Returns whether this has
  /// succeeded. If not, the file has not changed.
  [[nodiscard]] bool commit();
  /// Records the system's reason for a failure to write to stream(), as errno gives it; 0 if it is not known.
  void note_fault(int fault) { static_cast<void>(keep(fault)); }
  /// The error for the last failure.
  [[nodiscard]] Error error() const;

 private:
  [[nodiscard]] bool follow_links();
  [[nodiscard]] bool close();
  [[nodiscard]] bool keep(int fault);

  std::string name_;  ///< as the caller gave it
  std::filesystem::path target_;
  std::string temporary_;  ///< the name of the temporary file; empty if there is none
  std::FILE* file_ = nullptr;
  int fault_ = 0;
  /// Whether the name belongs to neither a regular file nor a folder, for example to a device.
  bool is_special_ = false;
};

FileReplacement::FileReplacement(const std::string& file_name) : name_(file_name), target_(file_name) {
  if (!follow_links()) return;
  std::error_code ignored;
  const fs::file_status old = fs::status(target_, ignored);
  if (fs::is_directory(old)) {
    static_cast<void>(keep(EISDIR));
    return;
  }
  if (fs::exists(old) && !fs::is_regular_file(old)) {
    is_special_ = true;
    return;
  }
  constexpr std::size_t kLongestStem = 200;  // file systems allow names of 255 bytes
  const std::string stem = target_.filename().string().substr(0, kLongestStem);
  for (std::uint64_t attempt = 0; file_ == nullptr; ++attempt) {
    temporary_ = (target_.parent_path() / base::with_number(stem + ".tmp", attempt, "")).string();
    errno = 0;
    file_ = std::fopen(temporary_.c_str(), "wbx");
    if (file_ != nullptr || errno == EEXIST) continue;
    static_cast<void>(keep(errno));
    temporary_.clear();
    return;
  }
}

/// If the target is a symbolic link, replaces it by the file to which it leads. This file need not exist. Returns
/// whether the links come to an end.
bool FileReplacement::follow_links() {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::error_code fault;
  for (int i = 0; fs::is_symlink(fs::symlink_status(target_, fault)); ++i) {
    if (i == kMostLinks) return keep(ELOOP);
    const fs::path next = fs::read_symlink(target_, fault);
    if (fault) return keep(fault.value());
    target_ = target_.parent_path() / next;  // if `next` is absolute, it replaces the whole name
  }
  return true;
}

FileReplacement::~FileReplacement() {
  static_cast<void>(close());
  if (!temporary_.empty()) std::remove(temporary_.c_str());  // allocates nothing
}

bool FileReplacement::commit() {
  errno = 0;
  if (std::fflush(file_) != 0 || !base::bring_to_disk(file_)) return keep(errno);
  if (!close()) return keep(errno);
  const std::string folder = target_.has_parent_path() ? target_.parent_path().string() : ".";
  std::error_code fault;
  const fs::file_status old = fs::status(target_, fault);
  if (fs::exists(old)) {
    fs::permissions(temporary_, old.permissions() & fs::perms::all, fault);
    if (fault) return keep(fault.value());
  }
  fs::rename(temporary_, target_, fault);
  if (fault) return keep(fault.value());
  temporary_.clear();
  base::bring_folder_to_disk(folder.c_str());
  return true;
}

Error FileReplacement::error() const {
  std::string message = name_ + ": cannot be written";
  if (is_special_) message += ": it is a device or a pipe, and no regular file";
  if (fault_ != 0) message += ": " + std::generic_category().message(fault_);
  return {ErrorCode::unwritable, std::move(message), {}, 0};
}

bool FileReplacement::close() {
  std::FILE* const file = std::exchange(file_, nullptr);
  return file == nullptr || std::fclose(file) == 0;
}

/// Keeps the reason for error(). Returns false.
bool FileReplacement::keep(int fault) {
  fault_ = fault;
  return false;
}

Result<std::string> read_file(const std::string& file_name) {
  const InputFile file = open_input_file(file_name);
  if (!file) return unreadable(file_name, errno);
  std::string text;
  std::array<char, std::size_t{1} << 16> chunk{};
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    text.append(chunk.data(), count);
  }
  if (std::ferror(file.get()) != 0) return unreadable(file_name, errno);
  return text;
}

Result<Scene> read_script(std::string_view text, const std::string& file_name) {
  const Result<Script> script = parse_script(text, file_name);
  if (!script.ok()) return script.error();
  return scene_of(*script);
}

/// Returns the format of scenes that the library reads from a file of this type, or null.
std::optional<SceneFormat> format_of(std::optional<text::FileType> type) {
  if (!type) return std::nullopt;
  switch (*type) {
    case text::FileType::script:
      return SceneFormat::script;
    case text::FileType::saved_world:
      return SceneFormat::saved_world;
    case text::FileType::movingai_map:
      return SceneFormat::movingai;
    case text::FileType::triangle_poly:
      return SceneFormat::triangle_poly;
    case text::FileType::triangle_node:
      return SceneFormat::triangle_node;
    default:
      return std::nullopt;
  }
}

Result<Scene> read_poly(std::string_view text, const std::string& file_name) {
  if (!io::lacks_vertices(text)) return parse_triangle_poly(text, file_name);
  const std::string node_name = file_name.substr(0, file_name.rfind('.')) + ".node";
  const Result<std::string> node_text = read_file(node_name);
  if (!node_text.ok()) {
    Error error = node_text.error();
    error.words = error.message() + "; it should hold the vertices, of which " + file_name + " counts none";
    return error;
  }
  return parse_triangle_poly(text, file_name, *node_text, node_name);
}

}  // namespace

Result<SceneFormat> scene_format(std::string_view file_name) {
  if (const std::optional<SceneFormat> format = format_of(text::type_of_name(file_name))) return *format;
  std::string message(file_name);
  message += ": expected a file name that ends in .wws, .wwb, .map, .poly or .node";
  return Error{.code = ErrorCode::not_supported, .words = std::move(message), .item = {}};
}

bool is_saved_world(std::string_view bytes) { return text::type_of_bytes(bytes) == text::FileType::saved_world; }

Result<Scene> parse_saved_world(std::string_view bytes, std::string_view name) {
  std::istringstream stream{std::string(bytes)};
  const auto refuse = [&](Error error) {
    error.words = std::string(name) + ": " + error.message();
    return error;
  };
  const Result<World> world = load_world(stream);
  if (!world.ok()) return refuse(world.error());
  if (stream.peek() != std::istringstream::traits_type::eof()) {
    return refuse({ErrorCode::malformed, "there are more bytes after the saved world", {}, 0});
  }
  return Scene{.domain = world->domain(), .items = world->items(), .y_down = false};
}

Result<Scene> read_scene(const std::string& file_name) {
  const Result<SceneFormat> format = scene_format(file_name);
  const Result<std::string> text = read_file(file_name);
  if (text.ok() && is_saved_world(*text)) return parse_saved_world(*text, file_name);
  if (!format.ok()) return format.error();
  if (!text.ok()) return text.error();
  switch (*format) {
    case SceneFormat::script:
      return read_script(*text, file_name);
    case SceneFormat::movingai:
      return parse_movingai_map(*text, file_name);
    case SceneFormat::triangle_poly:
      return read_poly(*text, file_name);
    case SceneFormat::saved_world:
      return parse_saved_world(*text, file_name);
    case SceneFormat::triangle_node:
      break;
  }
  return parse_triangle_node(*text, file_name);
}

Result<void> save_world_file(const World& world, const std::string& file_name) {
  FileReplacement file(file_name);
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
  const InputFile file = open_input_file(file_name);
  if (!file) return unreadable(file_name, errno);
  FileBuffer buffer(file.get());
  std::istream stream(&buffer);
  errno = 0;
  Result<World> world = load_world(stream, options);
  const int fault = errno;
  if (std::ferror(file.get()) != 0) return unreadable(file_name, fault);
  if (!world.ok()) return in_file(file_name, world.error());
  if (std::fgetc(file.get()) != EOF) {
    return in_file(file_name, {ErrorCode::malformed, "there are more bytes after the saved world", {}, 0});
  }
  return world;
}

}  // namespace waywright
