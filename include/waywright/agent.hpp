#pragma once

namespace waywright {

/// @addtogroup world
/// @{

/// What moves: a point, or a disc. The world does not store agents: each query says for which agent it asks.
///
/// @code{.cpp}
/// const Agent archer{.radius = 5};
/// World yard = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
/// yard.insert_segment({50, 0}, {50, 60}, 1).value();
/// const Path around = yard.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = archer}).value();
/// const bool has_room = yard.fit_disc({40, 50}, archer).value().fits;  // == true
/// const bool is_same_agent = around.agent == archer;                   // == true
/// @endcode
struct Agent {
  double radius = 0.0;  ///< of the disc, 0 or more and finite; with the radius 0 the agent is a point

  friend bool operator==(const Agent&, const Agent&) = default;
};

/// @}

}  // namespace waywright
