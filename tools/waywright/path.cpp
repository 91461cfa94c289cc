#include "waywright/path.hpp"

#include <fmt/format.h>

#include "waywright/scene.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "commands.hpp"
#include "failure.hpp"
#include "file_names.hpp"
#include "formats/write_geojson.hpp"
#include "input.hpp"
#include "json_lines.hpp"
#include "output.hpp"
#include "picture.hpp"

namespace waywright::command {

ExitStatus path(const PathOptions& options) {
  PathQuery query;
  query.start = parse_point("--from", options.from);
  query.goal = parse_point("--to", options.to);
  query.agent.radius = parse_radius(options.radius);
  query.algorithm = options.algorithm;
  refuse_shared_files(files_of_map(options.map), {{"--svg", options.svg}, {"--geojson", options.geojson}});
  const Scene scene = load_scene(options.map);
  OutputFile svg(options.svg);
  OutputFile geojson(options.geojson);
  const SvgOptions picture = svg_options(options.picture, scene.domain, title_of(options.map), scene.y_down);
  const World world = build_world(scene, options.map, query.agent.radius);

  const Result<Path> searched = world.find_path(query);
  if (!searched.ok()) throw Failure(fmt::format("waywright: path: {}", searched.error().message()));
  StreamWriter output(stream_beside({options.svg, options.geojson}));
  output.write_line(json_line({"path", {}}, *searched));
  output.flush();
  if (svg.wanted()) {
    SvgOverlay overlay;
    add_answer(overlay, query, *searched);
    svg.write(draw(world, overlay, picture));
  }
  if (geojson.wanted()) {
    formats::GeoJsonWriter writer(scene.domain, scene.y_down);
    writer.add_path(query.start, query.goal, *searched);
    geojson.write(writer.take());
  }
  svg.commit();
  geojson.commit();
  return kDone;
}

}  // namespace waywright::command
