#pragma once

#include <iosfwd>
#include <string>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/world.hpp"

namespace waywright {

/// @addtogroup scenes
/// @{

/// @name Saving and loading worlds
/// You need this group to keep a world in a file: a saved game, or a level that loads quickly. docs/formats.md
/// describes every byte of the format. Every later version of the library reads the files of this version.
///
/// @code{.cpp}
/// save_world_file(world, "level.wwb").value();
/// const World loaded = load_world_file("level.wwb").value();
/// const bool is_same = loaded.items_hash() == world.items_hash();  // == true
/// @endcode
///
/// A saved world contains four things: the domain; the options, except WorldOptions::new_vertex_limit; the items; and
/// the largest id that the world has seen, from which the world makes the next id. The bytes depend only on these four
/// things, and are the same on every machine. A saved world contains no history, and no contexts, searches or spare
/// memory. It does not contain World::version(), either: a loaded world counts its operations from the start.
/// @{

/// Writes a world to a stream, and flushes the stream. Open the stream in binary mode. After an error, the stream may
/// contain a piece of the world. save_world_file() never leaves a piece in its file.
///
/// @code{.cpp}
/// std::stringstream stream;
/// save_world(world, stream).value();
/// const std::size_t item_count = load_world(stream).value().item_count();  // == 2
/// @endcode
/// If the items have more than 2^27 - 4 points in all (this is possible if they share corners), load_world() refuses
/// the saved world.
/// Errors: unwritable, if the stream accepts no more bytes.
/// Cost: O(n log n) for n items, and linear in their points. Each point takes 16 bytes. Items of one kind whose ids
/// count up take almost no further bytes if they are points or segments. Every other item takes up to 11 further bytes.
/// A polyline and each ring of a polygon take 1 to 5 more.
[[nodiscard]] WAYWRIGHT_API Result<void> save_world(const World& world, std::ostream& out);

/// Reads a world from a stream, and leaves the stream after the last byte of the world. Open the stream in binary mode.
/// Any byte of the stream may be wrong: the function checks the form, the checksum, and the hash of the items. It
/// allocates memory only for the bytes that the stream really has. Error::index is the number of bytes that the
/// function had read when it found the fault, and the bytes of the wrong value count, too. It is 0 if a world refuses
/// the domain or an item. BulkOptions::progress reports only the construction of the mesh, which begins after the
/// function has read all bytes.
/// Errors: unreadable, if the stream fails; malformed, if the bytes are not a complete, unaltered saved world, or
/// if the items have more than 2^27 - 4 points in all; not_supported, if the bytes have another version of the format.
/// Cost: the cost of World::insert_all().
[[nodiscard]] WAYWRIGHT_API Result<World> load_world(std::istream& in, const BulkOptions& options = {});

/// Writes a world to a file. The function first writes a temporary file in the same folder, waits until this file is on
/// the disk, and then gives it the name of the file. So even if the computer stops, the file is completely the old one
/// or completely the new one. On an error, the function removes the temporary file, and the old file stays as it is.
/// The new file has the permissions of the old one. If `file_name` is a symbolic link, the function replaces or makes
/// the file to which it leads. Error messages start with the file name.
/// Errors: unwritable, for example if there is a folder, a device or a pipe with this name.
/// Cost: the cost of save_world().
[[nodiscard]] WAYWRIGHT_API Result<void> save_world_file(const World& world, const std::string& file_name);

/// Reads a world from a file, which must contain nothing else. Error messages start with the file name.
/// Errors: unreadable, malformed, not_supported.
/// Cost: the cost of load_world().
[[nodiscard]] WAYWRIGHT_API Result<World> load_world_file(const std::string& file_name,
                                                          const BulkOptions& options = {});

/// @}

/// @}

}  // namespace waywright
