#include <optional>

#include "bind.hpp"
#include "structs.hpp"

// Queries about one point, segment, box or disc. The short ones keep the GIL: to release it takes longer than to
// answer, and another busy thread would then keep it for milliseconds.

namespace waywright::python {

namespace {

template <class Class>
void bind_locating(Class& world) {
  using Handle = typename Class::type;
  world
      .def(
          "locate",
          [](const Handle& self, Point point) {
            Location location;
            const ContextPool::Loan context(self.contexts());
            self.read([&](const World& w) { w.locate(point, *context, location).value(); });
            return location;
          },
          py::arg("point"), R"(Finds the vertex, edge or face at a point, and the polygons there.

>>> world.locate((50, 45))
<waywright.Location face, polygons [1]>
)")
      .def(
          "items_at",
          [](const Handle& self, Point point) {
            std::vector<ItemId> items;
            const ContextPool::Loan context(self.contexts());
            self.read([&](const World& w) { w.items_at(point, *context, items).value(); });
            return items;
          },
          py::arg("point"), "Returns the ids of the items that contain a point, ascending.")
      .def(
          "items_in",
          [](const Handle& self, const Box& box) {
            const ContextPool::Loan context(self.contexts());
            return own_ids(self.read_long([&](const World& w) {
              std::vector<ItemId> items;
              w.items_in(box, *context, items).value();
              return items;
            }));
          },
          py::arg("box"),
          "Returns an array of the ids of the items that have a position in common with a box, ascending.");
}

template <class Class>
void bind_segments(Class& world) {
  using Handle = typename Class::type;
  world
      .def(
          "items_crossed",
          [](const Handle& self, Point start, Point end) {
            std::vector<CrossedItem> items;
            const ContextPool::Loan context(self.contexts());
            self.read([&](const World& w) { w.items_crossed(start, end, *context, items).value(); });
            py::list list;
            for (const CrossedItem& item : items) list.append(py::make_tuple(item.id, item.at));
            return list;
          },
          py::arg("start"), py::arg("end"),
          R"(Returns the items whose sides a segment meets, as pairs (id, position), from its start to its end.

>>> world.items_crossed((50, 50), (50, 90))
[(1, (50.0, 60.0)), (2, (50.0, 80.0))]
)")
      .def(
          "ray",
          [](const Handle& self, Point start, Point end, const Agent& agent) {
            RayHit hit;
            const ContextPool::Loan context(self.contexts());
            self.read([&](const World& w) { w.ray(start, end, agent, *context, hit).value(); });
            return hit;
          },
          py::arg("start"), py::arg("end"), py::arg("agent") = Agent{},
          R"(Finds the first wall that an agent touches while it moves along a segment.

>>> world.ray((10, 50), (90, 50))
<waywright.RayHit at (40, 50), items [1]>
>>> world.ray((10, 50), (90, 50), waywright.Agent(radius=5)).at
(35.0, 50.0)
)");
}

template <class Class>
void bind_discs(Class& world) {
  using Handle = typename Class::type;
  world
      .def(
          "fit_disc",
          [](const Handle& self, Point centre, const Agent& agent) {
            DiscFit fit;
            const ContextPool::Loan context(self.contexts());
            self.read([&](const World& w) { w.fit_disc(centre, agent, *context, fit).value(); });
            return fit;
          },
          py::arg("centre"), py::arg("agent"), R"(Finds out whether a disc fits at a position.

>>> world.fit_disc((30, 50), waywright.Agent(radius=12))
<waywright.DiscFit stopped by [1]>
)")
      .def(
          "nearest_fit",
          [](const Handle& self, Point point, WAYWRIGHT_NEAREST_FIT_QUERY_PARAMETERS) {
            NearestFit fit;
            const ContextPool::Loan context(self.contexts());
            const NearestFitQuery query = to_nearest_fit_query(point, WAYWRIGHT_NEAREST_FIT_QUERY_NAMES);
            self.read_long([&](const World& w) { w.nearest_fit(query, *context, fit).value(); });
            return fit;
          },
          py::arg("point"), WAYWRIGHT_NEAREST_FIT_QUERY_ARGUMENTS,
          R"(Finds the nearest point to ``point``, among all points where a disc fits.

With ``goal``, finds the nearest point from which the disc can move to the goal.

>>> world.nearest_fit((45, 50), waywright.Agent(radius=5))
<waywright.NearestFit at (35, 50), 10.0 away>
)")
      .def(
          "widest_path",
          [](const Handle& self, Point start, Point goal, const Agent& agent) {
            WidestPath widest;
            const ContextPool::Loan context(self.contexts());
            self.read_long([&](const World& w) { w.widest_path(start, goal, agent, *context, widest).value(); });
            return widest;
          },
          py::arg("start"), py::arg("goal"), py::arg("agent") = Agent{},
          R"(Finds the largest disc that can move from a start to a goal. The radius of ``agent`` does not matter.

>>> world.widest_path((10, 70), (90, 70)).radius
20.0
)")
      .def(
          "bridges",
          [](const Handle& self, const std::optional<Box>& box) {
            auto list = std::make_unique<BridgeList>();
            const ContextPool::Loan context(self.contexts());
            self.read_long([&](const World& w) { w.bridges(box.value_or(w.domain()), *context, *list).value(); });
            return list;
          },
          py::arg("box") = py::none(), R"(Lists the bridges of the world, or those that meet a box.

>>> world.bridges((20, 30, 30, 50)).radii.tolist()
[20.0]
)");
}

}  // namespace

template <class Class>
void bind_world_queries(Class& world) {
  using Handle = typename Class::type;
  bind_locating(world);
  bind_segments(world);
  bind_discs(world);
  world.def(
      "is_clear",
      [](const Handle& self, const PointsArg& points, const Agent& agent) {
        const ContextPool::Loan context(self.contexts());
        return self.read_long([&](const World& w) { return w.is_clear(points.span(), agent, *context).value(); });
      },
      py::arg("points"), py::arg("agent") = Agent{},
      R"(Returns whether an agent can walk along the straight segments between points. Discs are not supported yet.

>>> world.is_clear([(10, 50), (40, 40), (90, 30)]), world.is_clear([(10, 50), (90, 50)])
(True, False)
)");
}

template void bind_world_queries(WorldClass& world);
template void bind_world_queries(SnapshotClass& snapshot);

}  // namespace waywright::python
