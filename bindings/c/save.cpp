#include <istream>
#include <ostream>
#include <streambuf>
#include <string>
#include <utility>

#include "internal.hpp"
#include "streams.hpp"

namespace waywright::c {

namespace {

/// Collects bytes in a string.
class StringBuffer final : public std::streambuf {
 public:
  explicit StringBuffer(std::string& bytes) : bytes_(bytes) {}
  /// Throws the exception of the first write for which there was not enough memory: the stream has caught it.
  void require_memory() const {
    if (is_out_of_memory_) throw std::bad_alloc();
  }

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    is_out_of_memory_ = true;  // if the next line throws
    bytes_.append(bytes, static_cast<std::size_t>(count));
    is_out_of_memory_ = false;
    return count;
  }

 private:
  std::string& bytes_;
  bool is_out_of_memory_ = false;
};

ww_status keep_world(Result<World> loaded, ww_world** world) {
  return loaded.ok() ? make_object(world, std::move(*loaded)) : fail(loaded.error());
}

}  // namespace

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_world_save(const ww_world* world, const ww_output* output) {
  return guarded([&] {
    OutputBuffer buffer(output);
    std::ostream stream(&buffer);
    const World& saved = object(world);
    const RunningCall running(saved, RunningCall::Use::reads);
    return status_of(save_world(saved, stream));
  });
}

ww_status ww_world_save_file(const ww_world* world, const char* file_name) {
  return guarded([&] { return status_of(save_world_file(object(world), std::string(to_view(file_name)))); });
}

ww_status ww_world_save_bytes(const ww_world* world, ww_text* bytes) {
  return guarded([&] {
    std::string& out = object(bytes);
    out.clear();
    StringBuffer buffer(out);
    std::ostream stream(&buffer);
    const Result<void> saved = save_world(object(world), stream);
    buffer.require_memory();
    return status_of(saved);
  });
}

ww_status ww_world_load(const ww_input* input, const ww_bulk_options* options, ww_world** world) {
  return guarded([&] {
    answer(world);
    const Bulk bulk(options);
    InputBuffer buffer(input);
    std::istream stream(&buffer);
    return keep_world(load_world(stream, bulk.options), world);
  });
}

ww_status ww_world_load_file(const char* file_name, const ww_bulk_options* options, ww_world** world) {
  return guarded([&] {
    answer(world);
    const Bulk bulk(options);
    return keep_world(load_world_file(std::string(to_view(file_name)), bulk.options), world);
  });
}

ww_status ww_world_load_bytes(const void* bytes, size_t size, const ww_bulk_options* options, ww_world** world) {
  return guarded([&] {
    answer(world);
    require(bytes != nullptr || size == 0, "an array is null, and its size is not 0");
    const Bulk bulk(options);
    BytesBuffer buffer(bytes, size);
    std::istream stream(&buffer);
    Result<World> loaded = load_world(stream, bulk.options);
    if (loaded.ok() && !buffer.is_at_end()) {
      return fail({ErrorCode::malformed, "there are more bytes after the saved world", {}, buffer.position()});
    }
    return keep_world(std::move(loaded), world);
  });
}

ww_status ww_is_saved_world(const void* bytes, size_t size, ww_bool* is_saved_world) {
  return guarded([&] {
    answer(is_saved_world) = to_c(waywright::is_saved_world(to_view(static_cast<const char*>(bytes), size)));
    return WW_OK;
  });
}
